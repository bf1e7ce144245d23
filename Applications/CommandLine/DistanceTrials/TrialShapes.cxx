#include "TrialShapes.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hasp
{
namespace
{

/// Calls at(voxel, its index) for each voxel, slices side by side.
template <typename At>
void ForEachVoxel(const GridGeometry& grid, const At& at)
{
  ParallelFor(0, grid.dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (int j = 0; j < grid.dims.y; ++j)
          for (int i = 0; i < grid.dims.x; ++i)
            at((static_cast<std::size_t>(k) * grid.dims.y + j) * grid.dims.x + i,
              glm::dvec3(i, j, static_cast<double>(k)));
    });
}

/// Of the box with this middle and this side, in index steps.
double ShareInside(const AnalyticVolume& shape, const GridGeometry& grid, const glm::dvec3& middle,
  double side, int halvings)
{
  const double at = shape.value(grid.IndexToWorld(middle));
  if (std::abs(at) >= 0.5 * side * glm::length(grid.spacing))
    return at > 0.0;
  if (halvings == 0)
    return std::clamp(
      0.5 + at / (side * std::cbrt(grid.spacing.x * grid.spacing.y * grid.spacing.z)), 0.0, 1.0);
  double sum = 0.0;
  for (int s = 0; s < 8; ++s)
    sum += ShareInside(shape, grid,
      middle + 0.25 * side * glm::dvec3(s % 2 * 2 - 1, s / 2 % 2 * 2 - 1, s / 4 * 2 - 1),
      0.5 * side, halvings - 1);
  return sum / 8.0;
}

constexpr int Finer = 3; ///< samples of a scan's inner grid to a voxel

/// Every third sample along an axis of what `weights` make of the values around it; values at the
/// border go on beyond it.
std::vector<float> Smoothed(const std::vector<float>& values, const glm::ivec3& dims, int axis,
  const std::vector<double>& weights)
{
  glm::ivec3 fewer = dims;
  fewer[axis] /= Finer;
  std::vector<float> smoothed(static_cast<std::size_t>(fewer.x) * fewer.y * fewer.z);
  const int reach = static_cast<int>(weights.size() / 2);
  const std::size_t step = axis == 0 ? 1 : axis == 1 ? dims.x : std::size_t(dims.x) * dims.y;
  ForEachVoxel({ fewer, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) },
    [&](std::size_t to, const glm::dvec3& index)
    {
      glm::ivec3 from(index);
      from[axis] = 0;
      const std::size_t line = (std::size_t(from.z) * dims.y + from.y) * dims.x + from.x;
      double sum = 0.0;
      for (int r = -reach; r <= reach; ++r)
      {
        const int n = std::clamp(Finer * static_cast<int>(index[axis]) + r, 0, dims[axis] - 1);
        sum += weights[r + reach] * values[line + n * step];
      }
      smoothed[to] = static_cast<float>(sum);
    });
  return smoothed;
}

} // namespace

GridGeometry TrialGrid(int samples, double voxelMm)
{
  return { glm::ivec3(samples), glm::dvec3(-0.5 * (samples - 1) * voxelMm), glm::dvec3(voxelMm),
    glm::dmat3(1.0) };
}

AnalyticVolume AnalyticCapsule(const glm::dvec3& a, const glm::dvec3& b, double radius)
{
  const glm::dvec3 along = b - a;
  return { "capsule", [=](const glm::dvec3& p)
    {
      const double t = glm::dot(p - a, along) / glm::dot(along, along);
      return radius - glm::distance(p, a + std::clamp(t, 0.0, 1.0) * along);
    } };
}

glm::dvec3 SubVoxelCentre(int n, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(0.0, 1.0 / 3.0);
  const double x = any(random), y = any(random), z = any(random);
  return glm::dvec3(n % 3, n / 3 % 3, n / 9) / 3.0 + glm::dvec3(x, y, z);
}

glm::dvec3 AnyDirection(std::mt19937_64& random)
{
  std::normal_distribution<double> any;
  const double x = any(random), y = any(random), z = any(random);
  return glm::normalize(glm::dvec3(x, y, z));
}

std::vector<double> TrueDistances(const AnalyticVolume& shape, const GridGeometry& grid)
{
  std::vector<double> distances(grid.Size());
  ForEachVoxel(grid, [&](std::size_t voxel, const glm::dvec3& index)
    { distances[voxel] = -shape.value(grid.IndexToWorld(index)); });
  return distances;
}

std::vector<float> ExactCoverage(
  const AnalyticVolume& shape, const GridGeometry& grid, int halvings)
{
  std::vector<float> coverage(grid.Size());
  ForEachVoxel(grid, [&](std::size_t voxel, const glm::dvec3& index)
    { coverage[voxel] = static_cast<float>(ShareInside(shape, grid, index, 1.0, halvings)); });
  return coverage;
}

std::vector<float> SampledCoverage(
  const AnalyticVolume& shape, const GridGeometry& grid, int perAxis)
{
  std::vector<float> coverage(grid.Size());
  const double reach = 0.5 * glm::length(grid.spacing);
  const int places = perAxis * perAxis * perAxis;
  ForEachVoxel(grid,
    [&](std::size_t voxel, const glm::dvec3& index)
    {
      const double at = shape.value(grid.IndexToWorld(index));
      int inside = at > 0.0 ? places : 0;
      for (int s = 0; s < places && std::abs(at) < reach; ++s)
      {
        inside = s == 0 ? 0 : inside;
        const glm::dvec3 sub(s % perAxis, s / perAxis % perAxis, s / (perAxis * perAxis));
        inside += shape.value(grid.IndexToWorld(index + (sub + 0.5) / double(perAxis) - 0.5)) > 0.0;
      }
      coverage[voxel] = static_cast<float>(inside) / static_cast<float>(places);
    });
  return coverage;
}

std::vector<float> ScannedImage(const AnalyticVolume& shape, const GridGeometry& grid,
  double blurVoxels, double noise, std::uint64_t seed)
{
  // Coverage of voxels of a third of the side is the shape blurred by a box of that side; the
  // Gaussian that is left takes its variance off.
  GridGeometry fine = grid;
  fine.dims *= Finer;
  fine.spacing /= double(Finer);
  const double sigma = std::sqrt(Finer * Finer * blurVoxels * blurVoxels - 1.0 / 12.0);
  const int reach = static_cast<int>(std::ceil(4.5 * sigma));
  std::vector<double> weights;
  double sum = 0.0;
  for (int r = -reach; r <= reach; ++r)
    sum += weights.emplace_back(std::exp(-0.5 * r * r / (sigma * sigma)));
  for (double& weight : weights)
    weight /= sum;
  std::vector<float> image = ExactCoverage(shape, fine, 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    image = Smoothed(image, fine.dims, axis, weights);
    fine.dims[axis] /= Finer;
  }
  std::mt19937_64 random(seed);
  std::normal_distribution<double> any(0.0, 1.0);
  if (noise > 0.0)
    for (float& value : image)
      value += static_cast<float>(noise * any(random));
  return image;
}

std::vector<std::uint8_t> MaskOf(const std::vector<float>& coverage)
{
  std::vector<std::uint8_t> mask(coverage.size());
  std::transform(
    coverage.begin(), coverage.end(), mask.begin(), [](float c) { return c >= 0.5F ? 1 : 0; });
  return mask;
}

std::vector<float> BinaryOf(const std::vector<float>& coverage)
{
  const std::vector<std::uint8_t> mask = MaskOf(coverage);
  return { mask.begin(), mask.end() };
}

} // namespace hasp
