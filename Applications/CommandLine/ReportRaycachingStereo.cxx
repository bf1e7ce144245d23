// What the second eye costs: bricks and time.
#include "RaycachingScene.h"

#include "CellRows.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCache.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// How many clusters one eye needs, or two that look at the same from 4 degrees apart.
std::size_t BricksOf(const RaycachingScene& scene, int eyes, Timing& time)
{
  const AnyGridView grid = ViewImage(scene.cells.image);
  const MinMaxBlocks blocks(grid);
  RayCache cache(grid, blocks, scene.cells.isovalue);
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  std::vector<SampledEye> seen;
  for (int eye = 0; eye < eyes; ++eye)
  {
    path.Orbit(eye, 4.0);
    seen.push_back({ IndexView(view, grid), {}, eye });
  }
  for (int frame = 0; frame < 100; ++frame)
  {
    const Timing one = TimeOf([&] { cache.Sample(seen, {}, 16); });
    time.wallS += one.wallS / 100;
    time.cpuS += one.cpuS / 100;
  }
  return cache.Live();
}

void AddStereo(ReportContext& context, const RaycachingScene& scene)
{
  Timing mono, stereo;
  const std::size_t one = BricksOf(scene, 1, mono), two = BricksOf(scene, 2, stereo);
  context.report.rows.push_back(ErrorFigure("raycaching.stereo.bricks" + scene.cells.tag,
    { double(two) / double(one), "bricks of two eyes / of one" }, "two caches would hold 2", stereo,
    scene.data + ", eyes 4 degrees apart, " + std::to_string(two) + " and " + std::to_string(one)));
}

struct Stereo
{
  std::string id, text;
  int mode;
  bool lit;
};

/// Left eye, then right eye, one cache, on the orbit. The right eye's picture is held against the
/// one of a method that has drawn no left eye.
void AddSecondEye(ReportContext& context, const RaycachingScene& scene, const Stereo& stereo)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  const auto make = [&]
  {
    auto method = std::make_unique<CachingMethod>(view, stereo.mode);
    if (stereo.lit)
      method->Light(scene.TowardsLight(), scene.DarkeningMm, scene.Ambient, scene.Diffuse);
    return method;
  };
  const auto ours = make();
  const auto draw = [&](int eye)
  {
    ours->ChooseEye(eye);
    return TimeOf([&] { ours->Draw(); });
  };
  int frame = 0;
  for (; frame < 40; ++frame)
  {
    path.Orbit(frame);
    draw(-1);
    draw(1);
  }
  // In turn, left before right: a head moves between the pairs, not between its eyes.
  const PairedTimes turned = ComparePairs(
    [&]
    {
      path.Orbit(frame++);
      return draw(-1);
    },
    [&] { return draw(1); }, { 2, 21 });
  PairedTimes times = turned; // right by left
  times.ratio = { 1.0 / turned.ratio.q3, 1.0 / turned.ratio.median, 1.0 / turned.ratio.q1 };
  times.cpuRatio = { 1.0 / turned.cpuRatio.q3, 1.0 / turned.cpuRatio.median,
    1.0 / turned.cpuRatio.q1 };
  std::swap(times.a, times.b);

  const std::vector<glm::vec3> right = ours->Picture();
  const auto alone = make();
  alone->ChooseEye(1);
  alone->Converge(400);
  for (int still = 0; stereo.lit && still < 64; ++still)
    alone->Draw(); // until its light is as good as it gets
  PictureTruth truth{ alone->Picture(), {} };
  for (const std::optional<glm::dvec3>& point : alone->Points())
    truth.surface.push_back(point.has_value());
  context.report.rows.push_back(TimedRatio("raycaching.stereo.second" + stereo.id + scene.cells.tag,
    times, "the first eye of the same frame",
    { ForegroundPsnr(truth, right), "dB against the right eye at rest alone" },
    scene.data + ", orbit 1 degree a frame, " + stereo.text + ours->Name()));
}

} // namespace

void ReportRaycachingStereo(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: two eyes, " + scene.data);
  AddStereo(context, scene);
  AddSecondEye(context, scene, { "@cache", "", vtkHaspRayCachingMapper::Cache, false });
  AddSecondEye(context, scene, { "@auto", "", vtkHaspRayCachingMapper::Automatic, false });
  AddSecondEye(context, scene, { ".lit@auto", "lit, ", vtkHaspRayCachingMapper::Automatic, true });
}

} // namespace hasp
