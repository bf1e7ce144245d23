// Rays a second and bytes of the cells' tracer against Embree's own triangles.
#include "ReportCellsParts.h"

#include "CellDepth.h"
#include "CellRays.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "RivalMesh.h"
#include "RivalTriangles.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace hasp
{
namespace
{

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

/// Two cosine-weighted rays from each hit, from half a voxel above the surface: far enough from the
/// rival's triangles too.
std::vector<WorldRay> OcclusionRays(const DepthTruth& truth, std::uint64_t seed)
{
  std::vector<WorldRay> rays;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const glm::dvec3& s = GeometryOf(truth.grid).spacing;
  for (std::size_t n = 0; n < truth.hits.size(); ++n)
  {
    if (!truth.hits[n] || glm::length(truth.hits[n]->gradient) == 0.0)
      continue;
    glm::dvec3 up = glm::normalize(truth.hits[n]->gradient);
    if (glm::dot(up, truth.rays[n].direction) > 0.0)
      up = -up;
    const glm::dvec3 side = glm::normalize(
      glm::cross(up, std::abs(up.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 origin = truth.hits[n]->position + 0.5 * std::min({ s.x, s.y, s.z }) * up;
    for (int ray = 0; ray < 2; ++ray)
    {
      const double share = any(random), turn = glm::two_pi<double>() * any(random);
      const glm::dvec3 flat = std::cos(turn) * side + std::sin(turn) * glm::cross(up, side);
      rays.push_back({ origin, std::sqrt(1.0 - share) * up + std::sqrt(share) * flat });
    }
  }
  return rays;
}

std::string Errors(const DepthErrors& errors)
{
  char text[80];
  std::snprintf(text, sizeof text, "error %.2g voxel RMS, %.2g max; ", errors.rms, errors.maxAll);
  return text + errors.Text();
}

SurfacePoints PointsOf(std::span<const WorldRay> rays, std::span<const float> t)
{
  SurfacePoints points(rays.size());
  for (std::size_t n = 0; n < rays.size(); ++n)
    if (std::isfinite(t[n]))
      points[n] = rays[n].origin + double(t[n]) * rays[n].direction;
  return points;
}

/// One set of rays, ours against each way to ask the rival.
void CompareRays(ReportContext& context, const CellScene& scene, const std::string& id,
  const DepthTruth& truth, CellRays& ours, const RivalTriangles& rival)
{
  using Packets = RivalTriangles::Packets;
  std::vector<float> t(truth.rays.size());
  ours.SetRays(truth.rays);
  ours.Trace();
  const DepthErrors error = MeasureDepth(truth, ours.Points());
  for (const auto& [packets, name, what] :
    { std::tuple(Packets::One, "", "rtcIntersect1"),
      std::tuple(Packets::Coherent, ".packets", "rtcIntersect16, coherent rays"),
      std::tuple(Packets::Incoherent, ".packets.incoherent", "rtcIntersect16, incoherent rays") })
  {
    const PairedTimes times = ComparePairs([&] { return TimeOf([&] { ours.Trace(); }); },
      [&] { return TimeOf([&] { rival.Trace(truth.rays, t, packets); }); });
    char rate[120];
    std::snprintf(rate, sizeof rate,
      ", %zu rays, %.2f against %.2f million a second, ours one a call, ", t.size(),
      1e-6 * double(t.size()) / times.a.wallS, 1e-6 * double(t.size()) / times.b.wallS);
    context.report.rows.push_back(TimedRatio(id + name + scene.tag, times,
      rival.Name() + ", " + what + "; its " + Errors(MeasureRival(truth, PointsOf(truth.rays, t))),
      { error.rms, "voxel RMS" }, scene.data + rate + Errors(error), true));
  }
}

void AddBytes(ReportContext& context, const CellScene& scene, const RivalMesh& mesh,
  const CellRays& ours, const RivalTriangles& rival, const PairedTimes& build)
{
  const auto add = [&](const std::string& id, double bytes, double theirs, const std::string& name)
  {
    context.report.rows.push_back(FixedFigure(id + scene.tag, bytes / theirs, "ratio", name,
      { 0.0, "samples that differ from the volume" }, build,
      scene.data + ", " + std::to_string(ours.CellBytes()) + " bytes of cells, " +
        std::to_string(ours.TreeBytes()) + " beside them for tracing"));
  };
  const double all = double(ours.CellBytes() + ours.TreeBytes());
  add("cells.rays.memory", all, double(rival.MeshBytes() + rival.TreeBytes()),
    rival.Name() + ", " + std::to_string(rival.MeshBytes()) +
      " bytes of float positions and 32-bit indices, " + std::to_string(rival.TreeBytes()) +
      " of tree by Embree's monitor");
  add("cells.bytes.bvh", double(ours.TreeBytes()), double(mesh.CompactBytes()),
    "indexed mesh: 3x16-bit positions + octahedral normals + 32-bit indices");
}

} // namespace

void ReportCellRays(ReportContext& context, const CellScene& scene, int pixels)
{
  context.progress(0.0, "cells: rays on " + scene.data);
  RivalMesh mesh(scene);
  mesh.Extract(scene.isovalue);
  std::unique_ptr<CellRays> ours;
  std::unique_ptr<RivalTriangles> rival;
  const PairedTimes build = ComparePairs(
    [&]
    {
      ours.reset();
      return TimeOf([&] { ours = std::make_unique<CellRays>(scene); });
    },
    [&]
    {
      rival.reset();
      return TimeOf([&] { rival = std::make_unique<RivalTriangles>(mesh.Mesh()); });
    },
    { 1, 9 });
  context.report.rows.push_back(TimedRatio("cells.build.rays" + scene.tag, build,
    rival->Name() + "; the mesh is there already", { 0.0, "samples that differ from the volume" },
    scene.data + ", from the volume to the first ray"));
  AddBytes(context, scene, mesh, *ours, *rival, build);

  const IsosurfaceView view(scene.image, scene.isovalue, pixels, pixels, Oblique);
  const DepthTruth primary(view);
  CompareRays(context, scene, "cells.rays", primary, *ours, *rival);
  const DepthTruth occlusion(
    primary.grid, scene.isovalue, OcclusionRays(primary, context.settings.seed));
  CompareRays(context, scene, "cells.rays.ao", occlusion, *ours, *rival);
}

void ReportRandomRays(ReportContext& context, const CellScene& scene, std::int64_t rays)
{
  context.progress(0.0, "cells: " + std::to_string(rays) + " random rays on " + scene.data);
  CellRays ours(scene);
  const AnyGridView grid = ViewImage(scene.image);
  const GridGeometry& g = GeometryOf(grid);
  std::mt19937_64 random(context.settings.seed);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const auto place = [&]
  {
    return g.IndexToWorld(
      glm::dvec3(any(random), any(random), any(random)) * glm::dvec3(g.dims - 1));
  };
  DepthErrors all;
  Timing time;
  constexpr std::int64_t chunk = 1'000'000;
  for (std::int64_t done = 0; done < rays; done += chunk)
  {
    std::vector<WorldRay> some(std::size_t(std::min(chunk, rays - done)));
    for (WorldRay& ray : some) // from outside and inside, to anywhere
    {
      ray.origin = place();
      ray.direction = glm::normalize(place() - ray.origin);
      if (any(random) < 0.7)
        ray.origin -=
          2.0 * glm::length(g.IndexToWorld(glm::dvec3(g.dims - 1)) - g.origin) * ray.direction;
    }
    ours.SetRays(some);
    const Timing spent = TimeOf([&] { ours.Trace(); });
    time = { time.wallS + spent.wallS, time.cpuS + spent.cpuS };
    const DepthErrors errors =
      MeasureDepth(DepthTruth(grid, scene.isovalue, std::move(some)), ours.Points());
    all.surface += errors.surface;
    all.missed += errors.missed;
    all.invented += errors.invented;
    all.tangent += errors.tangent;
    all.max = std::max(all.max, errors.max);
    all.maxAll = std::max(all.maxAll, errors.maxAll);
    context.progress(double(done) / double(rays), "");
  }
  const char* const truth = "a walk from cell to cell and bisection, both in long double";
  const std::string data = scene.data + ", " + std::to_string(rays) + " random rays, " + all.Text();
  context.report.rows.push_back(ErrorFigure("cells.missed.random" + scene.tag,
    { all.MissedShare(), "share of rays that meet the surface" }, truth, time, data));
  context.report.rows.push_back(
    ErrorFigure("cells.depth.max.random" + scene.tag, { all.max, "voxel" }, truth, time, data));
}

} // namespace hasp
