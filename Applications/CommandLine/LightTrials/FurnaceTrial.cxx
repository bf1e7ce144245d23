// The white furnace: where the same light comes from everywhere and nothing is lost, everything
// looks like the light itself.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr int Rings = 8; // of a ball, by the angle to the eye: each is to be 1 by itself
constexpr double Bar = 0.01;

struct Furnace
{
  double worst = 0.0; ///< deviation from 1 of a ring's mean
  std::string where;
  Timing time;
  std::int64_t paths = 0;
};

/// Deviation of each group's mean from 1; group(number, hit) in [0, Rings).
template <typename Group>
void Heat(Furnace& furnace, const LitScene& scene, int bounces, int side, int samples,
  std::uint64_t seed, const std::string& where, const Group& group)
{
  const PathTracer<SobolSequence> tracer(scene, { bounces });
  const std::vector<SeenHit> hits = SeenHits(scene, OrbitView(scene, 20.0, side));
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
  furnace.paths += std::int64_t(hits.size()) * samples;
  std::array<double, Rings> sums{}, counts{};
  for (std::size_t n = 0; n < hits.size(); ++n)
  {
    const auto ring = std::size_t(group(n, hits[n]));
    sums[ring] += (means[n].x + means[n].y + means[n].z) / 3.0;
    counts[ring] += 1.0;
  }
  for (std::size_t ring = 0; ring < Rings; ++ring)
  {
    const double off = counts[ring] > 0.0 ? std::abs(sums[ring] / counts[ring] - 1.0) : 0.0;
    if (off < furnace.worst)
      continue;
    furnace.worst = off;
    furnace.where = where;
  }
}

int RingOf(std::size_t, const SeenHit& seen)
{
  const double cosine = std::clamp(glm::dot(seen.hit.normal, seen.towardsEye), 0.0, 1.0);
  return std::min(Rings - 1, int(Rings * cosine));
}

void AddFurnace(ReportContext& context, const std::string& id, const Furnace& furnace,
  const std::string& data)
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
  for (const float roughness : { 0.03F, 0.2F, 0.5F, 1.0F })
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

void MeasureFurnace(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const int side = quick ? 32 : 64, samples = quick ? 256 : 1024;
  const std::uint64_t seed = context.settings.seed;
  const auto ball = CellsOf(AnalyticSphere({ 0, 0, 0 }, 25.0), 48, 30.0);
  for (const char* kind : { "diffuse", "coat", "metal" })
  {
    context.progress(0.0, std::string("light: a white furnace, ") + kind);
    Furnace furnace;
    for (const auto& [name, material] : Materials(kind))
      Heat(furnace, LitScene({ BodyOf(ball, material) }, {}, UniformLight(1.0F)), 64, side, samples,
        seed, name, RingOf);
    AddFurnace(context, kind, furnace, "a ball of cells, rings by the angle to the eye");
  }
  context.progress(0.0, "light: a white furnace, concave");
  // Two periods, closed at its ends: channels that light leaves after some dozen bounces.
  const auto gyroid = CellsOf(AnalyticGyroid(24.0), 48, 24.0);
  Furnace furnace;
  for (const auto& [name, material] :
    { std::pair<const char*, SurfaceMaterial>{ "diffuse", { glm::vec3(1.0F) } },
      { "coat", { glm::vec3(1.0F), 0.04F, 0.5F } },
      { "metal", { glm::vec3(1.0F), 0.0F, 0.5F, 1.0F } } })
    Heat(furnace, LitScene({ BodyOf(gyroid, material) }, {}, UniformLight(1.0F)), 64, side,
      samples / 4, seed, name,
      [](std::size_t n, const SeenHit&) { return n % Rings; }); // every eighth pixel
  AddFurnace(context, "concave", furnace,
    "a gyroid of two periods, 64 bounces: diffuse, coated and metal, in eight groups of pixels");
}

} // namespace hasp
