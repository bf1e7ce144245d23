#include "Distance/KeptGrid.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

std::pair<glm::ivec3, glm::ivec3> KeptRange(
  const glm::ivec3& dims, std::span<const std::uint8_t> keep)
{
  glm::ivec3 low(dims), high(-1);
  std::size_t at = 0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i, ++at)
        if (keep[at])
        {
          low = glm::min(low, glm::ivec3(i, j, k));
          high = glm::max(high, glm::ivec3(i, j, k));
        }
  return { low, high };
}

GridGeometry KeptGrid(
  const GridGeometry& scan, const glm::ivec3& first, const glm::ivec3& last, double spacingMm)
{
  if (!(spacingMm > 0.0 && std::isfinite(spacingMm)))
    throw std::invalid_argument("the grid of what is kept: the spacing is " +
                                std::to_string(spacingMm) + " mm; it must be above 0 and finite");
  const glm::dvec3 margin = scan.spacing + KeptGridMarginSteps * spacingMm;
  const glm::dvec3 size = glm::dvec3(last - first) * scan.spacing + 2.0 * margin;
  const glm::dvec3 count = glm::ceil(size / spacingMm) + 1.0;
  constexpr double Most = 1 << 30;
  if (!(std::max({ count.x, count.y, count.z }) < Most))
    throw std::invalid_argument("the grid of what is kept: it would have " +
                                std::to_string(count.x) + " x " + std::to_string(count.y) + " x " +
                                std::to_string(count.z) + " points; choose a larger spacing");
  GridGeometry grid;
  grid.direction = scan.direction;
  grid.origin = scan.IndexToWorld(glm::dvec3(first)) - scan.direction * margin;
  grid.spacing = glm::dvec3(spacingMm);
  grid.dims = glm::ivec3(count);
  return grid;
}

} // namespace hasp
