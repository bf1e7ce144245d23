// What the second eye costs: bricks and time.
#include "RaycachingScene.h"

#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCache.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>

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
  ReportRow row = ErrorFigure("raycaching.stereo.bricks" + scene.cells.tag,
    { double(two) / double(one), "bricks of two eyes / of one" }, "two caches would hold 2", stereo,
    scene.data + ", eyes 4 degrees apart, " + std::to_string(two) + " and " + std::to_string(one));
  row.bars = { { {}, 1.3 } };
  context.report.rows.push_back(std::move(row));
}

/// A way to draw both eyes, and what is asked of it.
struct Stereo
{
  std::string second, pair; ///< ids of its rows
  std::string text;
  double mostSecond;   ///< of the first eye's time; both eyes may take that and one of mono's
  double mostOffDepth; ///< share of the surface's pixels
  int warmUps;         ///< frames
  std::function<std::unique_ptr<WindowMethod>(const IsosurfaceView&)> make;
  /// The right eye's picture as it should be, in a method that has drawn no left one.
  std::function<void(WindowMethod&)> finish;
};

PairedTimes Paired(const std::vector<Timing>& a, const std::vector<Timing>& b)
{
  PairedTimes times;
  times.pairs = static_cast<int>(a.size());
  const auto figures = [&](const auto& figure)
  {
    std::vector<double> all;
    for (std::size_t n = 0; n < a.size(); ++n)
      all.push_back(figure(a[n], b[n]));
    return QuartilesOf(std::move(all));
  };
  times.ratio = figures([](const Timing& x, const Timing& y) { return x.wallS / y.wallS; });
  times.cpuRatio = figures([](const Timing& x, const Timing& y) { return x.cpuS / y.cpuS; });
  const auto first = [](double Timing::*part)
  { return [part](const Timing& x, const Timing&) { return x.*part; }; };
  const auto other = [](double Timing::*part)
  { return [part](const Timing&, const Timing& y) { return y.*part; }; };
  times.a = { figures(first(&Timing::wallS)).median, figures(first(&Timing::cpuS)).median };
  times.b = { figures(other(&Timing::wallS)).median, figures(other(&Timing::cpuS)).median };
  return times;
}

/// The share of the pixels with surface that are more than half a voxel off, or are missed.
double OffDepth(const SurfacePoints& truth, const SurfacePoints& shown, double voxelMm)
{
  std::size_t surface = 0, off = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
  {
    const bool same = truth[n] && shown[n] ? glm::distance(*truth[n], *shown[n]) <= 0.5 * voxelMm
                                           : truth[n].has_value() == shown[n].has_value();
    surface += truth[n].has_value();
    off += !same;
  }
  return double(off) / double(surface);
}

/// Left eye, then right eye, on the orbit, and the same frame in mono; in turn, for a head moves
/// between the pairs, not between its eyes.
void AddEyes(ReportContext& context, const RaycachingScene& scene, const Stereo& stereo)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  const auto ours = stereo.make(view), mono = stereo.make(view);
  const auto draw = [&](WindowMethod& method, int eye)
  {
    method.ChooseEye(eye);
    return TimeOf([&] { method.Draw(); });
  };
  std::vector<Timing> left, right, both, one;
  const bool quick = context.settings.quick;
  const int warmUps = quick ? std::min(stereo.warmUps, 12) : stereo.warmUps;
  const int counted = quick ? 9 : 21;
  for (int frame = 0; frame < warmUps + counted; ++frame)
  {
    path.Orbit(frame);
    const Timing m = draw(*mono, 0), l = draw(*ours, -1), r = draw(*ours, 1);
    if (frame < warmUps)
      continue;
    one.push_back(m);
    left.push_back(l);
    right.push_back(r);
    both.push_back({ l.wallS + r.wallS, l.cpuS + r.cpuS });
  }
  const std::vector<glm::vec3> shown = ours->Picture();
  const SurfacePoints points = ours->Points();
  const auto alone = stereo.make(view);
  alone->ChooseEye(1);
  stereo.finish(*alone);
  const SurfacePoints exact = alone->Points();
  PictureTruth truth{ alone->Picture(), {} };
  for (const std::optional<glm::dvec3>& point : exact)
    truth.surface.push_back(point.has_value());
  const double* spacing = view.image->GetSpacing();
  const double off = OffDepth(exact, points, std::min({ spacing[0], spacing[1], spacing[2] }));
  char share[80];
  std::snprintf(share, sizeof share, ", %.3g %% of pixels off by half a voxel, ", 100.0 * off);
  const auto add =
    [&](const std::string& id, const PairedTimes& times, const std::string& rival, double most)
  {
    ReportRow row = TimedRatio(id + scene.cells.tag, times, rival,
      { ForegroundPsnr(truth, shown), "dB against the right eye at rest alone" },
      scene.data + ", orbit 1 degree a frame" + share + stereo.text + ours->Name());
    row.bars = { { {}, most }, { {}, stereo.mostOffDepth, "share of pixels off in depth", off } };
    context.report.rows.push_back(std::move(row));
  };
  add(stereo.second, Paired(right, left), "the first eye of the same frame", stereo.mostSecond);
  add(stereo.pair, Paired(both, one), "the same frame in mono", 1.0 + stereo.mostSecond);
}

} // namespace

void ReportRaycachingStereo(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: two eyes, " + scene.data);
  AddStereo(context, scene);
  const auto caching = [&](const std::string& id, int mode, bool lit)
  {
    const auto make = [&scene, mode, lit](const IsosurfaceView& view)
    {
      auto method = std::make_unique<CachingMethod>(view, mode);
      if (lit)
        method->Light(scene.TowardsLight(), scene.DarkeningMm, scene.Ambient, scene.Diffuse);
      return method;
    };
    const auto finish = [lit](WindowMethod& method)
    {
      dynamic_cast<CachingMethod&>(method).Converge(400);
      for (int still = 0; lit && still < 64; ++still)
        method.Draw(); // until its light is as good as it gets
    };
    AddEyes(context, scene,
      { "raycaching.stereo.second" + id, "raycaching.stereo.pair" + id, lit ? "lit, " : "", 0.7,
        0.01, 40, make, finish });
  };
  caching("@cache", vtkHaspRayCachingMapper::Cache, false);
  caching("@auto", vtkHaspRayCachingMapper::Automatic, false);
  caching(".lit@auto", vtkHaspRayCachingMapper::Automatic, true);
  const auto cells = [&](const std::string& id, CellDrawing drawing)
  {
    const auto make = [drawing](const IsosurfaceView& view)
    {
      auto method = MakeCellMethod(view, drawing);
      return std::unique_ptr<WindowMethod>(dynamic_cast<WindowMethod*>(method.release()));
    };
    AddEyes(context, scene,
      { "cells.stereo.second" + id, "cells.stereo.pair" + id,
        drawing == CellDrawing::Rasterize ? "boxes the first eye saw are not tested again, " : "",
        0.8, 0.0, 6, make, [](WindowMethod& method) { method.Draw(); } });
  };
  cells("@rasterize", CellDrawing::Rasterize);
#if HASP_WITH_RAYS
  cells("@trace", CellDrawing::Trace);
#endif
}

} // namespace hasp
