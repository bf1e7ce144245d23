#include "Distance/ContourSize.h"

#include "Distance/KuhnTetrahedra.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
constexpr std::size_t EnoughBoxes = 10'000;
constexpr int SmallestBox = 8;             ///< cells
constexpr double TrianglesPerSquare = 7.0; ///< cells of a box's face (TestSharpContour)
} // namespace

double EstimateTriangles(const BoundedSolid& solid, const GridGeometry& grid)
{
  const glm::ivec3 cells = grid.Cells();
  int size = SmallestBox;
  while (size < std::max({ cells.x, cells.y, cells.z }))
    size *= 2;
  std::vector<glm::ivec3> boxes{ glm::ivec3(0) }, smaller;
  while (size > SmallestBox && boxes.size() < EnoughBoxes)
  {
    size /= 2;
    smaller.clear();
    for (const glm::ivec3& box : boxes)
      for (int c = 0; c < 8; ++c)
      {
        const glm::ivec3 first = box + CellCorner(c) * size, last = glm::min(first + size, cells);
        if (first.x >= last.x || first.y >= last.y || first.z >= last.z)
          continue;
        const double reach = 0.5 * glm::length(grid.spacing * glm::dvec3(last - first));
        const glm::dvec3 middle = 0.5 * glm::dvec3(first + last);
        if (std::abs(solid.At(grid.IndexToWorld(middle))) <= reach)
          smaller.push_back(first);
      }
    std::swap(boxes, smaller);
  }
  return TrianglesPerSquare * double(size) * double(size) * double(boxes.size());
}

} // namespace hasp
