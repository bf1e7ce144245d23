// Rays a second against cells, as light asks for them, and against triangles of the same surface.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"
#include "Isosurface/Hemisphere.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{
namespace
{

constexpr double Bar = 0.5;
constexpr float Infinite = std::numeric_limits<float>::infinity();
constexpr std::int64_t Grain = 4096; // rays a task, as the rival's
constexpr std::size_t LeastRays = 400'000;

/// Rays that leave what the view shows, cosine-weighted, as light asks for them: one a pixel, then
/// the next one of each; so many that threads do not begin and end while they are timed. Ours leave
/// the hit itself; the rival's start half a voxel above it, for its triangles lie elsewhere. What
/// both meet is compared by the latter.
struct Leaving
{
  std::vector<const LitHit*> hits;
  std::vector<glm::dvec3> directions;
  std::vector<WorldRay> raised;
};

Leaving RaysFrom(const std::vector<SeenHit>& seen, double voxelMm, std::uint64_t seed)
{
  Leaving rays;
  const auto each = int(LeastRays / std::max<std::size_t>(1, seen.size())) + 1;
  for (int k = 0; k < each; ++k)
    for (std::size_t n = 0; n < seen.size(); ++n)
    {
      RandomSequence points(SeedOf(seed, n), static_cast<std::uint32_t>(k));
      const LitHit& hit = seen[n].hit;
      rays.hits.push_back(&hit);
      rays.directions.push_back(CosineAround(hit.normal, points.Next()));
      rays.raised.push_back({ hit.position + 0.5 * voxelMm * hit.normal, rays.directions.back() });
    }
  return rays;
}

/// trace(n): the way of ray n, or infinite.
template <typename Trace>
void TraceAll(std::vector<float>& t, const Trace& trace)
{
  ParallelFor(0, std::int64_t(t.size()), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        t[n] = trace(std::size_t(n));
    });
}

struct Difference
{
  double share = 0.0;             ///< of rays that only one of both has meet something
  double median = 0.0, p99 = 0.0; ///< of the ways of those that both have, voxels
};

Difference Compare(const std::vector<float>& ours, const std::vector<float>& theirs, double voxelMm)
{
  Difference difference;
  std::vector<double> ways;
  for (std::size_t n = 0; n < ours.size(); ++n)
    if (std::isfinite(ours[n]) != std::isfinite(theirs[n]))
      difference.share += 1.0 / double(ours.size());
    else if (std::isfinite(ours[n]))
      ways.push_back(std::abs(double(ours[n]) - theirs[n]) / voxelMm);
  std::sort(ways.begin(), ways.end());
  if (!ways.empty())
    difference = { difference.share, ways[ways.size() / 2], ways[ways.size() * 99 / 100] };
  return difference;
}

template <typename Hit>
float WayOf(const std::optional<Hit>& hit)
{
  return hit ? static_cast<float>(hit->t) : Infinite;
}

/// Of a million rays.
Timing Million(const Timing& all, double rays)
{
  return { 1e6 * all.wallS / rays, 1e6 * all.cpuS / rays };
}

void AddRays(ReportContext& context, const LightData& data, const std::string& id,
  const PairedTimes& times, const std::string& rival, const MeasuredError& error,
  const std::string& text)
{
  char rate[120];
  std::snprintf(rate, sizeof rate,
    "; %.2f against %.2f million rays a second; aim 1; time of a million", 1.0 / times.a.wallS,
    1.0 / times.b.wallS);
  ReportRow row = CpuRatio(
    "light.rays." + id + data.tag, times, rival, error, data.data + ", " + text + rate, true);
  if (data.tag.empty() && id.find('.') == std::string::npos) // a kind of its own
    row.bars = { { Bar, {} } };
  context.report.rows.push_back(row);
}

struct PathsTraced
{
  std::int64_t rays = 0;
  double mean = 0.0;
  Timing million;
};

PathsTraced TracePathsOf(
  const LitScene& scene, const std::vector<SeenHit>& hits, std::uint64_t seed)
{
  const PathTracer<SobolSequence> tracer(scene, { 3 });
  std::vector<std::pair<std::int64_t, double>> sums(hits.size());
  PathsTraced traced;
  const Timing time = TimeOf(
    [&]
    {
      ParallelFor(0, std::int64_t(hits.size()), 256,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
            for (std::uint32_t k = 0; k < 4; ++k)
            {
              SobolSequence points(SeedOf(seed, std::size_t(n)), k);
              const PathSample sample = tracer.Radiance(hits[n].hit, hits[n].towardsEye, points);
              sums[n].first += sample.rays;
              sums[n].second += sample.radiance.g / 4.0;
            }
        });
    });
  for (const auto& [rays, light] : sums)
  {
    traced.rays += rays;
    traced.mean += light / double(hits.size());
  }
  traced.million = Million(time, double(std::max<std::int64_t>(1, traced.rays)));
  return traced;
}

/// After the row of paths, whose error it shares.
void AddRate(ReportContext& context, const LightData& data, const Timing& ao, const Timing& bounces,
  const Timing& paths)
{
  ReportRow row = context.report.rows.back();
  row.id = "light.rays.rate" + data.tag;
  row.value = 1.0 / std::max({ ao.wallS, bounces.wallS, paths.wallS });
  row.unit = "million rays a second";
  row.better = Better::Higher;
  row.q1 = row.q3 = std::nullopt;
  row.bars.clear();
  char text[240];
  std::snprintf(text, sizeof text,
    ", wall time of all %d cores, the slowest of ambient occlusion %.2f, bounces %.2f, paths %.2f; "
    "aim 5 on 2 cores that nobody else uses; by CPU time %.2f, %.2f, %.2f for each core",
    ParallelThreads(), 1.0 / ao.wallS, 1.0 / bounces.wallS, 1.0 / paths.wallS, 1.0 / ao.cpuS,
    1.0 / bounces.cpuS, 1.0 / paths.cpuS);
  row.data = data.data + text;
  context.report.rows.push_back(row);
}

} // namespace

void MeasureRays(ReportContext& context, const LightData& data, const RayRival& rival)
{
  context.progress(0.0, "light: rays on " + data.data);
  const auto sky = Daylight();
  const SurfaceMaterial bone{ glm::vec3(0.8F) };
  const LitScene cells({ BodyOf(data.cells, bone) }, {}, sky),
    triangles({ BodyOf(data.mesh, bone) }, {}, sky);
  const PictureView view = OrbitView(cells, 0.0, context.settings.quick ? 192 : 512);
  const std::vector<SeenHit> seen = SeenHits(cells, view);
  const Leaving rays = RaysFrom(seen, data.voxelMm, context.settings.seed);
  const auto count = double(rays.hits.size());
  std::vector<float> ours(rays.hits.size()), theirs(rays.hits.size());
  TraceAll(ours,
    [&](std::size_t n) { return WayOf(cells.Trace(rays.raised[n].origin, rays.directions[n])); });
  rival.nearest(rays.raised, theirs);
  const Difference off = Compare(ours, theirs, data.voxelMm);
  char said[200];
  std::snprintf(said, sizeof said,
    "%.0f rays; of the same rays both meet something %.2g voxel apart, median, %.2g, p99", count,
    off.median, off.p99);
  const std::string text = said;
  const auto compare =
    [&](const std::string& id, const auto& trace, const auto& by, const std::string& name)
  {
    const PairedTimes times =
      ComparePairs([&] { return Million(TimeOf([&] { TraceAll(ours, trace); }), count); },
        [&] { return Million(TimeOf([&] { by(rays.raised, theirs); }), count); });
    AddRays(context, data, id, times, name,
      { off.share, "of the rays meet something in one of both alone" }, text);
    return times.a;
  };
  constexpr double Far = std::numeric_limits<double>::infinity();
  const auto hit = [&](std::size_t n) -> const LitHit& { return *rays.hits[n]; };
  const auto towards = [&](std::size_t n) -> const glm::dvec3& { return rays.directions[n]; };
  const auto blocked = [](bool something) { return something ? 0.0F : Infinite; };
  const std::string any = rival.name + ", rtcOccluded1", nearest = rival.name + ", rtcIntersect1";
  const Timing ao = compare(
    "ao", [&](std::size_t n) { return blocked(cells.OccludedFrom(hit(n), towards(n))); }, rival.any,
    any);
  const Timing bounces = compare(
    "bounces", [&](std::size_t n) { return WayOf(cells.TraceFrom(hit(n), towards(n))); },
    rival.nearest, nearest);
  compare(
    "ao.tracer",
    [&](std::size_t n) { return blocked(data.cells->OccludedFrom(hit(n).cell, towards(n), Far)); },
    rival.any, any);
  compare(
    "bounces.tracer",
    [&](std::size_t n) { return WayOf(data.cells->TraceFrom(hit(n).cell, towards(n), Far)); },
    rival.nearest, nearest);

  const std::vector<SeenHit> seenOfMesh = SeenHits(triangles, view);
  PathsTraced a, b;
  const PairedTimes paths =
    ComparePairs([&] { return (a = TracePathsOf(cells, seen, context.settings.seed)).million; },
      [&] { return (b = TracePathsOf(triangles, seenOfMesh, context.settings.seed)).million; });
  AddRays(context, data, "paths", paths,
    "the same paths against Light/TriangleTracer.h, Embree's triangles with roots in double",
    { std::abs(a.mean - b.mean) / b.mean, "of the light, on average" },
    std::to_string(a.rays) + " rays of paths of 3 bounces under daylight");

  AddRate(context, data, ao, bounces, paths.a);
}

} // namespace hasp
