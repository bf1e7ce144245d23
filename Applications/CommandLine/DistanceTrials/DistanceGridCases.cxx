#include "DistanceCase.h"
#include "DistanceCases.h"
#include "DistanceErrors.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Steps from one voxel: the metric of <3,4,5> itself, within a cube of so many voxels.
void AddMetric(ReportContext& context)
{
  constexpr int Reach = 63;
  const GridGeometry grid{ glm::ivec3(Reach + 1), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> coverage(grid.Size(), 0.0F);
  coverage[0] = 1.0F;
  const std::vector<float> distances = ChamferDistance(grid, coverage);
  double overLargest = 0.0, high = 0.0, low = 0.0;
  for (std::size_t v = 1; v < distances.size(); ++v)
  {
    const glm::dvec3 p(
      v % (Reach + 1), v / (Reach + 1) % (Reach + 1), v / ((Reach + 1) * (Reach + 1)));
    const double steps = distances[v] + 0.5; // the surface is half a voxel from the centre
    const double euclid = glm::length(p);
    overLargest = std::max(overLargest, std::abs(steps - euclid) / std::max({ p.x, p.y, p.z }));
    high = std::max(high, steps / euclid - 1.0);
    low = std::min(low, steps / euclid - 1.0);
  }
  const auto add = [&](const char* id, const char* text, double figure, double predicted)
  {
    char words[160];
    std::snprintf(words, sizeof words, "%s: predicted %.5f, is %.5f", text, predicted, figure);
    AddCase(context, std::string("distance.metric.") + id, words, std::abs(figure - predicted),
      5e-4, "off the prediction");
  };
  // (1 + 2t/3) - sqrt(1 + 2t^2) at t = 1/sqrt(7); along (3,1,1); along (1,1,0).
  const double t = 1.0 / std::sqrt(7.0);
  add("largest", "<3,4,5> off Euclid, of the largest coordinate", overLargest,
    1.0 + 2.0 * t / 3.0 - std::sqrt(1.0 + 2.0 * t * t));
  add("high", "<3,4,5> longer than Euclid at most", high, 11.0 / 3.0 / std::sqrt(11.0) - 1.0);
  add("low", "<3,4,5> shorter than Euclid at most", low, 4.0 / 3.0 / std::sqrt(2.0) - 1.0);
}

/// Far along one axis: sums of 2,000 floats, and no counter that overflows.
void AddLines(ReportContext& context)
{
  constexpr int Length = 2048;
  for (const NamedTransform& transform : TrialTransforms)
    for (int axis = 0; axis < 3; ++axis)
    {
      GridGeometry grid{ glm::ivec3(1), glm::dvec3(0), glm::dvec3(5.0), glm::dmat3(1) };
      grid.dims[axis] = Length;
      grid.spacing[axis] = 0.05;
      std::vector<float> coverage(Length, 0.0F);
      coverage[0] = 1.0F;
      const std::vector<float> distances = transform.run(grid, coverage);
      double worst = 0.0;
      for (int n = 1; n < Length; ++n)
        worst = std::max(worst, std::abs(distances[n] - (n - 0.5) * 0.05));
      AddCase(context, std::string("distance.line.") + transform.name + "." + "xyz"[axis],
        "2048 voxels of 0.05 mm in a line, the first inside", worst / 0.05, 0.2, "voxel at most");
    }
}

void AddSaturated(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(24);
  for (const NamedTransform& transform : TrialTransforms)
    for (const bool inside : { false, true })
    {
      const std::vector<float> coverage(grid.Size(), inside ? 1.0F : 0.0F);
      const std::vector<float> distances = transform.run(grid, coverage);
      const auto off = std::count_if(distances.begin(), distances.end(),
        [&](float distance) { return distance != (inside ? -Infinity : Infinity); });
      AddCase(context, std::string("distance.") + (inside ? "full." : "empty.") + transform.name,
        inside ? "all inside: -infinity" : "nothing inside: +infinity", static_cast<double>(off),
        0.0, "other values");
    }
}

/// One voxel alone: what is known of it is its box.
void AddOneVoxel(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(25);
  std::vector<float> coverage(grid.Size(), 0.0F);
  const std::size_t middle = grid.Size() / 2;
  coverage[middle] = 1.0F;
  for (const NamedTransform& transform : TrialTransforms)
  {
    const std::vector<float> distances = transform.run(grid, coverage);
    double worst = 0.0;
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      const glm::dvec3 p = glm::dvec3(v % 25, v / 25 % 25, v / 625) - 12.0;
      const double ball = glm::length(p) - 0.5; // of the voxel's width
      worst = std::max(worst, std::abs(distances[v] / TrialVoxelMm - ball) / std::max(1.0, ball));
    }
    // <3,4,5>: its metric. The guides' transform has one plane a voxel: it answers for all sides.
    const std::string name = transform.name;
    const double limit = name == "exact" ? 1e-5 : name == "guide" ? 1.01 : 0.13;
    AddCase(context, std::string("distance.voxel.") + transform.name,
      "one voxel alone is a ball of its width", worst, limit, "of the distance, or voxel");
  }
}

/// The share of each voxel behind a plane: exact along the axis that it changes most on, 16^2 lines
/// of it a voxel.
std::vector<float> PlaneCoverage(
  const GridGeometry& grid, const glm::dvec3& at, const glm::dvec3& normal)
{
  const glm::dvec3 steps = normal * grid.spacing; // of the plane's distance, an index each
  int axis = 0;
  for (int other : { 1, 2 })
    axis = std::abs(steps[other]) > std::abs(steps[axis]) ? other : axis;
  std::vector<float> coverage(grid.Size());
  for (std::size_t v = 0; v < coverage.size(); ++v)
  {
    const std::size_t nx = grid.dims.x, ny = grid.dims.y;
    const glm::dvec3 index(v % nx, v / nx % ny, v / (nx * ny));
    const double middle = glm::dot(normal, grid.IndexToWorld(index) - at);
    double sum = 0.0;
    for (int s = 0; s < 256; ++s)
      sum += std::clamp(0.5 - (middle + steps[(axis + 1) % 3] * ((s % 16 + 0.5) / 16.0 - 0.5) +
                                steps[(axis + 2) % 3] * ((s / 16 + 0.5) / 16.0 - 0.5)) /
                                std::abs(steps[axis]),
        0.0, 1.0);
    coverage[v] = static_cast<float>(sum / 256.0);
  }
  return coverage;
}

/// A plane through the middle; voxels 100 times as high as wide.
void AddFlatVoxels(ReportContext& context)
{
  const GridGeometry grid{ { 60, 60, 24 }, { -1.5, -1.5, -60.0 }, { 0.05, 0.05, 5.0 },
    glm::dmat3(1) };
  const std::pair<const char*, glm::dvec3> planes[] = { { "x", { 1, 0, 0 } }, { "z", { 0, 0, 1 } },
    { "steep", { 1, 0.3, 0.004 } }, { "oblique", { 1, 1, 1 } } };
  for (const auto& [name, normal] : planes)
  {
    const glm::dvec3 unit = glm::normalize(normal), at(0.011, 0.007, 0.06);
    const AnalyticVolume plane{ "plane",
      [=](const glm::dvec3& p) { return glm::dot(unit, at - p); } };
    const std::vector<float> distances = CoverageDistance(grid, PlaneCoverage(grid, at, unit));
    DistanceErrors errors(0.05);
    AddErrors(distances, TrueDistances(plane, grid), grid, { -3.0, 3.0, 4 }, "plane", errors);
    AddCase(context, std::string("distance.flat.") + name,
      std::string("voxels of 0.05 x 0.05 x 5 mm, a plane, ") + name + ", within 3 short sides",
      errors.Rms(), 0.25, "of the short side, RMS");
  }
}

/// The same body at other lengths is the same in voxels.
void AddScales(ReportContext& context)
{
  const auto rms = [](double voxelMm)
  {
    const GridGeometry grid = TrialGrid(40, voxelMm);
    const AnalyticVolume ball =
      AnalyticSphere(voxelMm * glm::dvec3(0.31, -0.22, 0.43), 13.3 * voxelMm);
    DistanceErrors errors(voxelMm);
    AddErrors(CoverageDistance(grid, ExactCoverage(ball, grid)), TrueDistances(ball, grid), grid,
      {}, "ball", errors);
    return errors.Rms();
  };
  const double one = rms(1.0);
  for (const double voxelMm : { 0.05, 5.0 })
  {
    char text[120];
    std::snprintf(
      text, sizeof text, "voxels of %g mm are as good as of 1 mm: RMS %.5f voxel", voxelMm, one);
    AddCase(context, std::string("distance.scale.") + (voxelMm < 1.0 ? "small" : "large"), text,
      std::abs(rms(voxelMm) - one), 1e-4, "voxel");
  }
  const GridGeometry meter{ { 240, 36, 36 }, { -600, -90, -90 }, glm::dvec3(5.0), glm::dmat3(1) };
  const AnalyticVolume bar = AnalyticCapsule({ -437, -2, 1 }, { 438, 3, 2 }, 62.0);
  DistanceErrors errors(5.0);
  AddErrors(CoverageDistance(meter, ExactCoverage(bar, meter)), TrueDistances(bar, meter), meter,
    {}, "bar", errors);
  AddCase(context, "distance.meter", "a part of 1 m, voxels of 5 mm, within 3 voxels", errors.Rms(),
    0.01, "voxel RMS");
}

} // namespace

void TryDistanceGrids(ReportContext& context)
{
  AddMetric(context);
  AddLines(context);
  AddSaturated(context);
  AddOneVoxel(context);
  AddFlatVoxels(context);
  AddScales(context);
}

} // namespace hasp
