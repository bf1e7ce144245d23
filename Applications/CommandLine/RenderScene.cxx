#include "RenderScene.h"

#include "Failure.h"
#include "PictureFile.h"
#include "Session.h"
#include "StereoView.h"
#include "VtkMessages.h"
#include "Windows.h"

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
  std::optional<SurfaceScene> scene;
  std::unique_ptr<StereoView> view;
  Session* session = nullptr;

  void OpenWindow(const RenderOptions& options)
  {
    ChooseWindows();
    this->window = vtkSmartPointer<vtkRenderWindow>::New();
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    const auto size =
      WindowPixels(MakeStereoWindow(options.stereo), options.resolution, options.squarePixels);
    this->window->SetSize(size[0], size[1]);
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
  SceneOptions scene = options;
  if (options.stereo.Any())
    scene.camera.aspect = EyeAspect(MakeStereoWindow(options.stereo), options.resolution);
  self.scene.emplace(self.renderer, volume, scene, session);
  self.view = std::make_unique<StereoView>(self.renderer, self.window, options.stereo);
}

RenderScene::~RenderScene() = default;

std::string RenderScene::DrawPng()
{
  Parts& self = *this->Self;
  self.session->progress.Step("drawing");
  const auto start = std::chrono::steady_clock::now();
  self.scene->SetFrameProgress([&](double share) { self.session->progress.Share(share); });
  int frames = 0;
  for (bool more = true; more; ++frames)
  {
    self.view->Draw(0.0);
    more = self.scene->WantsFrame(MostFrames);
    self.session->progress.Share(self.scene->ShareDrawn());
  }
  self.scene->SetFrameProgress({});
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  const auto picture = WindowPicture(self.window);
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  ResourceList& resources = self.session->resources;
  self.scene->ListResources(resources);
  resources.push_back(
    { "picture", static_cast<std::size_t>(picture->GetNumberOfPoints()) * 3, spent.count(),
      "all eyes, frames of each: " + std::to_string(frames) + "; shaders and uploads count here" });
  self.view->ListResources(resources);
  return PngFile(picture);
}

std::string RenderScene::SketchPng() const
{
  return this->Self->view->SketchPng(this->Self->scene->Content());
}

} // namespace hasp
