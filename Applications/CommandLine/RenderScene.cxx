#include "RenderScene.h"

#include "Failure.h"
#include "PictureFile.h"
#include "Session.h"
#include "StereoRig.h"
#include "VtkMessages.h"
#include "Windows.h"
#include "vtkHaspStereoPicture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <chrono>
#include <optional>

namespace hasp
{
namespace
{

constexpr int MostFrames = 200; // that a picture is refined for

} // namespace

struct RenderScene::Parts
{
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHaspStereoPicture> picture;
  std::optional<SurfaceScene> scene;
  Session* session = nullptr;

  void OpenWindow(const RenderOptions& options)
  {
    ChooseWindows();
    this->window = vtkSmartPointer<vtkRenderWindow>::New();
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(options.resolution[0], options.resolution[1]);
    this->window->AddRenderer(this->renderer);
    RequireOpenGL(this->window);
  }
};

RenderScene::RenderScene(vtkDataObject* volume, const RenderOptions& options, Session& session)
  : Self(std::make_unique<Parts>())
{
  Parts& self = *this->Self;
  self.session = &session;
  self.OpenWindow(options);
  self.scene.emplace(self.renderer, volume, options, session);
  self.picture->SetRenderer(self.renderer);
  self.picture->SetLayout(options.stereo);
  self.picture->SetEyeAngle(options.eyeAngle);
}

RenderScene::~RenderScene() = default;

std::string RenderScene::DrawPng()
{
  Parts& self = *this->Self;
  self.session->progress.Step("drawing");
  const auto start = std::chrono::steady_clock::now();
  vtkSmartPointer<vtkImageData> picture;
  int frames = 0;
  for (bool more = true; more; ++frames)
  {
    picture = self.picture->Render();
    more = self.scene->WantsFrame(MostFrames);
    self.session->progress.Share(self.scene->ShareDrawn());
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  if (!picture)
    throw Failure(ExitCode::CannotDraw, "cannot draw: the window gave no picture");
  ResourceList& resources = self.session->resources;
  self.scene->ListResources(resources);
  resources.push_back(
    { "picture", static_cast<std::size_t>(picture->GetNumberOfPoints()) * 3, spent.count(),
      "all eyes, frames of each: " + std::to_string(frames) + "; shaders and uploads count here" });
  self.picture->ListResources(resources);
  return PngFile(picture);
}

} // namespace hasp
