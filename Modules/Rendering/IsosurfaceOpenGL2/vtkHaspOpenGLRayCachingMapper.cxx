#include "vtkHaspOpenGLRayCachingMapper.h"

#include "CachedLevels.h"
#include "CellScene.h"
#include "CellTracing.h"
#include "ErrorListener.h"
#include "Grid/Stopwatch.h"
#include "HaspGL.h"
#include "Isosurface/RayCache.h"
#include "MappedVolume.h"
#include "OpenGLVersion.h"
#include "ViewerEyes.h"
#include "VolumeRaycasts.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspOpenGLRayCachingMapper);

namespace
{

/// Beyond what samples can be nothing is met; cells know floats.
double FloatRange(double isovalue)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return std::isnan(isovalue) ? isovalue : std::clamp(isovalue, -largest, largest);
}

} // namespace

struct vtkHaspOpenGLRayCachingMapper::OpenGL
{
  vtkMTimeType VolumeTime = 0; ///< of the image that all of this was made from
  double IsoValue = std::numeric_limits<double>::quiet_NaN();
  bool Unlit = false;                   ///< the last frame lacked the light that was asked for
  bool StoodIn = false;                 ///< that cells stand in for a raycast has been said
  bool Partial = false;                 ///< the last picture is of a translucent front alone
  bool Changed = false;                 ///< volume or isovalue, since the last frame
  double CacheUpdateMilliseconds = 0.0; ///< what that cost the cache
  vtkNew<ErrorListener> Errors;         ///< of the mappers inside
  std::string Drew = "nothing drawn";
  std::string Share;     ///< of the cache in the last picture
  std::string Complaint; ///< said last, and not again while it stays the same

  std::unique_ptr<hasp::RayCache> Cache;
  double CacheMilliseconds = 0.0;
  hasp::RayCache::Frame Last;
  double SampleMilliseconds = 0.0;
  CachedLevels Levels{ this->Errors };
  ViewerEyes Eyes;
  vtkSmartPointer<vtkHaspClusteredCellMapper> Whole; ///< all active cells
  VolumeRaycasts Raycasts;

  void ForgetCache()
  {
    this->Cache.reset();
    this->Last = {};
    this->Levels.Clear();
    this->Eyes.Forget();
  }
  /// 0 where they are not known.
  std::size_t ActiveCells() const { return this->Whole ? this->Whole->GetCells().Count() : 0; }
  /// Nothing can be drawn.
  void ForgetAll()
  {
    this->ForgetCache();
    this->Whole = nullptr;
    this->Raycasts.Clear();
    this->Drew = "nothing drawn";
    this->Share.clear();
  }
};

/// What the passes of a frame share.
struct vtkHaspOpenGLRayCachingMapper::Pass
{
  vtkRenderer* renderer;
  vtkActor* actor;
  ViewerEye& eye;
  bool begins; ///< the first one of its eye in this frame
  bool translucent;
};

vtkHaspOpenGLRayCachingMapper::vtkHaspOpenGLRayCachingMapper() : GL(new OpenGL) {}
vtkHaspOpenGLRayCachingMapper::~vtkHaspOpenGLRayCachingMapper() = default;

void vtkHaspOpenGLRayCachingMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->GL->Levels.Release(window);
  if (this->GL->Whole)
    this->GL->Whole->ReleaseGraphicsResources(window);
  this->GL->Raycasts.Release(vtkOpenGLRenderWindow::SafeDownCast(window));
}

std::string vtkHaspOpenGLRayCachingMapper::GetModeChoice() const
{
  return this->GL->Drew;
}

void vtkHaspOpenGLRayCachingMapper::SetRenderer(int renderer)
{
  if (renderer == vtkHaspClusteredCellMapper::Trace && !CellTracing::Available())
    vtkErrorMacro("Rays cannot be traced: this build of Hasp was made without Embree; configure it "
                  "with HASP_ENABLE_EMBREE=ON (Debian: libembree-dev).");
  else if (renderer != this->GetRenderer())
  {
    this->Superclass::SetRenderer(renderer);
    this->GL->Eyes.ForgetChoices(); // they were measured with another
  }
}

bool vtkHaspOpenGLRayCachingMapper::IsRefining() const
{
  // A mapper without input is not rendered, so that nobody would say that it has come to rest.
  return this->GL->Eyes.Refining() &&
         const_cast<vtkHaspOpenGLRayCachingMapper*>(this)->GetImage() != nullptr;
}

/// Brings what was made of the volume up to date with it and with the isovalue.
void vtkHaspOpenGLRayCachingMapper::UpdateCache()
{
  OpenGL& gl = *this->GL;
  MappedVolume& volume = this->GetVolume();
  const bool another = gl.VolumeTime != this->GetVolumeTime();
  gl.Changed = another || gl.IsoValue != this->GetIsoValue() || volume.Changed();
  gl.CacheUpdateMilliseconds = 0.0;
  if (another)
  {
    gl.ForgetCache();
    gl.Eyes.ForgetChoices();
    gl.VolumeTime = this->GetVolumeTime();
  }
  if (gl.Changed)
    gl.Eyes.Unfill();
  gl.IsoValue = this->GetIsoValue();
  if (!volume.Changed())
    return;
  const glm::ivec3 low = volume.ChangedLow(), high = volume.ChangedHigh();
  volume.Blocks.Update(hasp::ViewImage(this->GetImage()), low, high);
  if (gl.Cache)
  {
    const hasp::Stopwatch watch;
    gl.Cache->MarkModified(low, high);
    gl.CacheUpdateMilliseconds = watch.Milliseconds();
  }
  gl.Raycasts.MarkModified(low, high);
  if (gl.Whole && !another) // else it sees itself that all is to be read
  {
    const int* extent = this->GetImage()->GetExtent();
    int box[6];
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = extent[2 * a] + low[a];
      box[2 * a + 1] = extent[2 * a] + high[a];
    }
    gl.Whole->MarkModified(box);
  }
  volume.ForgetChanges();
}

void vtkHaspOpenGLRayCachingMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
    return;
  window->MakeCurrent(); // not every window brings the last context back
  OpenGL& gl = *this->GL;
  if (!this->UpdateVolume())
    return gl.ForgetAll();
  try
  {
    this->UpdateCache();
    const bool raycast = this->Mode == Raycast || this->Mode == RaycastSkipping;
    const std::string lack =
      raycast ? OpenGLVersion::OfCurrentContext().Lack("raycasting") : std::string();
    const bool lit = this->AmbientOcclusion || this->Shadows,
               unlit = lit && this->Mode != Automatic && lack.empty();
    if (unlit && !gl.Unlit)
      vtkErrorMacro("Ambient occlusion and shadows are not drawn, for they take traced rays: set "
                    "the mode to Automatic.");
    gl.Unlit = unlit;
    if (!raycast)
      gl.StoodIn = false;
    if (!lack.empty())
      this->DrawStandIn(renderer, actor, lack);
    else if (raycast)
      this->DrawRaycast(renderer, actor);
    else
    {
      bool begins = false;
      ViewerEye& eye = gl.Eyes.Of(renderer, actor, begins);
      this->DrawCells(
        { renderer, actor, eye, begins, bool(actor->IsRenderingTranslucentPolygonalGeometry()) },
        lit);
    }
    gl.Complaint.clear();
    if (const std::string said = gl.Errors->Take(); !said.empty())
      vtkErrorMacro(<< said);
  }
  catch (const std::exception& e)
  {
    gl.ForgetAll();
    if (gl.Complaint != e.what())
      vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    gl.Complaint = e.what();
  }
}

/// Those of the cache, or all active ones, or both where they are to be compared. What no later
/// frame can want is not kept.
void vtkHaspOpenGLRayCachingMapper::DrawCells(const Pass& pass, bool lit)
{
  OpenGL& gl = *this->GL;
  gl.Raycasts.Clear();
  const bool automatic = this->Mode == Automatic && !lit;
  const bool timed = automatic && pass.begins && !pass.translucent;
  CacheProgress& progress = pass.eye.Progress;
  ViewerEye& chooses = gl.Eyes.FirstOf(pass.eye);
  // The second eye's frame is as new as the first one's.
  const bool changed = gl.Changed || (&chooses != &pass.eye && chooses.Changed);
  if (pass.begins)
    pass.eye.Changed = gl.Changed;
  DrawingChoice& choice = chooses.Choice;
  const bool measured = timed && &chooses == &pass.eye;
  const int* size = pass.renderer->GetSize();
  if (measured)
    choice.Begin(std::size_t(size[0]) * std::size_t(size[1]), gl.ActiveCells());
  const DrawingChoice::Frame frame = this->Mode == Cache ? DrawingChoice::Frame{ true, true, false }
                                     : lit || pass.translucent
                                       ? DrawingChoice::Frame{ false, false, true }
                                     : timed ? choice.Next(changed, progress.Filled())
                                             : choice.Untimed(progress.Filled());
  if (const bool partial = frame.cache && pass.translucent; partial != gl.Partial)
    if ((gl.Partial = partial))
      vtkWarningMacro("What rays meet first is drawn, not all layers: set the mode to Automatic.");
  if (frame.sample)
  {
    const hasp::Stopwatch watch;
    this->SampleCache(pass);
    if (frame.cache)
      this->DrawCache(pass);
    if (measured && frame.cache)
    {
      glFinish();
      choice.CacheTook(changed, watch.Milliseconds() + gl.CacheUpdateMilliseconds);
    }
  }
  if (frame.whole)
  {
    const hasp::Stopwatch watch;
    this->DrawWhole(pass.renderer, pass.actor);
    if (measured)
    {
      glFinish();
      choice.WholeTook(changed, watch.Milliseconds());
    }
  }
  if (pass.begins)
    progress.ShowsCache(!frame.whole);
  const DrawingChoice::Frame later = automatic ? gl.Eyes.MayDraw() : frame;
  gl.Share = frame.whole ? "; no pixel from the cache" : progress.ShareOfCache();
  gl.Drew = this->Mode == Cache ? "cache: asked for; " + gl.Levels.RendererText()
            : lit               ? "all active cells: ambient occlusion and shadows take traced rays"
                                : (frame.whole ? "all active cells: " : "cache: ") + choice.Text();
  if (!later.cache)
    gl.ForgetCache();
  if (!later.whole && !(frame.whole && pass.translucent)) // which takes them in every frame
    gl.Whole = nullptr;
}

/// All active cells, in a window that cannot raycast.
void vtkHaspOpenGLRayCachingMapper::DrawStandIn(
  vtkRenderer* renderer, vtkActor* actor, const std::string& lack)
{
  OpenGL& gl = *this->GL;
  gl.ForgetCache();
  gl.Eyes.ForgetChoices();
  const bool traceable = CellTracing::Available() &&
                         this->GetRenderer() != vtkHaspClusteredCellMapper::Rasterize &&
                         !actor->IsRenderingTranslucentPolygonalGeometry();
  if (traceable && !gl.StoodIn) // else they cannot be drawn either, and say so
    vtkWarningMacro("Active cells stand in, traced by rays on the CPU: "
                    << lack << ". Cell ids are theirs, not the image's.");
  gl.StoodIn |= traceable;
  this->DrawWhole(renderer, actor);
  gl.Drew = (traceable ? "all active cells: " : "nothing drawn: ") + lack;
  gl.Share = "; no pixel from the cache";
}

/// Nothing of the other modes is kept.
void vtkHaspOpenGLRayCachingMapper::DrawRaycast(vtkRenderer* renderer, vtkActor* actor)
{
  OpenGL& gl = *this->GL;
  gl.ForgetCache();
  gl.Eyes.ForgetChoices();
  gl.Whole = nullptr;
  const bool skipping = this->Mode == RaycastSkipping;
  gl.Raycasts.Draw({ hasp::ViewImage(this->GetImage()), this->GetVolume().Blocks,
                     this->GetVolumeTime(), this->GetIsoValue() },
    { skipping, this->StepSize }, this, renderer, actor);
  gl.Drew = skipping ? "raycast with skipping: asked for" : "raycast: asked for";
  gl.Share = "; no pixel from the cache";
  vtkOpenGLCheckErrorMacro("after raycasting");
}

void vtkHaspOpenGLRayCachingMapper::DrawWhole(vtkRenderer* renderer, vtkActor* actor)
{
  OpenGL& gl = *this->GL;
  if (!gl.Whole)
  {
    gl.Whole = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
    gl.Whole->AddObserver(vtkCommand::ErrorEvent, gl.Errors);
  }
  if (gl.Whole->GetImage() != this->GetImage())
    gl.Whole->SetInputData(this->GetImage());
  gl.Whole->SetIsoValue(FloatRange(this->GetIsoValue()));
  gl.Whole->SetClippingPlanes(this->GetClippingPlanes());
  gl.Whole->SetRenderer(this->GetRenderer());
  gl.Whole->SetAmbientOcclusion(this->AmbientOcclusion);
  gl.Whole->SetAmbientOcclusionDistance(this->AmbientOcclusionDistance);
  gl.Whole->SetShadows(this->Shadows);
  gl.Whole->Render(renderer, actor);
}

/// Rays of a frame, for the eye that begins it.
void vtkHaspOpenGLRayCachingMapper::SampleCache(const Pass& pass)
{
  OpenGL& gl = *this->GL;
  const hasp::AnyGridView grid = hasp::ViewImage(this->GetImage());
  const double isovalue = FloatRange(this->GetIsoValue());
  if (gl.Cache)
    gl.Cache->SetIsovalue(isovalue);
  else
  {
    const hasp::Stopwatch watch;
    gl.Cache = std::make_unique<hasp::RayCache>(grid, this->GetVolume().Blocks, isovalue);
    gl.CacheMilliseconds = watch.Milliseconds();
  }
  if (!pass.begins)
    return;
  const CellScene scene(this, hasp::GeometryOf(grid), isovalue, pass.renderer, pass.actor);
  ViewerEye& eye = pass.eye;
  const ViewerEye& first = gl.Eyes.FirstOf(eye);
  const bool served = &first != &eye && eye.ServedTurn == first.Turn;
  if (!served || gl.Changed)
    this->CastRays(pass, scene);
  else
  {
    gl.Last = {}; // the other eye's frame cast them
    gl.SampleMilliseconds = 0.0;
  }
  eye.Moved(scene.indexToClip);
  eye.ForgetDepth(); // until the cache is drawn again
}

/// For the eye that begins a frame, and where a second one follows it for that one, too: half each.
void vtkHaspOpenGLRayCachingMapper::CastRays(const Pass& pass, const CellScene& scene)
{
  OpenGL& gl = *this->GL;
  ViewerEye& eye = pass.eye;
  const hasp::Stopwatch watch;
  std::vector<hasp::SampledEye> seen{ { { scene.indexToClip, scene.viewportSize, scene.planes },
    eye.Depth(scene.viewportSize), eye.Number } };
  ViewerEye* second = gl.Eyes.SecondOf(eye);
  // VTK's own stereo does not say where the second eye will be.
  const auto beside = !second                  ? std::nullopt
                      : scene.otherIndexToClip ? scene.otherIndexToClip
                                               : second->Beside(eye, scene.indexToClip);
  if (beside)
  {
    const bool drawn = second->GetDepthSize() != glm::ivec2(0);
    const glm::ivec2 size = drawn ? second->GetDepthSize() : scene.viewportSize;
    seen.push_back({ { *beside, size, scene.planes }, second->Depth(size), second->Number });
  }
  std::vector<hasp::PictureView> predicted;
  if (const auto next = this->Prediction ? eye.Predict(scene.indexToClip) : std::nullopt)
    predicted.push_back({ *next, scene.viewportSize, scene.planes });
  const int rays = eye.Progress.RaysFor(this->FrameBudget, this->RaysPerTile);
  const bool split = beside && rays < CacheProgress::MostRays; // a ray a pixel completes a picture
  gl.Last = gl.Cache->Sample(seen, predicted, split ? (rays + 1) / 2 : rays);
  gl.SampleMilliseconds = watch.Milliseconds();
  eye.Progress.Sampled(gl.Last, rays, gl.SampleMilliseconds);
  if (!beside)
    return;
  second->ServedTurn = eye.Turn;
  second->Progress.Sampled(gl.Last, rays, gl.SampleMilliseconds);
}

void vtkHaspOpenGLRayCachingMapper::DrawCache(const Pass& pass)
{
  OpenGL& gl = *this->GL;
  const hasp::Stopwatch watch;
  for (int level = 0; level < gl.Cache->Levels(); ++level)
    gl.Levels.Set(level, gl.Cache->Cells(level));
  gl.Levels.Draw(this, pass.renderer, pass.actor);
  if (!pass.begins)
    return;
  if (!pass.translucent)
  {
    const CellScene scene(this, hasp::GeometryOf(hasp::ViewImage(this->GetImage())),
      this->GetIsoValue(), pass.renderer, pass.actor);
    pass.eye.ReadDepth(scene.viewportOrigin, scene.viewportSize);
  }
  pass.eye.Progress.Drawn(watch.Milliseconds());
}

void vtkHaspOpenGLRayCachingMapper::ListResources(hasp::ResourceList& list) const
{
  const std::size_t blocks = list.size(); // the first of ours
  this->Superclass::ListResources(list);
  const OpenGL& gl = *this->GL;
  list.push_back({ "drawn by", 0, 0.0, gl.Drew + gl.Share });
  list.push_back({ "ray cache", gl.Cache ? gl.Cache->Bytes() : 0, gl.CacheMilliseconds,
    gl.Cache ? std::to_string(gl.Cache->Live()) + " clusters; of fixed size"
             : "no frame was drawn from it" });
  list.push_back({ "cached cells, host", gl.Levels.Bytes(), gl.SampleMilliseconds,
    std::to_string(gl.Last.rays) + " rays in the last frame" });
  list.push_back({ "drawing of cached cells", gl.Levels.DrawingBytes(), gl.Levels.DrawMilliseconds,
    gl.Cache ? gl.Levels.RendererText() : "no frame was drawn from it" });
  list.push_back(
    { "depth of the last pictures", gl.Eyes.Bytes(), 0.0, "rays look for holes in it" });
  gl.Raycasts.ListResources(list);
  if (!gl.Whole)
    return list.push_back({ "active cells, host", 0, 0.0, "the cache was asked for" });
  hasp::ResourceList whole;
  gl.Whole->ListResources(whole);
  for (const hasp::ResourceUse& use : whole)
    if (use.resource != list[blocks].resource)
      list.push_back(use);
    else // it has its own, for the extraction
    {
      list[blocks].bytes += use.bytes;
      list[blocks].milliseconds += use.milliseconds;
    }
}
