#pragma once
#include "Grid/AnalyticVolumes.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hasp
{

/// Share of each voxel inside a shape whose value is minus the signed distance. Each of 5^3
/// sub-boxes near the surface counts by the depth of its centre, so that a plane's share is right
/// to about 0.001, and a curved one's nearly so.
inline std::vector<float> AnalyticCoverage(const AnalyticVolume& shape, const GridGeometry& grid)
{
  constexpr int N = 5;
  std::vector<float> coverage(grid.Size());
  const double half = 0.5 * glm::length(grid.spacing);
  const double blur = std::cbrt(grid.spacing.x * grid.spacing.y * grid.spacing.z) / N;
  ParallelFor(0, grid.dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        for (int j = 0; j < grid.dims.y; ++j)
          for (int i = 0; i < grid.dims.x; ++i)
          {
            const glm::dvec3 index(i, j, double(k));
            const double at = shape.value(grid.IndexToWorld(index));
            double share = at > 0.0;
            if (std::abs(at) <= half)
            {
              share = 0.0;
              for (int s = 0; s < N * N * N; ++s)
              {
                const glm::dvec3 sub(s % N, s / N % N, s / (N * N));
                const double d =
                  shape.value(grid.IndexToWorld(index + (sub + 0.5) / double(N) - 0.5));
                share += glm::clamp(0.5 + d / blur, 0.0, 1.0) / (N * N * N);
              }
            }
            coverage[(k * grid.dims.y + j) * grid.dims.x + i] = static_cast<float>(share);
          }
    });
  return coverage;
}

/// Error of a distance field over voxels whose true distance is at most `within`, in voxels (the
/// smallest spacing).
struct DistanceError
{
  double rms = 0.0, p99 = 0.0, most = 0.0;
};
inline DistanceError ErrorOf(const std::vector<float>& distance, const AnalyticVolume& shape,
  const GridGeometry& grid, double within)
{
  const double voxel = std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
  std::vector<double> errors;
  for (std::size_t n = 0; n < distance.size(); ++n)
  {
    const std::size_t row = grid.dims.x, slice = row * grid.dims.y;
    const double truth =
      -shape.value(grid.IndexToWorld(glm::dvec3(n % row, n / row % grid.dims.y, n / slice)));
    if (std::abs(truth) <= within * voxel)
      errors.push_back(std::abs(distance[n] - truth) / voxel);
  }
  DistanceError result;
  if (errors.empty())
    return result;
  std::sort(errors.begin(), errors.end());
  for (const double e : errors)
    result.rms += e * e / double(errors.size());
  result.rms = std::sqrt(result.rms);
  result.p99 = errors[std::size_t(0.99 * double(errors.size() - 1))];
  result.most = errors.back();
  return result;
}

} // namespace hasp
