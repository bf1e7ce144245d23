#include "SurfaceScene.h"

#include "Failure.h"
#include "Session.h"
#include "vtkHaspClusteredCells.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <limits>

namespace hasp
{
namespace
{

// Guides and implants beside bone: told apart by colour-blind readers too.
constexpr std::array<std::array<double, 3>, 4> SurfaceColors{ { { 0.35, 0.70, 0.90 },
  { 0.90, 0.62, 0.00 }, { 0.00, 0.62, 0.45 }, { 0.80, 0.47, 0.65 } } };

constexpr int AmbientFrames = 4; // until openness has added up: half the noise of one
constexpr int SharedFrames = 16; // the same of light that surfaces share: 4 rays a pixel and frame
constexpr int WindowFrames = 4;  // at rest after the last find, in which ways are compared
constexpr int FrameMs = 1;       // a timer's shortest: soon, after what else happens
constexpr int PathsMs = 100;     // of paths between two frames, which take cores from them
constexpr double Specular = 0.2, SpecularPower = 20.0;

/// A lamp to the upper left of the viewer, which stays there for both eyes, before the headlight,
/// if there is to be one: paths have light from everywhere, and one that moves with the camera
/// would leave nothing of what is kept.
void AddLamp(vtkRenderer* renderer, bool headlight)
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
  if (!headlight)
    return;
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.3);
  head->SetShadowAttenuation(0.0F); // it fills the lamp's shadows
  renderer->AddLight(head);
}

/// A volume is shaded as an actor is by default.
void Shade(vtkVolume* volume, const std::array<double, 3>& color)
{
  vtkVolumeProperty* property = volume->GetProperty();
  vtkNew<vtkColorTransferFunction> everywhere;
  everywhere->AddRGBPoint(0.0, color[0], color[1], color[2]);
  property->SetColor(everywhere);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(Specular);
  property->SetSpecularPower(SpecularPower);
}

void Shade(vtkProp3D* prop, const std::array<double, 3>& color)
{
  if (auto* volume = vtkVolume::SafeDownCast(prop))
    return Shade(volume, color);
  vtkProperty* property = vtkActor::SafeDownCast(prop)->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetSpecular(Specular);
  property->SetSpecularPower(SpecularPower);
}

/// Does VTK's ray caster draw it, from all samples on the GPU?
bool ShowsSamples(const std::string& mapper)
{
  const auto& names = VolumeMappers();
  return mapper == "vtk" || std::find(names.begin(), names.end(), mapper) != names.end();
}

void RequireSamplesFit(vtkDataObject* volume, vtkRenderer* renderer, const std::string& mapper)
{
  const std::string why = WhyTooLarge(vtkImageData::SafeDownCast(volume), renderer);
  if (!why.empty())
    throw Failure(
      ExitCode::CannotDraw, "--mapper " + mapper + ": " + why + ": crop it, or take --mapper mesh");
}

} // namespace

SurfaceScene::SurfaceScene(
  vtkRenderer* renderer, vtkDataObject* volume, const SceneOptions& options, Session& session)
  : Shown(renderer)
{
  renderer->SetBackground(options.background.data());
  const std::string& mapper = options.drawing.mapper;
  if (ShowsSamples(mapper))
    RequireSamplesFit(volume, renderer, mapper);
  else
    session.resources.push_back({ "volume, GPU", 0, 0.0, "--mapper " + mapper });
  SurfaceDrawing drawing = options.drawing;
  if (SharesLight(options.light, drawing, options.surfaces.size()))
  {
    this->Light = std::make_unique<SceneLight>(renderer, options.light, drawing);
    drawing.ambientOcclusionMm.reset(); // not twice
    drawing.shadows = false;
  }
  else
    session.resources.push_back({ "light of all surfaces", 0, 0.0, "each has its own" });
  if (auto* cells = vtkHaspClusteredCells::SafeDownCast(volume))
    this->Add(MakeCells(cells, drawing), options.color);
  else
    this->Add(MakeVolume(vtkImageData::SafeDownCast(volume), options.isoValue, drawing, session),
      options.color);
  for (std::size_t k = 0; k < options.surfaces.size(); ++k)
    this->Add(
      MakeSurface(options.surfaces[k], k + 1, session), SurfaceColors[k % SurfaceColors.size()]);
  if (options.surfaces.empty())
    session.resources.push_back({ "surfaces", 0, 0.0, "no --surface was given" });
  PlaceCamera(renderer, options.camera);
  if (options.drawing.shadows)
    AddLamp(renderer, !options.light.pathSamples);
  if (options.drawing.ambientOcclusionMm)
    this->LeastFrames = this->Light ? SharedFrames : AmbientFrames;
  if (options.drawing.interactive)
    this->QuietFrames = WindowFrames;
}

void SurfaceScene::Add(SurfaceActor surface, const std::array<double, 3>& color)
{
  surface.setColor ? surface.setColor(color) : Shade(surface.prop, color);
  this->Shown->AddViewProp(surface.prop);
  this->Surfaces.push_back(std::move(surface));
}

void SurfaceScene::SetIsoValue(double value)
{
  if (const auto& set = this->Surfaces.front().setIsoValue)
    set(value);
  this->Restart();
}

std::optional<WorldPoint> SurfaceScene::Pick(const WorldPoint& from, const WorldPoint& to) const
{
  std::optional<WorldPoint> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceActor& surface : this->Surfaces)
    if (const auto point = surface.pick ? surface.pick(from, to) : std::nullopt)
      if (const double distance = vtkMath::Distance2BetweenPoints(from.data(), point->data());
          distance < least)
      {
        least = distance;
        nearest = point;
      }
  return nearest;
}

std::optional<std::pair<WorldPoint, WorldPoint>> SurfaceScene::RayOf(int x, int y) const
{
  const auto world = [&](double depth)
  {
    this->Shown->SetDisplayPoint(x, y, depth);
    this->Shown->DisplayToWorld();
    const double* p = this->Shown->GetWorldPoint();
    return WorldPoint{ p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  };
  return std::pair{ world(0.0), world(1.0) };
}

std::optional<ContentBox> SurfaceScene::Content() const
{
  ContentBox content;
  vtkBoundingBox all;
  for (const SurfaceActor& surface : this->Surfaces)
    if (!surface.bounds)
    {
      content.ofVolume = true;
      all.AddBounds(surface.prop->GetBounds());
    }
    else if (const auto box = surface.bounds())
      all.AddBounds(box->data());
  if (!all.IsValid())
    return std::nullopt;
  all.GetBounds(content.bounds.data());
  return content;
}

void SurfaceScene::ListResources(ResourceList& list) const
{
  for (const SurfaceActor& surface : this->Surfaces)
    surface.listResources(list);
  if (this->Light)
    this->Light->ListResources(list);
}

void SurfaceScene::SetFrameProgress(std::function<void(double share)> progress)
{
  if (this->Light)
    this->Light->SetProgress(std::move(progress));
}

void SurfaceScene::SetWaitForPaths(bool wait)
{
  if (this->Light)
    this->Light->SetWaitForSamples(wait);
}

bool SurfaceScene::WantsFrame(int mostFrames)
{
  const bool paths = this->Light && this->Light->Refining();
  bool may = this->Light != nullptr, refining = false;
  for (const SurfaceActor& surface : this->Surfaces)
  {
    may |= bool(surface.refining);
    refining |= surface.refining && surface.refining();
  }
  this->NextMs = paths && !refining ? PathsMs : FrameMs;
  this->Quiet = refining || paths ? 0 : this->Quiet + 1;
  ++this->Frames;
  return this->Frames < this->LeastFrames ||
         (may && this->Quiet < this->QuietFrames && (this->Frames < mostFrames || paths));
}

} // namespace hasp
