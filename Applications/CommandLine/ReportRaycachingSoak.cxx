// A long walk: does anything grow, go wrong or get there twice?
#include "RaycachingScene.h"

#include "Grid/MinMaxBlocks.h"
#include "HaspGL.h"
#include "Isosurface/RayCache.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <stdexcept>
#include <tuple>

namespace hasp
{
namespace
{

/// Of this process, KB.
double ResidentKb()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  if (!(file >> pages >> resident))
    throw std::runtime_error("soak: cannot read /proc/self/statm");
  return resident * double(sysconf(_SC_PAGESIZE)) / 1024.0;
}

std::size_t DistinctBlocks(RayCache& cache)
{
  std::set<std::tuple<int, int, int, int>> distinct;
  for (int level = 0; level < cache.Levels(); ++level)
    for (const CellCluster& cluster : cache.Cells(level)->clusters)
    {
      const glm::ivec3 at = cluster.Origin();
      distinct.insert({ level, at.x, at.y, at.z });
    }
  return distinct.size();
}

/// What has been seen so far.
struct Course
{
  std::vector<std::pair<double, double>> residentKb; ///< by frame
  std::size_t leastBytes = SIZE_MAX, mostBytes = 0;  ///< of the mapper's cache
  double worstUnique = 1.0;                          ///< live bricks / distinct blocks
  int glErrors = 0, vtkErrors = 0;
  double psnr = 99.0; ///< of the worst picture looked at
  Timing time;        ///< of a frame
};

void CountError(vtkObject*, unsigned long, void* course, void*)
{
  ++static_cast<Course*>(course)->vtkErrors;
}

/// What the mapper holds of fixed size; the rest goes with what is in view.
std::size_t CacheBytes(const CachingMethod& method)
{
  for (const ResourceUse& use : method.Resources())
    if (use.resource == "ray cache")
      return use.bytes;
  throw std::runtime_error("soak: the mapper lists no ray cache");
}

/// Least-squares line through what is resident after the first third, which is for warming up: KB
/// a thousand frames.
double GrowthKb(const std::vector<std::pair<double, double>>& kbOfFrame)
{
  const auto first = kbOfFrame.begin() + std::ptrdiff_t(kbOfFrame.size() / 3);
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (auto at = first; at != kbOfFrame.end(); ++at, ++n)
  {
    x += at->first;
    y += at->second;
    xx += at->first * at->first;
    xy += at->first * at->second;
  }
  const double spread = n * xx - x * x;
  if (!(spread > 0.0))
    throw std::runtime_error("soak: too few frames; give more");
  return 1e3 * (n * xy - x * y) / spread;
}

Course Walk(ReportContext& context, const RaycachingScene& scene)
{
  Course course;
  IsosurfaceView view = scene.View();
  const std::vector<RecordedPath> paths = RecordedPaths(scene, view);
  CachingMethod ours(view, vtkHaspRayCachingMapper::Cache);
  vtkNew<vtkCallbackCommand> onError;
  onError->SetCallback(CountError);
  onError->SetClientData(&course);
  ours.operator->()->AddObserver(vtkCommand::ErrorEvent, onError);
  // The mapper's own bricks cannot be asked for: a cache that sees the same is asked instead.
  const AnyGridView grid = ViewImage(scene.cells.image);
  const MinMaxBlocks blocks(grid);
  RayCache twin(grid, blocks, scene.cells.isovalue);

  const int frames = context.settings.soakFrames, step = std::max(1, frames / 50);
  const int leg = std::clamp(frames / 16, 1, 30); // on one path before the next
  for (int frame = 0; frame < frames; ++frame)
  {
    const RecordedPath& path = paths[std::size_t(frame / leg) % paths.size()];
    // Each path goes on where it was left, so that it is walked as a whole.
    const int lap = frame / (leg * int(paths.size()));
    const double isovalue = path.go(lap * leg + frame % leg);
    const Timing one = TimeOf(
      [&]
      {
        ours.SetIsovalue(isovalue);
        ours.Draw();
      });
    course.time.wallS += one.wallS / frames;
    course.time.cpuS += one.cpuS / frames;
    while (glGetError() != GL_NO_ERROR && ++course.glErrors % 32 != 0) // a lost context never ends
      ;
    twin.SetIsovalue(isovalue);
    const SampledEye eye{ IndexView(view, grid), {}, 0 };
    twin.Sample({ &eye, 1 }, {}, 8);
    if ((frame + 1) % step != 0)
      continue;
    course.worstUnique =
      std::max(course.worstUnique, double(twin.Live()) / double(DistinctBlocks(twin)));
    course.leastBytes = std::min(course.leastBytes, CacheBytes(ours));
    course.mostBytes = std::max(course.mostBytes, CacheBytes(ours));
    course.residentKb.emplace_back(frame + 1, ResidentKb());
    const double psnr = ForegroundPsnr(CentreRaycachingPicture(view, isovalue), ours.Picture());
    course.psnr = std::isfinite(psnr) ? std::min(course.psnr, psnr) : psnr; // and so it stays
    char text[120];
    std::snprintf(text, sizeof text, "raycaching: walk, frame %d of %d, %.0f MiB resident",
      frame + 1, frames, course.residentKb.back().second / 1024.0);
    context.progress(double(frame + 1) / frames, text);
  }
  return course;
}

} // namespace

void ReportRaycachingSoak(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: walk, " + scene.data);
  const Course course = Walk(context, scene);
  const int frames = context.settings.soakFrames;
  const std::string data = scene.data + ", " + std::to_string(frames) +
                           " frames of orbit, flight, jitter and sweep by turns";
  const double third = course.residentKb[course.residentKb.size() / 3].second;
  char text[240];
  std::snprintf(text, sizeof text,
    "; %.0f KB resident after a third, %.0f KB in the end; cache %zu to %zu bytes", third,
    course.residentKb.back().second, course.leastBytes, course.mostBytes);
  const MeasuredError error{ course.psnr, "dB in the worst picture looked at" };
  const auto add = [&](const std::string& id, double value, const std::string& unit,
                     const std::string& against, const std::string& more, const ReportBar& bar)
  {
    ReportRow row = ErrorFigure(
      "raycaching.soak." + id + scene.cells.tag, error, against, course.time, data + more);
    row.value = value;
    row.unit = unit;
    row.n = frames;
    row.bars = { bar };
    context.report.rows.push_back(row);
  };
  const std::size_t counts = course.residentKb.size();
  add("memory", GrowthKb(course.residentKb), "KB a 1000 frames",
    "what is resident after a third of the frames, by a line through " +
      std::to_string(counts - counts / 3) + " places",
    text, // pages come and go with pictures that are looked at: a hundredth is no growth
    { {}, 1.01, "in the end / after a third", course.residentKb.back().second / third });
  add("cache", double(course.mostBytes - course.leastBytes), "bytes that it grows or shrinks",
    "its least", "", { 0.0, 0.0 });
  add("bricks.unique", course.worstUnique,
    "live bricks / distinct blocks, worst of " + std::to_string(counts) + " counts",
    "their places, counted", ", the kernel's cache beside the mapper's, same views", { 1.0, 1.0 });
  add("errors", course.glErrors + course.vtkErrors, "errors of OpenGL and of the mapper", "none",
    "", { 0.0, 0.0 });
}

} // namespace hasp
