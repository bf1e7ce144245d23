// A sphere on a plane: what it hides of the sky is known in closed form.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double Radius = 25.0;

/// Does the sphere leave that way open?
bool Open(const glm::dvec3& direction, const glm::dvec3& toMiddle)
{
  const double along = glm::dot(direction, toMiddle);
  return along <= 0.0 || glm::dot(toMiddle, toMiddle) - along * along >= Radius * Radius;
}

/// Radiance of a white plane at the place under daylight, by the sphere's own equation: all pixels
/// of the map that are above it in 4 x 4 parts, those of the sun in 32 x 32, each with its solid
/// angle.
double BruteForce(const Environment& far, const glm::dvec3& place)
{
  constexpr int Rows = 128, Columns = 512; // the upper half of the map
  constexpr double Step = glm::half_pi<double>() / Rows;
  const glm::dvec3 toMiddle = glm::dvec3(0, 0, Radius) - place;
  const auto towards = [](double down, double turn)
  {
    return glm::dvec3(
      std::sin(down) * std::cos(turn), std::sin(down) * std::sin(turn), std::cos(down));
  };
  double sum = 0.0;
  for (int y = 0; y < Rows; ++y)
    for (int x = 0; x < Columns; ++x)
    {
      const glm::vec3 light = far.Radiance(towards(Step * (y + 0.5), Step * (x + 0.5)));
      const double bright = (double(light.r) + light.g + light.b) / 3.0;
      const int parts = bright > 10.0 ? 32 : 4;
      const double part = Step / parts;
      for (int j = 0; j < parts; ++j)
      {
        const double top = Step * y + part * j,
                     solid = part * (std::cos(top) - std::cos(top + part));
        for (int i = 0; i < parts; ++i)
        {
          const glm::dvec3 direction = towards(top + 0.5 * part, Step * x + part * (i + 0.5));
          if (Open(direction, toMiddle))
            sum += bright * direction.z * solid;
        }
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
  // Cells of half a millimetre: the ball is 0.003 mm too small.
  LitBody ball =
    BodyOf(CellsOf(AnalyticSphere({ 0, 0, 0 }, Radius), 97, 26.5), { glm::vec3(0.0F) });
  ball.bodyToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, Radius));
  const auto sceneUnder = [&](std::shared_ptr<const Environment> far)
  {
    return LitScene(
      { ball, BodyOf(SquareMesh(40.0 * Radius), { glm::vec3(1.0F) }) }, {}, std::move(far));
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
