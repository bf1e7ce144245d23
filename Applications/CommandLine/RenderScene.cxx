#include "RenderScene.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "StereoLayout.h"
#include "StereoRig.h"
#include "SurfaceActors.h"
#include "VtkMessages.h"
#include "Windows.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspStereoPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>

namespace hasp
{
namespace
{

// Guides and implants beside bone: told apart by colour-blind readers too.
constexpr std::array<std::array<double, 3>, 4> SurfaceColors{ { { 0.35, 0.70, 0.90 },
  { 0.90, 0.62, 0.00 }, { 0.00, 0.62, 0.45 }, { 0.80, 0.47, 0.65 } } };

constexpr int AmbientFrames = 16; // until openness has added up: half the noise of one

/// A lamp to the upper left of the viewer, which stays there for both eyes, before the headlight.
void AddLamp(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double at[3], to[3], up[3], right[3];
  camera->GetPosition(at);
  camera->GetFocalPoint(to);
  camera->OrthogonalizeViewUp();
  camera->GetViewUp(up);
  vtkMath::Cross(camera->GetDirectionOfProjection(), up, right);
  const double far = camera->GetDistance();
  for (int a = 0; a < 3; ++a)
    at[a] += far * (0.7 * up[a] - 0.6 * right[a]);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(at);
  lamp->SetFocalPoint(to);
  lamp->SetIntensity(0.8);
  renderer->AddLight(lamp);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.3);
  renderer->AddLight(head);
}

void Shade(vtkActor* actor, const std::array<double, 3>& color)
{
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetSpecular(0.2);
  property->SetSpecularPower(20);
}

// Frames that a picture is refined for, and how many may find nothing new before it is taken to be
// complete.
constexpr int MostFrames = 200, QuietFrames = 4;

} // namespace

struct RenderScene::Parts
{
  vtkSmartPointer<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHaspStereoPicture> picture;
  std::vector<SurfaceActor> surfaces;
  Session* session = nullptr;
  int frames = 1;

  void Add(SurfaceActor surface, const std::array<double, 3>& color)
  {
    Shade(surface.actor, color);
    this->renderer->AddActor(surface.actor);
    this->surfaces.push_back(std::move(surface));
  }
  bool MayRefine() const
  {
    return std::any_of(this->surfaces.begin(), this->surfaces.end(),
      [](const SurfaceActor& surface) { return bool(surface.refining); });
  }
  bool Refining() const
  {
    return std::any_of(this->surfaces.begin(), this->surfaces.end(),
      [](const SurfaceActor& surface) { return surface.refining && surface.refining(); });
  }
  void OpenWindow(const RenderOptions& options)
  {
    ChooseWindows();
    this->window = vtkSmartPointer<vtkRenderWindow>::New();
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(options.resolution[0], options.resolution[1]);
    this->window->AddRenderer(this->renderer);
    if (auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(this->window))
      openGL->Initialize();
    ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
    if (!this->window->SupportsOpenGL())
      throw Failure(ExitCode::CannotDraw, "cannot draw: OpenGL 3.2 or later is needed");
  }
};

RenderScene::RenderScene(vtkDataObject* volume, const RenderOptions& options, Session& session)
  : Self(std::make_unique<Parts>())
{
  Parts& self = *this->Self;
  self.session = &session;
  self.OpenWindow(options);
  self.renderer->SetBackground(options.background.data());
  if (auto* cells = vtkHaspClusteredCells::SafeDownCast(volume))
    self.Add(MakeCells(cells, options.cells), options.color);
  else
    self.Add(MakeIsosurface(vtkImageData::SafeDownCast(volume), options.isoValue, options.mapper,
               options.cells, session),
      options.color);
  for (std::size_t k = 0; k < options.surfaces.size(); ++k)
    self.Add(
      MakeSurface(options.surfaces[k], k + 1, session), SurfaceColors[k % SurfaceColors.size()]);
  if (options.surfaces.empty())
    session.resources.push_back({ "surfaces", 0, 0.0, "no --surface was given" });
  PlaceCamera(self.renderer, options.camera);
  if (options.cells.shadows)
    AddLamp(self.renderer);
  if (options.cells.ambientOcclusionMm)
    self.frames = AmbientFrames;
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
  vtkSmartPointer<vtkImageData> picture = self.picture->Render();
  for (int frame = 1; frame < self.frames; ++frame)
    picture = self.picture->Render();
  for (int quiet = 0, frame = 1; quiet < QuietFrames && frame < MostFrames && self.MayRefine();
       ++frame)
  {
    picture = self.picture->Render();
    quiet = self.Refining() ? 0 : quiet + 1;
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw");
  if (!picture)
    throw Failure(ExitCode::CannotDraw, "cannot draw: the window gave no picture");
  ResourceList& resources = self.session->resources;
  for (const SurfaceActor& surface : self.surfaces)
    surface.listResources(resources);
  resources.push_back({ "picture", static_cast<std::size_t>(picture->GetNumberOfPoints()) * 3,
    spent.count(), "all eyes, all frames: shaders and uploads count here" });
  self.picture->ListResources(resources);

  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  ThrowVtkError(ExitCode::CannotDraw, "cannot encode the picture");
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

} // namespace hasp
