#include "vtkHaspOpenGLRayCachingMapper.h"

#include "CachedLevels.h"
#include "CellScene.h"
#include "CellTracing.h"
#include "DrawingChoice.h"
#include "Grid/Stopwatch.h"
#include "HaspGL.h"
#include "Isosurface/RayCache.h"
#include "MappedVolume.h"
#include "ViewerEyes.h"
#include "VolumeRaycasts.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspOpenGLRayCachingMapper);

namespace
{

constexpr int MostRays = 256;   // a tile
constexpr int FilledAfter = 16; // frames without a find

} // namespace

std::string DrawingChoice::Text() const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  const auto say = [&](const Cost& cost)
  {
    if (cost.times == 0)
      text << "not measured";
    else
      text << cost.least << " ms";
  };
  text << "cache ";
  say(this->Measured[0].cache);
  text << ", all active cells ";
  say(this->Measured[0].whole);
  text << "; after a change ";
  say(this->Measured[1].cache);
  text << " and ";
  say(this->Measured[1].whole);
  return text.str();
}

struct vtkHaspOpenGLRayCachingMapper::OpenGL
{
  vtkMTimeType VolumeTime = 0; ///< of the image that all of this was made from
  double IsoValue = std::numeric_limits<double>::quiet_NaN();
  bool Unlit = false;   ///< the last frame lacked the light that was asked for
  bool Changed = false; ///< volume or isovalue, since the last frame

  std::unique_ptr<hasp::RayCache> Cache;
  double CacheMilliseconds = 0.0;
  hasp::RayCache::Frame Last;
  double SampleMilliseconds = 0.0;
  int Rays = 0; ///< a tile, in the last frame
  /// In a row in which rays found nothing new; stays when the cache has once been filled.
  int QuietFrames = 0;
  CachedLevels Levels;
  ViewerEyes Eyes;

  vtkSmartPointer<vtkHaspClusteredCellMapper> Whole; ///< all active cells
  DrawingChoice Choice;
  VolumeRaycasts Raycasts;
  bool CacheAlone = false; ///< drew the last frame
  std::string Drew = "nothing drawn";
  std::string Complaint; ///< said last, and not again while it stays the same

  /// Of the surface's pixels in the last frame, as far as rays have looked.
  std::string ShareOfCache() const
  {
    if (!this->CacheAlone || this->Last.hits == 0)
      return this->CacheAlone ? "" : "; no pixel from the cache";
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << "; "
         << 100.0 * double(this->Last.known) / double(this->Last.hits)
         << " % of the surface's pixels from the cache, by " << this->Last.hits << " rays";
    return text.str();
  }
  bool Filled() const { return this->QuietFrames >= FilledAfter; }
  void ForgetCache()
  {
    this->Cache.reset();
    this->Last = {};
    this->Levels.Clear();
    this->Eyes.Clear();
    this->QuietFrames = 0;
  }

  /// Rays a tile that fit into the budget beside the drawing, by what the last frame took.
  int RaysFor(double budget, int fixed) const
  {
    if (budget == 0.0 || this->Rays == 0 || this->SampleMilliseconds == 0.0)
      return fixed;
    const double left = budget - this->Levels.DrawMilliseconds;
    return static_cast<int>(
      std::clamp(left / this->SampleMilliseconds * this->Rays, 1.0, double(MostRays)));
  }
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
  else
    this->Superclass::SetRenderer(renderer);
}

bool vtkHaspOpenGLRayCachingMapper::IsRefining() const
{
  return this->GL->Cache && this->GL->Last.added > 0;
}

/// Brings what was made of the volume up to date with it and with the isovalue.
void vtkHaspOpenGLRayCachingMapper::UpdateCache()
{
  OpenGL& gl = *this->GL;
  MappedVolume& volume = this->GetVolume();
  gl.Changed = gl.VolumeTime != this->GetVolumeTime() || gl.IsoValue != this->GetIsoValue() ||
               volume.Changed();
  if (gl.VolumeTime != this->GetVolumeTime())
  {
    gl.ForgetCache();
    gl.Choice = {};
    gl.VolumeTime = this->GetVolumeTime();
  }
  gl.IsoValue = this->GetIsoValue();
  const hasp::AnyGridView grid = hasp::ViewImage(this->GetImage());
  if (volume.Changed())
  {
    volume.Blocks.Update(grid, volume.ChangedLow(), volume.ChangedHigh());
    if (gl.Cache)
      gl.Cache->MarkModified(volume.ChangedLow(), volume.ChangedHigh());
    gl.Raycasts.MarkModified(volume.ChangedLow(), volume.ChangedHigh());
    if (gl.Whole)
    {
      const int* extent = this->GetImage()->GetExtent();
      int box[6];
      for (int a = 0; a < 3; ++a)
      {
        box[2 * a] = extent[2 * a] + volume.ChangedLow()[a];
        box[2 * a + 1] = extent[2 * a] + volume.ChangedHigh()[a];
      }
      gl.Whole->MarkModified(box);
    }
    volume.ForgetChanges();
  }
  if (gl.Cache)
    gl.Cache->SetIsovalue(this->GetIsoValue());
}

void vtkHaspOpenGLRayCachingMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->UpdateVolume())
    return;
  window->MakeCurrent(); // not every window brings the last context back
  OpenGL& gl = *this->GL;
  try
  {
    this->UpdateCache();
    const bool lit = this->AmbientOcclusion || this->Shadows,
               unlit = lit && this->Mode != Automatic;
    if (unlit && !gl.Unlit)
      vtkErrorMacro("Ambient occlusion and shadows are not drawn, for they take traced rays: set "
                    "the mode to Automatic.");
    gl.Unlit = unlit;
    if (this->Mode == Raycast || this->Mode == RaycastSkipping)
      this->DrawRaycast(renderer, actor);
    else
      this->DrawCells(renderer, actor, lit);
    gl.Complaint.clear();
  }
  catch (const std::exception& e)
  {
    gl.Drew = "nothing drawn";
    if (gl.Complaint != e.what())
      vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    gl.Complaint = e.what();
  }
}

/// Those of the cache, or all active ones, or both where they are to be compared. What no later
/// frame can want is not kept.
void vtkHaspOpenGLRayCachingMapper::DrawCells(vtkRenderer* renderer, vtkActor* actor, bool lit)
{
  OpenGL& gl = *this->GL;
  gl.Raycasts.Clear();
  const bool changed = gl.Changed;
  const DrawingChoice::Frame frame = this->Mode == Cache ? DrawingChoice::Frame{ true, false }
                                     : lit               ? DrawingChoice::Frame{ false, true }
                                                         : gl.Choice.Next(changed, gl.Filled());
  if (frame.cache)
  {
    const hasp::Stopwatch watch;
    this->DrawCache(renderer, actor);
    if (this->Mode == Automatic)
    {
      glFinish();
      gl.Choice.CacheTook(changed, watch.Milliseconds());
    }
  }
  if (frame.whole)
  {
    const hasp::Stopwatch watch;
    this->DrawWhole(renderer, actor);
    glFinish();
    if (!lit)
      gl.Choice.WholeTook(changed, watch.Milliseconds());
  }
  const DrawingChoice::Frame later =
    this->Mode == Cache || lit ? frame : gl.Choice.MayDraw(gl.Filled());
  if (!later.cache)
    gl.ForgetCache();
  if (!later.whole)
    gl.Whole = nullptr;
  gl.CacheAlone = !frame.whole;
  gl.Drew = this->Mode == Cache ? "cache: asked for; " + gl.Levels.RendererText()
            : lit               ? "all active cells: ambient occlusion and shadows take traced rays"
                  : (frame.whole ? "all active cells: " : "cache: ") + gl.Choice.Text();
}

/// Nothing of the other modes is kept.
void vtkHaspOpenGLRayCachingMapper::DrawRaycast(vtkRenderer* renderer, vtkActor* actor)
{
  OpenGL& gl = *this->GL;
  gl.ForgetCache();
  gl.Whole = nullptr;
  gl.Choice = {};
  gl.CacheAlone = false;
  const bool skipping = this->Mode == RaycastSkipping;
  gl.Raycasts.Draw({ hasp::ViewImage(this->GetImage()), this->GetVolume().Blocks,
                     this->GetVolumeTime(), this->GetIsoValue() },
    { skipping, this->StepSize }, this, renderer, actor);
  gl.Drew = skipping ? "raycast with skipping: asked for" : "raycast: asked for";
  vtkOpenGLCheckErrorMacro("after raycasting");
}

void vtkHaspOpenGLRayCachingMapper::DrawWhole(vtkRenderer* renderer, vtkActor* actor)
{
  OpenGL& gl = *this->GL;
  if (!gl.Whole)
    gl.Whole = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
  if (gl.Whole->GetImage() != this->GetImage())
    gl.Whole->SetInputData(this->GetImage());
  gl.Whole->SetIsoValue(this->GetIsoValue());
  gl.Whole->SetClippingPlanes(this->GetClippingPlanes());
  gl.Whole->SetRenderer(this->GetRenderer());
  gl.Whole->SetAmbientOcclusion(this->AmbientOcclusion);
  gl.Whole->SetAmbientOcclusionDistance(this->AmbientOcclusionDistance);
  gl.Whole->SetShadows(this->Shadows);
  gl.Whole->Render(renderer, actor);
}

void vtkHaspOpenGLRayCachingMapper::DrawCache(vtkRenderer* renderer, vtkActor* actor)
{
  OpenGL& gl = *this->GL;
  const hasp::AnyGridView grid = hasp::ViewImage(this->GetImage());
  if (!gl.Cache)
  {
    const hasp::Stopwatch watch;
    gl.Cache =
      std::make_unique<hasp::RayCache>(grid, this->GetVolume().Blocks, this->GetIsoValue());
    gl.CacheMilliseconds = watch.Milliseconds();
  }
  const CellScene scene(this, hasp::GeometryOf(grid), this->GetIsoValue(), renderer, actor);
  ViewerEye& eye = gl.Eyes.Of(renderer);
  const bool sampled = !renderer->GetSelector() && eye.BeginsFrame();
  if (sampled)
  {
    const hasp::Stopwatch watch;
    const hasp::SampledEye seen{ { scene.indexToClip, scene.viewportSize, scene.planes },
      eye.Depth(scene.viewportSize), eye.Number };
    std::vector<hasp::PictureView> predicted;
    if (const auto next = this->Prediction ? eye.Predict(scene.indexToClip) : std::nullopt)
      predicted.push_back({ *next, scene.viewportSize, scene.planes });
    gl.Rays = gl.RaysFor(this->FrameBudget, this->RaysPerTile);
    gl.Last = gl.Cache->Sample({ &seen, 1 }, predicted, gl.Rays);
    if (gl.QuietFrames < FilledAfter)
      gl.QuietFrames = gl.Last.added > 0 ? 0 : gl.QuietFrames + 1;
    for (int level = 0; level < gl.Cache->Levels(); ++level)
      gl.Levels.Set(level, gl.Cache->Cells(level));
    eye.Moved(scene.indexToClip);
    gl.SampleMilliseconds = watch.Milliseconds();
  }
  gl.Levels.Draw(this, renderer, actor);
  if (sampled && !actor->IsRenderingTranslucentPolygonalGeometry())
    eye.ReadDepth(scene.viewportOrigin, scene.viewportSize);
}

void vtkHaspOpenGLRayCachingMapper::ListResources(hasp::ResourceList& list) const
{
  this->Superclass::ListResources(list);
  const OpenGL& gl = *this->GL;
  list.push_back({ "drawn by", 0, 0.0, gl.Drew + gl.ShareOfCache() });
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
  if (gl.Whole)
    gl.Whole->ListResources(list);
  else
    list.push_back({ "active cells, host", 0, 0.0, "the cache was asked for" });
}
