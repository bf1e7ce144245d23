#include "Distance/ScanMargin.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double MostVoxels = 2147483647.0; // of all transforms
constexpr double LeastContrast = 1e-3;      // of the greatest: what is just the isovalue ends, too

/// Voxels beyond the scan along each axis. The surface may be half a voxel beyond its last samples,
/// and a transform is a little off.
glm::ivec3 StepsOf(const GridGeometry& scan, double mm)
{
  scan.Validate();
  glm::dvec3 steps(0.0);
  if (mm != 0.0)
    steps = glm::ceil(mm / scan.spacing - 1e-9) + 1.0;
  const glm::dvec3 dims = glm::dvec3(scan.dims) + 2.0 * steps;
  if (!(mm >= 0.0) || !(dims.x * dims.y * dims.z <= MostVoxels))
  {
    std::ostringstream text;
    text << "a margin of " << mm << " mm: it must be at least 0, and such that there are less than "
         << "2^31 voxels with it";
    throw std::invalid_argument(text.str());
  }
  return glm::ivec3(steps);
}

/// For each voxel of the larger grid: make(number of the nearest sample, voxels beyond the scan).
template <typename Make>
std::vector<float> Enlarged(const GridGeometry& scan, double mm, const Make& make)
{
  const glm::ivec3 steps = StepsOf(scan, mm), dims = scan.dims + 2 * steps;
  std::vector<float> values(std::size_t(dims.x) * dims.y * dims.z);
  ParallelFor(0, std::int64_t(dims.y) * dims.z, 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        for (int x = 0; x < dims.x; ++x)
        {
          const glm::ivec3 at = glm::ivec3(x, row % dims.y, row / dims.y) - steps;
          const glm::ivec3 nearest = glm::clamp(at, glm::ivec3(0), scan.dims - 1);
          const glm::ivec3 off = glm::abs(at - nearest);
          const std::size_t sample =
            (std::size_t(nearest.z) * scan.dims.y + nearest.y) * scan.dims.x + nearest.x;
          values[row * dims.x + x] = make(sample, std::max({ off.x, off.y, off.z }));
        }
    });
  return values;
}
} // namespace

GridGeometry GeometryWithMargin(const GridGeometry& scan, double mm)
{
  const glm::ivec3 steps = StepsOf(scan, mm);
  GridGeometry grid = scan;
  grid.dims += 2 * steps;
  grid.origin = scan.IndexToWorld(-glm::dvec3(steps));
  return grid;
}

std::vector<float> CoverageWithMargin(
  const GridGeometry& scan, std::span<const float> coverage, double mm)
{
  if (coverage.size() != scan.Size())
    throw std::invalid_argument("margin: " + std::to_string(coverage.size()) + " values for " +
                                std::to_string(scan.Size()) + " voxels");
  return Enlarged(
    scan, mm, [&](std::size_t sample, int beyond) { return beyond > 0 ? 0.0F : coverage[sample]; });
}

std::vector<float> GreyWithMargin(const AnyGridView& scan, double isovalue, double mm)
{
  return std::visit(
    [&](const auto& view)
    {
      const auto difference = [&](std::size_t sample)
      { return static_cast<float>(double(view.data[sample]) - isovalue); };
      float most = 0.0F;
      for (std::size_t n = 0; n < view.geometry.Size(); ++n)
        most = std::max(most, std::abs(difference(n)));
      const float least = LeastContrast * most;
      return Enlarged(view.geometry, mm,
        [&](std::size_t sample, int beyond)
        {
          const float here = difference(sample);
          return beyond > 0 ? float(1 - 2 * beyond) * std::max(std::abs(here), least) : here;
        });
    },
    scan);
}

} // namespace hasp
