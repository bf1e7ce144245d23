// How light that adds up converges in a picture that does not move.
#include "RaycachingScene.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/LightCache.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr int TrueRays = 1024; // a pixel

struct Still
{
  double frames, rays; ///< so far; rays a surface pixel
  double rmse;         ///< of openness
};

/// The same picture again and again, against many rays at each `stride`th surface pixel.
std::vector<Still> FollowStill(const RaycachingScene& scene, int frames, int stride, Timing& time)
{
  const IsosurfaceView view = scene.View();
  const AnyGridView grid = ViewImage(scene.cells.image);
  const CellTracer tracer(std::make_shared<const ClusteredCells>(
    ExtractActiveCells(grid, MinMaxBlocks(grid), scene.cells.isovalue)));
  const PictureView seen = IndexView(view, grid);
  TracedPicture picture;
  tracer.TracePicture(seen, picture);
  const PictureRays rays(seen);
  std::vector<std::size_t> pixels;
  std::size_t surface = 0;
  for (std::size_t n = 0; n < picture.cells.size(); ++n)
    if (picture.cells[n] != TracedPicture::Nothing && surface++ % std::size_t(stride) == 0)
      pixels.push_back(n);
  std::vector<float> truth(pixels.size());
  ParallelFor(0, std::int64_t(pixels.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto k = std::size_t(first); k < std::size_t(last); ++k)
      {
        CellRay ray;
        rays.Of(glm::dvec2(pixels[k] % view.width, pixels[k] / view.width) + 0.5, ray);
        if (const auto hit = tracer.Trace(ray))
          truth[k] = tracer.AmbientOcclusion(*hit, { TrueRays, scene.DarkeningMm }, unsigned(k));
      }
    });
  LightCache cache;
  PictureLight light;
  std::vector<Still> course;
  double cast = 0.0;
  for (int frame = 1; frame <= frames; ++frame)
  {
    const Timing one = TimeOf(
      [&] {
        cache.Light(tracer, seen, picture, { scene.DarkeningMm, {} }, light);
      });
    time.wallS += one.wallS / frames;
    time.cpuS += one.cpuS / frames;
    cast += double(cache.Rays()) / double(surface);
    double sum = 0.0;
    for (std::size_t k = 0; k < pixels.size(); ++k)
      sum += std::pow(light[pixels[k]].x / 255.0 - truth[k], 2);
    course.push_back({ double(frame), cast, std::sqrt(sum / double(pixels.size())) });
  }
  return course;
}

/// What is left after very many frames is the floor, blur; noise is what the error has beside it,
/// by squares. Its slope, while it is at least a third of the floor.
void AddStillLight(ReportContext& context, const RaycachingScene& scene)
{
  Timing time;
  const bool quick = context.settings.quick;
  const int stride = quick ? 5 : 31;
  const std::vector<Still> course = FollowStill(scene, quick ? 1024 : 512, stride, time);
  const double floor = course.back().rmse;
  std::vector<std::pair<double, double>> byFrames, byRays;
  ReportCurve curve{ "raycaching.ao.error" + scene.cells.tag, "light cache", "ms", "RMSE", {} };
  bool above = true;
  for (std::size_t frames = 1; frames < course.size(); frames *= 2)
  {
    const Still& still = course[frames - 1];
    curve.points.push_back({ 1e3 * double(frames) * time.wallS, still.rmse });
    const double noise = std::sqrt(std::max(0.0, still.rmse * still.rmse - floor * floor));
    above = above && noise > 0.0 && noise >= floor / 3.0;
    if (!above)
      continue;
    byFrames.emplace_back(double(frames), noise);
    byRays.emplace_back(still.rays, noise);
  }
  context.report.curves.push_back(curve);
  if (byFrames.size() < 2)
    throw std::runtime_error("the light of this volume is at its floor from the first frame on: it "
                             "has no slope");
  char text[160];
  std::snprintf(text, sizeof text,
    ", still camera, frames 1 to %.0f; the first casts %.3g rays a pixel, the others %.2g; floor "
    "%.4f",
    byFrames.back().first, course[0].rays,
    (course.back().rays - course[0].rays) / double(course.size() - 1), floor);
  const auto add = [&](const std::string& id, double value, const std::string& unit,
                     const std::vector<ReportBar>& bars = {})
  {
    ReportRow row =
      ErrorFigure("raycaching.ao." + id + scene.cells.tag, { floor, "RMSE in the end" },
        std::to_string(TrueRays) + " rays at one surface pixel of " + std::to_string(stride), time,
        scene.data + text);
    row.value = value;
    row.unit = unit;
    row.n = int(byFrames.size());
    if (id != "floor") // a slope is to be what theory says
      row.better = Better::NotSaid;
    row.bars = bars;
    context.report.rows.push_back(row);
  };
  add("slope", GrowthExponent(byFrames), "d log noise / d log frames", { { -0.6, -0.4 } });
  add("slope.casts", GrowthExponent(byRays), "d log noise / d log rays so far");
  add("floor", floor, "RMSE of openness");
}

} // namespace

void ReportRaycachingStillLight(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: light at rest of " + scene.data);
  AddStillLight(context, scene);
}

} // namespace hasp
