// A sphere on a plane: what it hides of the sky is known in closed form.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double Radius = 25.0;

/// Radiance of a white plane at the place under the environment, by the sphere's own equation: all
/// pixels of the map in 4 x 4 parts, each with its solid angle.
double BruteForce(const Environment& far, const glm::dvec3& place)
{
  constexpr int Rows = 512, Columns = 2048; // of the upper half of 256 x 512 pixels
  const glm::dvec3 toMiddle = glm::dvec3(0, 0, Radius) - place;
  double sum = 0.0;
  for (int y = 0; y < Rows; ++y)
  {
    const double top = glm::half_pi<double>() * y / Rows,
                 bottom = glm::half_pi<double>() * (y + 1) / Rows, from = 0.5 * (top + bottom);
    const double solid =
      (std::cos(top) - std::cos(bottom)) * glm::two_pi<double>() / double(Columns);
    for (int x = 0; x < Columns; ++x)
    {
      const double turn = glm::two_pi<double>() * (x + 0.5) / Columns;
      const glm::dvec3 direction(
        std::sin(from) * std::cos(turn), std::sin(from) * std::sin(turn), std::cos(from));
      const double along = glm::dot(direction, toMiddle);
      if (along > 0.0 && glm::dot(toMiddle, toMiddle) - along * along < Radius * Radius)
        continue;
      const glm::vec3 light = far.Radiance(direction);
      sum += (double(light.r) + light.g + light.b) / 3.0 * direction.z * solid;
    }
  }
  return sum / glm::pi<double>();
}

struct Places
{
  std::vector<SeenHit> hits;
  std::vector<double> ways; ///< from where the sphere touches the plane, mm
};

Places PlacesOf(const LitScene& scene, int count)
{
  Places places;
  for (int n = 0; n < count; ++n)
  {
    const double way = Radius * (0.3 + 2.7 * n / count), turn = 2.4 * n; // all around
    const glm::dvec3 above(way * std::cos(turn), way * std::sin(turn), 1e-3 * Radius);
    if (const auto hit = scene.Trace(above, { 0, 0, -1 }))
    {
      places.hits.push_back({ *hit, { 0, 0, 1 } });
      places.ways.push_back(way);
    }
  }
  return places;
}

void AddSphere(ReportContext& context, const std::string& id, const LitScene& scene,
  const Places& places, const std::vector<double>& truth, const std::string& by)
{
  const int samples = context.settings.quick ? 8192 : 65536;
  const PathTracer<SobolSequence> tracer(scene, { 1 });
  std::vector<glm::dvec3> means;
  const Timing time = TimeOf(
    [&]
    {
      means = MeansOf(places.hits, samples,
        [&](const SeenHit& seen, std::uint32_t place, std::uint32_t number)
        {
          SobolSequence points(SeedOf(context.settings.seed, place), number);
          return tracer.Radiance(seen.hit, seen.towardsEye, points).radiance;
        });
    });
  double worst = 0.0;
  for (std::size_t n = 0; n < truth.size(); ++n)
    worst = std::max(worst, std::abs((means[n].x + means[n].y + means[n].z) / 3.0 - truth[n]));
  ReportRow row = ErrorFigure(id, { worst, "of what an open plane sends out" }, by, time,
    "a ball of cells on a square of triangles, " + std::to_string(truth.size()) + " places, " +
      std::to_string(samples) + " paths each; the worst place");
  row.bars = { { {}, 0.01 } };
  context.report.rows.push_back(row);
}

} // namespace

void MeasureSphere(ReportContext& context)
{
  context.progress(0.0, "light: a sphere on a plane");
  const auto ball = CellsOf(AnalyticSphere({ 0, 0, Radius }, Radius), 97, 56.0);
  const auto sceneUnder = [&](std::shared_ptr<const Environment> far)
  {
    return LitScene(
      { BodyOf(ball, { glm::vec3(0.0F) }), BodyOf(SquareMesh(40.0 * Radius), { glm::vec3(1.0F) }) },
      {}, std::move(far));
  };
  const LitScene even = sceneUnder(UniformLight(1.0F));
  const Places places = PlacesOf(even, context.settings.quick ? 12 : 48);
  std::vector<double> open;
  for (const double way : places.ways) // 1 - cos / d^2 of the sphere's form factor
    open.push_back(1.0 - std::pow(Radius / std::hypot(way, Radius), 3.0));
  AddSphere(context, "light.sphere", even, places, open,
    "closed form: form factor of a sphere above a plane, light from everywhere");
  const auto sky = Daylight();
  std::vector<double> lit(places.ways.size());
  ParallelFor(0, std::int64_t(lit.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        lit[n] = BruteForce(*sky, places.hits[n].hit.position);
    });
  AddSphere(context, "light.sphere.sky", sceneUnder(sky), places, lit,
    "brute force: a million directions of daylight, the sphere by its equation");
}

} // namespace hasp
