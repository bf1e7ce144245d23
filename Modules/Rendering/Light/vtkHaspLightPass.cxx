#include "vtkHaspLightPass.h"

#include "Grid/Stopwatch.h"
#include "Light/ProgressivePaths.h"
#include "Light/SceneLightCache.h"
#include "LightPicture.h"
#include "LitActors.h"
#include "LitSurroundings.h"

#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkHardwareSelector.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"
#include "vtkWeakPointer.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>

vtkStandardNewMacro(vtkHaspLightPass);

namespace
{

constexpr double SlackOfSamples = 4.0; // pixels: half of one, on slopes of up to 83 degrees
constexpr int StillFrames = 64;        // after which light that is kept is taken to be settled
constexpr int KeptFrames = 4; // of a view at rest that is path traced; then its paths are better
constexpr float KeptSamples = 16.0F; // what it counts for beside paths of a pixel's own

LightViewport ViewportOf(vtkRenderer* renderer)
{
  LightViewport viewport;
  renderer->GetTiledSizeAndOrigin(
    &viewport.size.x, &viewport.size.y, &viewport.origin.x, &viewport.origin.y);
  return viewport;
}

hasp::PictureView ViewOf(vtkRenderer* renderer, const LightViewport& viewport)
{
  vtkMatrix4x4 *view, *projection, *clip; // column-major memory, for OpenGL
  vtkMatrix3x3* normal;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, view, normal, projection, clip);
  return { glm::make_mat4(clip->GetData()), viewport.size, {} };
}

} // namespace

/// Draws what is opaque, and then its light.
class vtkHaspLightPass::Opaque : public vtkOpaquePass
{
public:
  static Opaque* New();
  vtkTypeMacro(Opaque, vtkOpaquePass);
  vtkHaspLightPass* Owner = nullptr;

  void Render(const vtkRenderState* state) override
  {
    const bool ready = this->Owner->IsMine(state->GetRenderer()) &&
                       this->Owner->Try(&vtkHaspLightPass::KeepBehind, state);
    this->Superclass::Render(state);
    if (ready)
      this->Owner->Try(&vtkHaspLightPass::Compose, state);
  }
};
vtkStandardNewMacro(vtkHaspLightPass::Opaque);

/// A selection: the selector draws the props itself.
class vtkHaspLightPass::Selection : public vtkRenderPass
{
public:
  static Selection* New();
  vtkTypeMacro(Selection, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->NumberOfRenderedProps = state->GetRenderer()->GetSelector()->Render(
      state->GetRenderer(), state->GetPropArray(), state->GetPropArrayCount());
  }
};
vtkStandardNewMacro(vtkHaspLightPass::Selection);

struct vtkHaspLightPass::Internals
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<Opaque> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkSmartPointer<vtkDualDepthPeelingPass> peeling;
  vtkSmartPointer<vtkOrderIndependentTranslucentPass> sums;

  LitActors actors;
  LitSurroundings surroundings;
  std::shared_ptr<const hasp::LitScene> scene;
  hasp::SceneLightCache kept;
  hasp::ProgressivePaths paths;
  hasp::PathTracedPicture traced;

  hasp::PictureView view;                     ///< of the last picture
  std::optional<hasp::ProgressiveWork> begun; ///< what paths work at
  std::vector<float> depths;
  double slack = 0.0; ///< pixels by which they may lie beside a pixel's centre
  hasp::LitPicture light;
  hasp::LitPicture seen;         ///< what is kept, beside paths
  std::vector<float> seenDepths; ///< of what was drawn then
  LightPicture picture;
  /// What the last picture was asked to be.
  struct Wish
  {
    int mode = -1;
    hasp::SceneLightRequest request;
    bool temporal = false;
    bool operator==(const Wish&) const = default;
  } wish;
  int still = 0; ///< pictures of the same view, wish and scene
  double milliseconds = 0.0;
  vtkWeakPointer<vtkRenderer> owner, refused;
  std::string complaint;
};

vtkHaspLightPass::vtkHaspLightPass() : Internal(new Internals)
{
  this->Internal->opaque->Owner = this;
  this->Internal->steps->SetOpaquePass(this->Internal->opaque);
}

vtkHaspLightPass::~vtkHaspLightPass() = default;

void vtkHaspLightPass::SetAmbientOcclusionDistance(double mm)
{
  if (!(mm > 0.0))
  {
    vtkErrorMacro("AmbientOcclusionDistance " << mm << " must be above 0 mm");
    return;
  }
  if (this->AmbientOcclusionDistance != mm)
  {
    this->AmbientOcclusionDistance = mm;
    this->Modified();
  }
}

void vtkHaspLightPass::Render(const vtkRenderState* state)
{
  Internals& in = *this->Internal;
  if (state->GetRenderer()->GetSelector())
  {
    vtkNew<vtkCameraPass> camera;
    vtkNew<Selection> selection;
    camera->SetDelegatePass(selection);
    camera->Render(state);
    this->NumberOfRenderedProps = camera->GetNumberOfRenderedProps();
    return;
  }
  in.steps->SetTranslucentPass(this->Translucency(state));
  in.steps->Render(state);
  this->NumberOfRenderedProps = in.steps->GetNumberOfRenderedProps();
}

/// That the renderer asks for; passes are made when they are first wanted.
vtkRenderPass* vtkHaspLightPass::Translucency(const vtkRenderState* state)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = state->GetRenderer();
  bool any = false;
  for (int n = 0; n < state->GetPropArrayCount() && !any; ++n)
    any = state->GetPropArray()[n]->HasTranslucentPolygonalGeometry() != 0;
  if (!any)
    return in.translucent;
  if (!renderer->GetUseDepthPeeling())
  {
    if (!in.sums)
    {
      in.sums = vtkSmartPointer<vtkOrderIndependentTranslucentPass>::New();
      in.sums->SetTranslucentPass(in.translucent);
    }
    return in.sums;
  }
  if (!in.peeling)
  {
    in.peeling = vtkSmartPointer<vtkDualDepthPeelingPass>::New();
    in.peeling->SetTranslucentPass(in.translucent);
  }
  in.peeling->SetMaximumNumberOfPeels(renderer->GetMaximumNumberOfPeels());
  in.peeling->SetOcclusionRatio(renderer->GetOcclusionRatio());
  return in.peeling;
}

/// False, and said once, in a second renderer.
bool vtkHaspLightPass::IsMine(vtkRenderer* renderer)
{
  Internals& in = *this->Internal;
  if (!in.owner || in.owner == renderer || in.owner->GetPass() != this)
  {
    in.owner = renderer;
    return true;
  }
  if (in.refused != renderer)
    vtkErrorMacro("Light is not drawn: another renderer has this pass; give each one of its own");
  in.refused = renderer;
  return false;
}

/// A step of a frame; false, and said once, where it fails.
bool vtkHaspLightPass::Try(
  void (vtkHaspLightPass::*step)(const vtkRenderState*), const vtkRenderState* state)
{
  try
  {
    (this->*step)(state);
    return true;
  }
  catch (const std::exception& e)
  {
    this->Internal->paths.Release();
    this->Internal->begun.reset();
    this->Internal->traced = {};
    this->Internal->still = 0;
    if (this->Internal->complaint != e.what())
      vtkErrorMacro("Light is not drawn: " << e.what());
    this->Internal->complaint = e.what();
    return false;
  }
}

/// The background lies behind smooth edges.
void vtkHaspLightPass::KeepBehind(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const LightViewport viewport = ViewportOf(renderer);
  if (this->Mode != PathTraced)
    this->Internal->picture.ReleaseBehind();
  else if (window && !viewport.Empty())
    this->Internal->picture.KeepBehind(window, viewport);
}

/// The scene of this frame's actors and its light, over what was drawn.
void vtkHaspLightPass::Compose(const vtkRenderState* state)
{
  const hasp::Stopwatch watch;
  Internals& in = *this->Internal;
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const LightViewport viewport = ViewportOf(renderer);
  if (!window || viewport.Empty())
    return;
  const bool paths = this->Mode == Traced || this->Mode == PathTraced;
  if (!paths)
    in.surroundings.Release();
  const std::shared_ptr<const hasp::Environment> far =
    paths ? in.surroundings.Of(renderer, this->EnvironmentFileName) : LitSurroundings::None();
  auto lamps =
    !paths || this->LampsInPaths ? LampsOf(renderer, paths) : std::vector<hasp::LitLamp>();
  const float exposure = !paths                 ? 1.0F
                         : this->Exposure > 0.0 ? static_cast<float>(this->Exposure)
                                                : ExposureFor(*far, lamps);
  in.actors.Update(renderer->GetViewProps(), paths, 1.0 / exposure);
  const bool sameScene = in.scene && in.scene->SharedSurroundings() == far &&
                         in.scene->Lamps() == lamps &&
                         AreSame(in.scene->Bodies(), in.actors.Bodies());
  if (!sameScene)
    in.scene = std::make_shared<const hasp::LitScene>(in.actors.Bodies(), std::move(lamps), far);
  const hasp::PictureView view = ViewOf(renderer, viewport);
  const Internals::Wish wish{ this->Mode, this->Request(), this->TemporalAccumulation };
  const bool same = sameScene && view == in.view && wish == in.wish && in.still > 0;
  in.view = view;
  in.wish = wish;
  in.still = same ? in.still + 1 : 1;

  in.slack = ReadDepths(viewport, in.depths) > 1 ? SlackOfSamples : 0.0;
  if (this->Mode == PathTraced)
    this->TracePaths(window, same);
  else
  {
    in.paths.Release();
    in.begun.reset();
    in.traced = {};
    in.seen = hasp::LitPicture(); // {} would keep its memory
    in.seenDepths = std::vector<float>();
    in.kept.Light(*in.scene, view, { in.depths, in.slack }, this->Request(), in.light);
  }
  in.picture.Draw(window, viewport, in.light, exposure, paths);
  in.complaint.clear();
  in.milliseconds = watch.Milliseconds();
}

hasp::SceneLightRequest vtkHaspLightPass::Request() const
{
  using Kind = hasp::SceneLightRequest::Kind;
  hasp::SceneLightRequest request;
  request.kind = this->Mode == Lamps              ? Kind::Lamps
                 : this->Mode == AmbientOcclusion ? Kind::AmbientOcclusion
                                                  : Kind::Traced;
  request.shadows = this->Shadows || this->Mode == PathTraced; // its paths always cast them
  request.distanceMm = this->AmbientOcclusionDistance;
  request.paths.bounces = this->Bounces;
  return request;
}

/// Paths of each pixel, begun anew where the view or the scene is another, and what is kept as far
/// as that is wanted.
void vtkHaspLightPass::TracePaths(vtkRenderWindow* window, bool same)
{
  Internals& in = *this->Internal;
  hasp::ProgressiveWork work{ in.scene, in.view, { { this->Bounces }, 0, true },
    this->SamplesPerPixel };
  const bool begun = same && in.begun && work.samples == in.begun->samples;
  if (!begun)
  {
    in.paths.Cancel(); // its rays would take the cores from what follows
    in.traced = {};
  }
  hasp::SceneLightRequest request = this->Request();
  if (!this->TemporalAccumulation)
    request.kind = hasp::SceneLightRequest::Kind::Coverage;
  // Who takes no part may come and go before the rest.
  if (!begun || (this->TemporalAccumulation && in.still <= KeptFrames) ||
      in.depths != in.seenDepths)
  {
    in.kept.Light(*in.scene, in.view, { in.depths, in.slack }, request, in.seen);
    in.seenDepths = in.depths;
  }
  if (!begun)
  {
    in.begun.reset();
    in.paths.Start(work);
    in.begun = std::move(work);
  }
  for (int n = 0; this->WaitForSamples && in.paths.Running() && n < this->SamplesPerPixel &&
                  window->CheckAbortStatus() == 0;)
  {
    in.paths.WaitFor(n + 1);
    n = std::max(n + 1, in.paths.Samples());
    double share = double(n) / this->SamplesPerPixel;
    this->InvokeEvent(vtkCommand::ProgressEvent, &share);
  }
  in.paths.Latest(in.traced);
  this->MixPaths();
}

/// What paths found, and what is kept as if it were so many of them. Where something was drawn,
/// what they do not cover shows the background.
void vtkHaspLightPass::MixPaths()
{
  Internals& in = *this->Internal;
  const float kept = this->TemporalAccumulation ? KeptSamples : 0.0F;
  const auto own = static_cast<float>(in.traced.samples);
  in.light.assign(in.seen.size(), glm::vec4(0.0F));
  if (!(kept + own > 0.0F))
    return;
  for (std::size_t n = 0; n < in.light.size(); ++n)
  {
    const bool drawn = in.depths[n] < 1.0F;
    if (in.seen[n].a == 0.0F && drawn)
      continue; // of somebody who takes no part
    const glm::vec4 traced = own > 0.0F ? in.traced.Pixel(n) : glm::vec4(0.0F);
    in.light[n] = (kept * in.seen[n] + own * traced) / (kept + own);
    // With several samples a pixel, the depth is one's and others may have been drawn.
    if (drawn || (in.slack > 0.0 && traced.a > 0.0F))
      in.light[n].a += LightPicture::ShowsBehind;
  }
}

bool vtkHaspLightPass::IsRefining() const
{
  const Internals& in = *this->Internal;
  return !in.complaint.empty()      ? false // another frame says the same
         : this->Mode == PathTraced ? in.traced.samples < this->SamplesPerPixel
         : this->Mode == Lamps      ? false
                                    : in.still < StillFrames;
}

int vtkHaspLightPass::GetSamples() const
{
  return this->Internal->traced.samples;
}

void vtkHaspLightPass::ListResources(hasp::ResourceList& list) const
{
  const Internals& in = *this->Internal;
  const bool paths = this->Mode == Traced || this->Mode == PathTraced;
  list.push_back({ "light, trees", in.actors.TreeBytes(), in.actors.TreeMilliseconds(),
    std::to_string(in.actors.Bodies().size()) + " bodies; " + std::to_string(in.actors.LeftOut()) +
      " opaque actors left as drawn" });
  list.push_back(
    { "light, environment", in.surroundings.Bytes(), paths ? in.surroundings.Milliseconds() : 0.0,
      !paths                               ? "lamps alone"
      : !this->EnvironmentFileName.empty() ? "of a file"
                                           : "the renderer's, or daylight" });
  list.push_back({ "light, kept", in.kept.Bytes(), 0.0,
    this->Mode == Lamps                                       ? "lamps need none"
    : this->Mode == PathTraced && !this->TemporalAccumulation ? "no TemporalAccumulation"
                                                              : "on surfaces, for all views" });
  list.push_back({ "light, paths", in.paths.Bytes(), 0.0,
    this->Mode == PathTraced ? std::to_string(in.traced.samples) + " samples a pixel"
                             : "not PathTraced: no thread" });
  list.push_back({ "light, picture",
    in.picture.Bytes() + (in.light.size() + in.seen.size()) * sizeof(glm::vec4) +
      (in.depths.size() + in.seenDepths.size()) * sizeof(float) + in.traced.Bytes(),
    in.milliseconds, "of the last frame" });
}

void vtkHaspLightPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.steps->ReleaseGraphicsResources(window);
  if (in.peeling)
    in.peeling->ReleaseGraphicsResources(window);
  if (in.sums)
    in.sums->ReleaseGraphicsResources(window);
  in.picture.Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkHaspLightPass::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const names[] = { "lamps", "ambient occlusion", "traced", "path traced" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << names[this->Mode] << "\n";
  os << indent << "Shadows: " << this->Shadows << "\n";
  os << indent << "AmbientOcclusionDistance: " << this->AmbientOcclusionDistance << " mm\n";
  os << indent << "Bounces: " << this->Bounces << "\n";
  os << indent << "EnvironmentFileName: " << (this->EnvironmentFileName.empty() ? "none" : "given")
     << "\n";
  os << indent << "LampsInPaths: " << this->LampsInPaths << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "SamplesPerPixel: " << this->SamplesPerPixel << "\n";
  os << indent << "WaitForSamples: " << this->WaitForSamples << "\n";
  os << indent << "TemporalAccumulation: " << this->TemporalAccumulation << "\n";
}
