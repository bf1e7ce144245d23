// What the cache shows: pictures, depth, holes, and whether it holds anything twice.
#include "RaycachingScene.h"

#include "CellDepth.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCache.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace hasp
{
namespace
{

constexpr int MostFrames = 400; // until a picture at rest is complete

/// A jittered picture: the mean of some that are shifted by parts of a pixel.
void AddConvergence(ReportContext& context, const RaycachingScene& scene)
{
  IsosurfaceView view = scene.View();
  const PictureTruth truth = TrueRaycachingPicture(view, scene.cells.isovalue);
  CameraPath path(view);
  CachingMethod ours(view, vtkHaspRayCachingMapper::Cache);
  const int frames = ours.Converge(MostFrames);
  const double one = ForegroundPsnr(truth, ours.Picture());
  const double centre =
    ForegroundPsnr(CentreRaycachingPicture(view, scene.cells.isovalue), ours.Picture());
  PictureMean mean;
  constexpr int n = 4;
  const Timing time = TimeOf(
    [&]
    {
      for (int k = 0; k < n * n; ++k)
      {
        path.ShiftPixels((k % n + 0.5) / n - 0.5, (k / n + 0.5) / n - 0.5);
        ours.Draw();
        mean.Add(ours.Picture());
      }
    });
  path.ShiftPixels(0.0, 0.0);
  const std::string data = scene.data + ", complete after " + std::to_string(frames) + " frames";
  const auto add = [&](ReportRow row, std::vector<ReportBar> bars)
  {
    row.bars = std::move(bars);
    context.report.rows.push_back(row);
  };
  add(ErrorFigure("raycaching.psnr" + scene.cells.tag, { ForegroundPsnr(truth, mean.Mean()), "dB" },
        "16 rays a pixel against all active cells", time,
        data + ", mean of 16 shifted by parts of a pixel"),
    { { 35.0, {} } });
  context.report.rows.push_back(ErrorFigure("raycaching.psnr.one" + scene.cells.tag, { one, "dB" },
    "16 rays a pixel against all active cells", { time.wallS / (n * n), time.cpuS / (n * n) },
    data + ", one picture"));
  context.report.rows.back().better = Better::Higher;
  add(ErrorFigure("raycaching.psnr.centre" + scene.cells.tag, { centre, "dB" },
        "one exact ray at each pixel's centre, on the CPU",
        { time.wallS / (n * n), time.cpuS / (n * n) }, data + ", one picture"),
    { { 33.0, {} } });

  ours.Draw();
  const DepthTruth exact(view);
  const SurfacePoints shown = ours.Points();
  std::vector<double> off;
  std::size_t missed = 0;
  const double* spacing = scene.cells.image->GetSpacing();
  const double voxel = std::min({ spacing[0], spacing[1], spacing[2] });
  for (std::size_t pixel = 0; pixel < shown.size(); ++pixel)
    if (exact.hits[pixel] && shown[pixel])
      off.push_back(glm::length(*shown[pixel] - exact.hits[pixel]->position) / voxel);
    else
      missed += exact.hits[pixel].has_value();
  const Quartiles depth = QuartilesOf(off);
  const Timing once = TimeOf([&] { ours.Draw(); });
  add(ErrorFigure("raycaching.depth.median" + scene.cells.tag, { depth.median, "voxel" },
        "a walk from cell to cell, in long double", once,
        data + ", " + std::to_string(missed) + " of " + std::to_string(off.size() + missed) +
          " pixels missed"),
    { { {}, 0.25 } });
}

void AddHoles(ReportContext& context, const RaycachingScene& scene, bool prediction)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  CachingMethod ours(view, vtkHaspRayCachingMapper::Cache);
  ours->SetPrediction(prediction);
  const auto exact = MakeCellMethod(view);
  const int warmUp = 60, frames = context.settings.quick ? 20 : 60;
  double sum = 0.0, most = 0.0;
  Timing all;
  for (int frame = 0; frame < warmUp + frames; ++frame)
  {
    path.Jitter(frame);
    const Timing time = TimeOf([&] { ours.Draw(); });
    if (frame < warmUp)
      continue;
    all.wallS += time.wallS / frames;
    all.cpuS += time.cpuS / frames;
    const double share = HoleShare(*exact, ours);
    sum += share / frames;
    most = std::max(most, share);
  }
  char worst[60];
  std::snprintf(worst, sizeof worst, ", worst frame %.3g", most);
  ReportRow row = ErrorFigure(
    (prediction ? "raycaching.holes" : "raycaching.holes.unpredicted") + scene.cells.tag,
    { sum, "share of surface pixels" }, "all active cells", all,
    scene.data + ", head jitter 5 mm and 3 degrees" + worst);
  row.bars = { { {}, 0.005 } };
  context.report.rows.push_back(row);
}

/// The kernel alone, on the orbit.
void AddUnique(ReportContext& context, const RaycachingScene& scene)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  const AnyGridView grid = ViewImage(scene.cells.image);
  const MinMaxBlocks blocks(grid);
  RayCache cache(grid, blocks, scene.cells.isovalue);
  const std::size_t bytes = cache.Bytes();
  const int frames = 100;
  Timing time;
  for (int frame = 0; frame < frames; ++frame)
  {
    path.Orbit(frame, 3.6);
    const SampledEye eye{ IndexView(view, grid), {}, 0 };
    const Timing one = TimeOf([&] { cache.Sample({ &eye, 1 }, {}, 8); });
    time.wallS += one.wallS / frames;
    time.cpuS += one.cpuS / frames;
  }
  std::set<std::tuple<int, int, int, int>> distinct;
  for (int level = 0; level < cache.Levels(); ++level)
    for (const CellCluster& cluster : cache.Cells(level)->clusters)
    {
      const glm::ivec3 at = cluster.Origin();
      distinct.insert({ level, at.x, at.y, at.z });
    }
  ReportRow row = ErrorFigure("raycaching.bricks.unique" + scene.cells.tag,
    { double(cache.Live()) / double(distinct.size()), "live bricks / distinct blocks" },
    "their places, counted", time,
    scene.data + ", " + std::to_string(frames) + " frames, " + std::to_string(cache.Live()) +
      " bricks, " + std::to_string(bytes) + " bytes before and " + std::to_string(cache.Bytes()) +
      " after");
  row.bars = { { 1.0, 1.0 } };
  context.report.rows.push_back(row);
}

} // namespace

void ReportRaycachingQuality(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: pictures of " + scene.data);
  AddConvergence(context, scene);
  AddHoles(context, scene, true);
  AddHoles(context, scene, false);
  AddUnique(context, scene);
}

} // namespace hasp
