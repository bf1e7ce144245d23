// The white furnace: where the same light comes from everywhere and nothing is lost, everything
// looks like the light itself.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Isosurface/Hemisphere.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr std::size_t Rings = 8; // by the angle to the eye: each is to be 1 by itself
constexpr double Bar = 0.01;

struct Furnace
{
  double worst = 0.0; ///< deviation from 1 of a group's mean
  std::string where;
  Timing time;
  std::size_t paths = 0;
};

/// The hits' means, in groups of `together` on end, against 1.
void Heat(Furnace& furnace, const LitScene& scene, const std::vector<SeenHit>& hits,
  std::size_t together, int samples, std::uint64_t seed, const std::string& where)
{
  const PathTracer<SobolSequence> tracer(scene, { 64 });
  std::vector<glm::dvec3> means;
  const Timing time = TimeOf(
    [&]
    {
      means = MeansOf(hits, samples,
        [&](const SeenHit& seen, std::uint32_t place, std::uint32_t number)
        {
          SobolSequence points(SeedOf(seed, place), number);
          return tracer.Radiance(seen.hit, seen.towardsEye, points).radiance;
        });
    });
  furnace.time = { furnace.time.wallS + time.wallS, furnace.time.cpuS + time.cpuS };
  furnace.paths += hits.size() * std::size_t(samples);
  for (std::size_t first = 0; first + together <= hits.size(); first += together)
  {
    glm::dvec3 sum(0.0);
    for (std::size_t n = first; n < first + together; ++n)
      sum += means[n] / double(together);
    const double off = std::abs((sum.x + sum.y + sum.z) / 3.0 - 1.0);
    if (off < furnace.worst)
      continue;
    furnace.worst = off;
    char text[60];
    std::snprintf(text, sizeof text, ", cosine to the eye %.3g to %.3g",
      double(first) / double(hits.size()), double(first + together) / double(hits.size()));
    furnace.where = where + (together < hits.size() ? text : "");
  }
}

/// `each` hits of a scene for each ring, seen from all around, evenly in the cosine.
std::vector<SeenHit> RingsOf(const LitScene& scene, std::size_t each, std::uint64_t seed)
{
  const std::vector<SeenHit> seen = SeenHits(scene, OrbitView(scene, 20.0, 32), each);
  std::vector<SeenHit> hits;
  for (std::size_t n = 0; n < Rings * each; ++n)
  {
    SeenHit hit = seen[n % seen.size()];
    const double cosine = (double(n) + 0.5) / double(Rings * each),
                 turn = RandomSequence(SeedOf(seed, n), 0).Next1() * glm::two_pi<double>(),
                 sine = std::sqrt(1.0 - cosine * cosine);
    hit.towardsEye = FrameAround(hit.hit.normal) *
                     glm::dvec3(sine * std::cos(turn), sine * std::sin(turn), cosine);
    hits.push_back(hit);
  }
  return hits;
}

void AddFurnace(
  ReportContext& context, const std::string& id, const Furnace& furnace, const std::string& data)
{
  ReportRow row = ErrorFigure("light.furnace." + id, { furnace.worst, "of radiance 1" },
    "the furnace itself: 1", furnace.time,
    data + ", " + std::to_string(furnace.paths) + " paths; worst: " + furnace.where);
  row.bars = { { {}, Bar } };
  context.report.rows.push_back(row);
}

/// The same of rough and smooth ones.
std::vector<std::pair<std::string, SurfaceMaterial>> Materials(const std::string& kind)
{
  if (kind == "diffuse")
    return { { "diffuse", { glm::vec3(1.0F) } } };
  std::vector<std::pair<std::string, SurfaceMaterial>> all;
  const auto add = [&](float specular, float roughness, float metallic)
  {
    char text[60];
    std::snprintf(text, sizeof text, "specular %.2g, roughness %.2g", specular, roughness);
    all.emplace_back(text, SurfaceMaterial{ glm::vec3(1.0F), specular, roughness, metallic });
  };
  for (const float roughness : { 0.03F, 0.1F, 0.2F, 0.3F, 0.5F, 1.0F })
  {
    if (kind == "metal")
      add(0.0F, roughness, 1.0F);
    else
      for (const float specular : { 0.04F, 0.5F })
        add(specular, roughness, 0.0F);
  }
  return all;
}

} // namespace

void MeasureFurnace(ReportContext& context, int samples)
{
  const std::uint64_t seed = context.settings.seed;
  const auto ball = CellsOf(AnalyticSphere({ 0, 0, 0 }, 25.0), 48, 30.0);
  constexpr std::size_t Each = 64;
  for (const char* kind : { "diffuse", "coat", "metal" })
  {
    context.progress(0.0, std::string("light: a white furnace, ") + kind);
    Furnace furnace;
    for (const auto& [name, material] : Materials(kind))
    {
      const LitScene scene({ BodyOf(ball, material) }, {}, UniformLight(1.0F));
      Heat(furnace, scene, RingsOf(scene, Each, seed), Each, samples, seed, name);
    }
    AddFurnace(context, kind, furnace, "a ball of cells, seen from eight ranges of angles");
  }
  context.progress(0.0, "light: a white furnace, concave");
  // Two periods, closed at its ends: channels that light leaves after some dozen bounces.
  const auto gyroid = CellsOf(AnalyticGyroid(24.0), 48, 24.0);
  Furnace furnace;
  for (const auto& [name, material] :
    { std::pair<const char*, SurfaceMaterial>{ "diffuse", { glm::vec3(1.0F) } },
      { "coat, roughness 0.5", { glm::vec3(1.0F), 0.04F, 0.5F } },
      { "metal, roughness 0.5", { glm::vec3(1.0F), 0.0F, 0.5F, 1.0F } },
      { "metal, roughness 0.2", { glm::vec3(1.0F), 0.0F, 0.2F, 1.0F } } })
  {
    const LitScene scene({ BodyOf(gyroid, material) }, {}, UniformLight(1.0F));
    const auto hits = SeenHits(scene, OrbitView(scene, 20.0, 48));
    Heat(furnace, scene, hits, hits.size(), samples / 4, seed, name);
  }
  AddFurnace(context, "concave", furnace,
    "a gyroid of two periods, 64 bounces: diffuse, coated and metal, a whole picture");
}

} // namespace hasp
