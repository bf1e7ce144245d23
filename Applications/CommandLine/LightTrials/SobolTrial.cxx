// Error against time of scrambled Sobol points and of random ones.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"
#include "Isosurface/Hemisphere.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr int Most = 256, At = 64, Truth = 4096; // samples
constexpr double DarkeningMm = 25.0;

using ErrorOf = std::vector<std::pair<double, double>>; // samples, RMSE

/// What is asked of a hit with one point of a sequence.
template <typename Points>
struct Asked
{
  const LitScene& scene;
  PathTracer<Points> paths;
  bool openness;
  std::uint64_t seed;

  Asked(const LitScene& of, int bounces, std::uint64_t s)
    : scene(of),
      paths(of, { std::max(1, bounces) }),
      openness(bounces == 0),
      seed(s)
  {
  }
  glm::vec3 operator()(const SeenHit& seen, std::uint32_t place, std::uint32_t number) const
  {
    Points points(SeedOf(this->seed, place), number);
    if (!this->openness)
      return this->paths.Radiance(seen.hit, seen.towardsEye, points).radiance;
    const glm::dvec3 direction = CosineAround(seen.hit.normal, points.Next());
    return glm::vec3(this->scene.OccludedFrom(seen.hit, direction, DarkeningMm) ? 0.0F : 1.0F);
  }
};

/// RMSE over the hits after 1, 2, 4 ... samples, of several seeds together.
template <typename Points>
ErrorOf Errors(const LitScene& scene, int bounces, const std::vector<SeenHit>& hits,
  const std::vector<glm::dvec3>& truth, std::uint64_t seed, int seeds)
{
  const auto steps = std::size_t(std::lround(std::log2(Most))) + 1;
  std::vector<std::vector<double>> squares(hits.size(), std::vector<double>(steps, 0.0));
  for (int s = 0; s < seeds; ++s)
  {
    const Asked<Points> ask(scene, bounces, seed + 7919U * std::uint64_t(s + 1));
    ParallelFor(0, std::int64_t(hits.size()), 8,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          glm::dvec3 sum(0.0);
          std::size_t step = 0;
          for (int k = 0; k < Most; ++k)
          {
            sum += glm::dvec3(
              ask(hits[n], static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(k)));
            if (((k + 1) & k) != 0)
              continue;
            const glm::dvec3 off = sum / double(k + 1) - truth[n];
            squares[n][step++] += glm::dot(off, off) / 3.0;
          }
        }
      });
  }
  ErrorOf errors;
  for (std::size_t step = 0; step < steps; ++step)
  {
    double sum = 0.0;
    for (const std::vector<double>& square : squares)
      sum += square[step];
    errors.emplace_back(double(1 << step), std::sqrt(sum / (double(hits.size()) * double(seeds))));
  }
  return errors;
}

/// Samples after which the error is so small: between those measured, or as their slope goes on.
double SamplesFor(const ErrorOf& errors, double error)
{
  for (std::size_t n = 0; n + 1 < errors.size(); ++n)
    if (errors[n + 1].second <= error)
    {
      const double part =
        std::log(errors[n].second / error) / std::log(errors[n].second / errors[n + 1].second);
      return errors[n].first * std::pow(2.0, std::max(0.0, part));
    }
  return errors.back().first *
         std::pow(errors.back().second / error, -1.0 / GrowthExponent(errors));
}

template <typename Points>
Timing TimeFor(const LitScene& scene, int bounces, const std::vector<SeenHit>& hits,
  std::uint64_t seed, double times)
{
  const Asked<Points> ask(scene, bounces, seed);
  const Timing time = TimeOf([&] { MeansOf(hits, At, ask); });
  return { time.wallS * times, time.cpuS * times };
}

void Draw(ReportContext& context, const std::string& id, const std::string& method,
  const ErrorOf& errors, double cpuSASample)
{
  ReportCurve curve{ id, method, "ms of CPU time", "RMSE", {} };
  for (const auto& [samples, error] : errors)
    curve.points.emplace_back(1e3 * samples * cpuSASample, error);
  context.report.curves.push_back(curve);
}

void Try(ReportContext& context, const LightData& data, const LitScene& scene,
  const std::vector<SeenHit>& hits, const char* name, int bounces)
{
  const std::uint64_t seed = context.settings.seed;
  const std::vector<glm::dvec3> truth =
    MeansOf(hits, Truth, Asked<SobolSequence>(scene, bounces, seed));
  const int seeds = context.settings.quick ? 2 : 8;
  const ErrorOf even = Errors<SobolSequence>(scene, bounces, hits, truth, seed, seeds),
                random = Errors<RandomSequence>(scene, bounces, hits, truth, seed, seeds);
  if (!(even.back().second > 0.0 && random.back().second > 0.0))
    throw std::runtime_error(
      "the light of this volume has no noise: it has no slope; give another --volume");
  const double evenSlope = GrowthExponent(even), randomSlope = GrowthExponent(random);
  double error = 0.0;
  for (const auto& [samples, rmse] : even)
    error = samples == At ? rmse : error;
  const double needed = SamplesFor(random, error);
  const PairedTimes times =
    ComparePairs([&] { return TimeFor<SobolSequence>(scene, bounces, hits, seed, 1.0); },
      [&] { return TimeFor<RandomSequence>(scene, bounces, hits, seed, needed / At); });
  char text[240];
  std::snprintf(text, sizeof text,
    ", %zu surface pixels, %d seeds, against %d even paths; 64 points do what %.0f random ones do; "
    "%.3g times the speed",
    hits.size(), seeds, Truth, needed, 1.0 / times.cpuRatio.median);
  const std::string id = std::string("light.sobol.") + name + data.tag;
  context.report.rows.push_back(
    CpuRatio(id, times, "independent random points, as many as make the same error",
      { error, "RMSE" }, data.data + text));
  ReportRow slope = ErrorFigure(std::string("light.sobol.") + name + ".slope" + data.tag,
    { error, "RMSE after 64" }, "", times.a, data.data + ", 1 to 256 samples, least squares");
  slope.value = evenSlope;
  slope.unit = "d log RMSE / d log samples";
  std::snprintf(text, sizeof text, "independent random points: %.3f", randomSlope);
  slope.rival = text;
  slope.n = int(even.size());
  context.report.rows.push_back(slope);
  Draw(context, id, "scrambled Sobol", even, times.a.cpuS / At);
  Draw(context, id, "random", random, times.b.cpuS / needed);
}

} // namespace

void MeasureSobol(ReportContext& context, const LightData& data, std::size_t pixels)
{
  const LitScene scene({ BodyOf(data.cells, { glm::vec3(0.8F) }) }, {}, Daylight());
  const std::vector<SeenHit> hits = SeenHits(scene, OrbitView(scene, 0.0, 96), pixels);
  for (const auto& [name, bounces] :
    { std::pair("ao", 0), std::pair("bounce1", 1), std::pair("bounce3", 3) })
  {
    context.progress(0.0, std::string("light: even points, ") + name + " on " + data.data);
    Try(context, data, scene, hits, name, bounces);
  }
}

} // namespace hasp
