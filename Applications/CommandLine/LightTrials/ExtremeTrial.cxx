// Extreme light and an extreme eye, each against a closed form.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hasp
{
namespace
{

/// Says of a figure that is no number that it is beyond any bar.
double Numbered(double figure)
{
  return std::isfinite(figure) ? figure : std::numeric_limits<double>::max();
}

void AddExtreme(ReportContext& context, const std::string& id, double error,
  const std::string& unit, const std::string& truth, const Timing& time, const std::string& data,
  double bar)
{
  ReportRow row = ErrorFigure("light.extreme." + id, { Numbered(error), unit }, truth, time, data);
  row.bars = { { {}, bar } };
  context.report.rows.push_back(row);
}

EnvironmentMap MapWithAPixel(float others, float bright, const glm::ivec2& at)
{
  EnvironmentMap map;
  map.size = { 256, 128 };
  map.pixels.assign(256 * 128, glm::vec3(others));
  map.pixels[std::size_t(at.y) * 256 + at.x] = glm::vec3(bright);
  return map;
}

/// Radiance of a white plane that faces up, in the open: pixel by pixel.
double OpenPlane(const EnvironmentMap& map)
{
  double sum = 0.0;
  for (int y = 0; y < map.size.y / 2; ++y)
  {
    const double top = glm::pi<double>() * y / map.size.y,
                 bottom = glm::pi<double>() * (y + 1) / map.size.y;
    // The integral of cos over the row: sin^2 / 2 by its two ends.
    const double row = 0.5 * (std::pow(std::sin(bottom), 2) - std::pow(std::sin(top), 2)) *
                       glm::two_pi<double>() / map.size.x;
    for (int x = 0; x < map.size.x; ++x)
      sum += map.pixels[std::size_t(y) * map.size.x + x].g * row;
  }
  return sum / glm::pi<double>();
}

/// One pixel is a million: no sample is beyond what is stated, none is no number, and the mean is
/// right.
void TryPixel(ReportContext& context)
{
  const EnvironmentMap map = MapWithAPixel(0.1F, 1e6F, { 77, 20 });
  const LitScene plane({ BodyOf(SquareMesh(100.0), { glm::vec3(1.0F) }) }, {},
    std::make_shared<const Environment>(map));
  const PathTracer<SobolSequence> open(plane, { 1 });
  const int samples = context.settings.quick ? 1 << 14 : 1 << 18;
  const auto hit = *plane.Trace({ 3, 5, 10 }, { 0, 0, -1 });
  double mean = 0.0, largest = 0.0;
  const Timing planeTime = TimeOf(
    [&]
    {
      for (int n = 0; n < samples; ++n)
      {
        SobolSequence points(SeedOf(context.settings.seed, 1), static_cast<std::uint32_t>(n));
        mean += double(open.Radiance(hit, { 0, 0, 1 }, points).radiance.g) / samples;
      }
    });
  AddExtreme(context, "pixel.mean", std::abs(mean / OpenPlane(map) - 1.0), "relative",
    "closed form: the sum over all pixels", planeTime,
    "an open plane, a pixel of 1e6 in a map of 0.1", 0.01);

  const auto far = std::make_shared<const Environment>(map);
  const LitScene scene({ BodyOf(CellsOf(AnalyticGyroid(16.0), 40, 20.0), { glm::vec3(0.9F) }),
                         BodyOf(SquareMesh(100.0), { glm::vec3(0.9F) }) },
    {}, far);
  const PathTracer<SobolSequence> paths(scene, { 8 });
  const std::vector<SeenHit> hits =
    SeenHits(scene, OrbitView(scene, 0.0, context.settings.quick ? 48 : 128));
  std::vector<double> most(hits.size(), 0.0);
  const Timing time = TimeOf(
    [&]
    {
      MeansOf(hits, 64,
        [&](const SeenHit& seen, std::uint32_t place, std::uint32_t number)
        {
          SobolSequence points(SeedOf(context.settings.seed, place), number);
          const glm::vec3 light = paths.Radiance(seen.hit, seen.towardsEye, points).radiance;
          most[place] = std::isfinite(light.g) ? std::max(most[place], double(light.g))
                                               : std::numeric_limits<double>::infinity();
          return light;
        });
    });
  for (const double one : most)
    largest = std::max(largest, one);
  AddExtreme(context, "pixel", largest / paths.BrightestSample(), "of the stated bound, at most",
    "PathTracer::BrightestSample", time,
    "a gyroid on a plane, 8 bounces, a pixel of 1e6 in a map of 0.1, " +
      std::to_string(64 * hits.size()) + " samples; one that is no number counts as infinite",
    1.0);
}

void TryBlack(ReportContext& context)
{
  EnvironmentMap map = MapWithAPixel(0.0F, 0.0F, { 0, 0 });
  const LitScene scene(
    { BodyOf(CellsOf(AnalyticGyroid(16.0), 40, 20.0), { glm::vec3(1.0F), 0.5F, 0.03F }) }, {},
    std::make_shared<const Environment>(std::move(map)));
  LightPixels pixels;
  const Timing time =
    TimeOf([&] { pixels = PixelsOf(TracePaths(scene, OrbitView(scene, 0.0, 64), 8, 8, 1)); });
  double most = 0.0;
  for (const glm::vec4& pixel : pixels)
    for (int c = 0; c < 3; ++c)
      most = std::isfinite(pixel[c]) ? std::max(most, double(std::abs(pixel[c])))
                                     : std::numeric_limits<double>::infinity();
  AddExtreme(context, "black", most, "radiance", "no light: 0", time,
    "a coated gyroid, 8 bounces, a black map", 0.0);
}

/// An eye in bone, in a hollow ball with a lamp in its middle: the integrating sphere. Outside it
/// is bright, and none of that gets in.
void TryInside(ReportContext& context)
{
  constexpr double Radius = 25.0;
  constexpr float Albedo = 0.8F;
  constexpr int Bounces = 3;
  LitLamp lamp;
  lamp.place = { 0, 0, 0, 1 };
  lamp.attenuation = { 0.0F, 0.0F, 1.0F };
  lamp.color = glm::vec3(static_cast<float>(Radius * Radius));
  const LitScene scene(
    { BodyOf(CellsOf(AnalyticSphere({ 0, 0, 0 }, Radius), 64, 30.0), { glm::vec3(Albedo) }) },
    { lamp }, UniformLight(1e3F));
  const PathTracer<SobolSequence> paths(scene, { Bounces });
  double truth = 0.0;
  for (int bounce = 1; bounce <= Bounces; ++bounce)
    truth += std::pow(double(Albedo), bounce);
  std::vector<SeenHit> hits;
  for (int n = 0; n < 64; ++n)
  {
    SobolSequence points(SeedOf(context.settings.seed, 5), static_cast<std::uint32_t>(n));
    const glm::dvec2 p = points.Next();
    const glm::dvec3 eye(5, -8, 3);
    const double z = 1.0 - 2.0 * p.y, r = std::sqrt(1.0 - z * z),
                 turn = glm::two_pi<double>() * p.x;
    const glm::dvec3 direction(r * std::cos(turn), r * std::sin(turn), z);
    if (const auto hit = scene.Trace(eye, direction))
      hits.push_back({ *hit, -direction });
  }
  std::vector<glm::dvec3> means;
  const Timing time = TimeOf(
    [&]
    {
      means = MeansOf(hits, 1024,
        [&](const SeenHit& seen, std::uint32_t place, std::uint32_t number)
        {
          SobolSequence points(SeedOf(context.settings.seed, place), number);
          return paths.Radiance(seen.hit, seen.towardsEye, points).radiance;
        });
    });
  double worst = hits.size() == 64 ? 0.0 : std::numeric_limits<double>::infinity();
  for (const glm::dvec3& mean : means)
    worst = std::max(worst, std::abs(mean.y / truth - 1.0));
  AddExtreme(context, "inside", worst, "relative",
    "closed form: the integrating sphere, a + a^2 + a^3 of the lamp's light", time,
    "an eye in bone beside a lamp, 64 ways to look, 3 bounces; outside a light of 1000", 0.01);
}

} // namespace

void MeasureLightExtremes(ReportContext& context)
{
  context.progress(0.0, "light: extreme light");
  TryPixel(context);
  TryBlack(context);
  TryInside(context);
}

} // namespace hasp
