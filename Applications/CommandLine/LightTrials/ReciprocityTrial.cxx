// A lamp and an eye change places: the same light arrives.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace hasp
{
namespace
{

constexpr int Batches = 32; // independent: their spread is the error

struct Estimate
{
  double mean = 0.0, variance = 0.0; ///< of the mean
};

glm::dvec3 AnyDirection(const glm::dvec2& p)
{
  const double z = 1.0 - 2.0 * p.y, r = std::sqrt(std::max(0.0, 1.0 - z * z)),
               turn = glm::two_pi<double>() * p.x;
  return { r * std::cos(turn), r * std::sin(turn), z };
}

/// Light that arrives at a place from all sides, of a lamp elsewhere, by way of surfaces.
Estimate Arriving(const std::vector<LitBody>& bodies, const glm::dvec3& lamp, const glm::dvec3& eye,
  int samples, std::uint64_t seed)
{
  LitLamp small;
  small.place = glm::dvec4(lamp, 1.0);
  small.attenuation = { 0.0F, 0.0F, 1.0F };
  const LitScene scene(bodies, { small }, UniformLight(0.0F));
  const PathTracer<SobolSequence> tracer(scene, { 4 });
  std::vector<double> means(Batches, 0.0);
  ParallelFor(0, Batches, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
        for (int n = 0; n < samples; ++n)
        {
          SobolSequence points(SeedOf(seed, std::size_t(b)), static_cast<std::uint32_t>(n));
          const glm::dvec3 direction = AnyDirection(points.Next());
          const glm::vec3 light = tracer.Incoming(eye, direction, points).radiance;
          means[b] += (double(light.r) + light.g + light.b) / (3.0 * samples);
        }
    });
  Estimate estimate;
  for (const double mean : means)
    estimate.mean += mean / Batches;
  for (const double mean : means)
    estimate.variance += std::pow(mean - estimate.mean, 2) / (Batches * (Batches - 1.0));
  return estimate;
}

} // namespace

void MeasureReciprocity(ReportContext& context)
{
  context.progress(0.0, "light: lamp and eye change places");
  const bool quick = context.settings.quick;
  const int pairs = quick ? 6 : 24, samples = quick ? 2048 : 16384;
  // All kinds of material; mesh and cells.
  const std::vector<LitBody> bodies{ BodyOf(CellsOf(AnalyticSphere({ 0, 0, 30 }, 25.0), 48, 57.0),
                                       { glm::vec3(0.9F, 0.7F, 0.5F), 0.3F, 0.4F }),
    BodyOf(CellsOf(AnalyticSphere({ 20, 60, 15 }, 10.0), 97, 80.0),
      { glm::vec3(0.9F), 0.0F, 0.6F, 1.0F }),
    BodyOf(SquareMesh(200.0), { glm::vec3(0.8F) }) };
  std::mt19937_64 random(context.settings.seed);
  const auto place = [&] // above the plane, apart from the balls
  {
    std::uniform_real_distribution<double> across(-70.0, 70.0), up(20.0, 100.0);
    glm::dvec3 p;
    do
    {
      p.x = across(random);
      p.y = across(random);
      p.z = up(random);
    } while (glm::distance(p, { 0, 0, 30 }) < 45.0 || glm::distance(p, { 20, 60, 15 }) < 25.0);
    return p;
  };
  double sigmas = 0.0, relative = 0.0, noise = 0.0;
  const Timing time = TimeOf(
    [&]
    {
      for (int pair = 0; pair < pairs; ++pair)
      {
        const glm::dvec3 a = place(), b = place();
        const std::uint64_t seed = 2 * (1000 * context.settings.seed + std::uint64_t(pair));
        const Estimate there = Arriving(bodies, a, b, samples, seed),
                       back = Arriving(bodies, b, a, samples, seed + 1);
        const double off = std::abs(there.mean - back.mean),
                     sigma = std::sqrt(there.variance + back.variance);
        sigmas = std::max(sigmas, off / sigma);
        relative = std::max(relative, off / (0.5 * (there.mean + back.mean)));
        noise = std::max(noise, sigma / (0.5 * (there.mean + back.mean)));
        context.progress(double(pair + 1) / pairs, "");
      }
    });
  char text[200];
  std::snprintf(text, sizeof text,
    "%d pairs of places over two balls and a square, coat, metal and diffuse, 4 bounces, %d paths "
    "each way; the worst pair; standard error up to %.2g of the light",
    pairs, Batches * samples, noise);
  ReportRow row = ErrorFigure("light.reciprocity", { relative, "of the light, at most" },
    "the same with lamp and eye the other way round", time, text);
  row.value = sigmas;
  row.unit = "standard errors";
  row.n = pairs;
  row.bars = { { {}, 4.0 } };
  context.report.rows.push_back(row);
}

} // namespace hasp
