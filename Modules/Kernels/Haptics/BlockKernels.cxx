#include "Haptics/BlockKernels.h"
#include "Grid/Trilinear.h"
#include "Haptics/CellTriangles.h"
#include "Haptics/ContactForce.h"
#if HASP_WITH_HIGHWAY
#include "Haptics/BlockLanes.h"
#endif

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace hasp
{
namespace
{

void Areas(const BlockSamples& block, const std::uint16_t* cells, int count, float* areas) noexcept
{
  for (int n = 0; n < count; ++n)
  {
    double sum = 0.0;
    InCell(block.CornersOf(BlockSamples::CellOf(cells[n])),
      [&](const CellTriangle& t)
      {
        sum += AreaOf(t, block.spacing);
        return false;
      });
    areas[n] = static_cast<float>(sum);
  }
}

std::uint8_t PickOne(const std::array<double, 8>& corners, const glm::dvec3& spacing, float& left)
{
  std::uint8_t last = 0;
  float before = left;
  for (std::uint8_t t = 0; t < 6; ++t)
  {
    double area = 0.0;
    InTetrahedron(corners, CellTetrahedra[t],
      [&](const CellTriangle& triangle)
      {
        area += AreaOf(triangle, spacing);
        return false;
      });
    if (!(area > 0.0))
      continue;
    before = left;
    last = t;
    left -= static_cast<float>(area);
    if (left < 0.0F)
      break;
  }
  left = before;
  return last;
}

void Pick(const BlockSamples& block, const std::uint16_t* cells, float* left,
  std::uint8_t* tetrahedra) noexcept
{
  for (int n = 0; n < BlockPlaces::Count; ++n)
    tetrahedra[n] =
      PickOne(block.CornersOf(BlockSamples::CellOf(cells[n])), block.spacing, left[n]);
}

bool ProjectOne(const BlockSamples& block, glm::dvec3& index, glm::dvec3& normal)
{
  const glm::dvec3 spacing = block.spacing;
  const double voxel = std::min({ spacing.x, spacing.y, spacing.z });
  const glm::dvec3 last = block.samples - 1;
  for (int step = 0; step < 5; ++step)
  {
    const glm::ivec3 cell = glm::min(glm::ivec3(index), block.samples - 2);
    const glm::dvec3 t = index - glm::dvec3(cell);
    const std::array<double, 8> corners = block.CornersOf(cell);
    const glm::dvec3 slope = TrilinearGradient(corners, t) / spacing;
    const double squared = glm::dot(slope, slope);
    if (!(squared > 0.0 && std::isfinite(squared)))
      return false;
    const double length = std::sqrt(squared);
    const double off = TrilinearValue(corners, t) / length;
    const double move = std::clamp(off, -0.5 * voxel, 0.5 * voxel);
    normal = slope / length;
    index = glm::clamp(index - move * normal / spacing, glm::dvec3(0.0), last);
    if (std::abs(off) < 0.02 * voxel) // the last step squared what it was off by
      return true;
  }
  return false;
}

std::uint32_t Project(const BlockSamples& block, BlockPlaces& places) noexcept
{
  std::uint32_t found = 0;
  for (int n = 0; n < BlockPlaces::Count; ++n)
  {
    glm::dvec3 index, normal;
    for (int axis = 0; axis < 3; ++axis)
      index[axis] = places.index[axis][n];
    if (!ProjectOne(block, index, normal))
      continue;
    found |= 1U << n;
    for (int axis = 0; axis < 3; ++axis)
    {
      places.index[axis][n] = static_cast<float>(index[axis]);
      places.normal[axis][n] = static_cast<float>(normal[axis]);
    }
  }
  return found;
}

} // namespace

std::array<double, 8> BlockSamples::CornersOf(const glm::ivec3& cell) const noexcept
{
  const float* p = &this->values[IndexOf(cell.x, cell.y, cell.z)];
  const float* above = p + IndexOf(0, 0, 1);
  std::array<double, 8> corners{ p[0], p[1], p[Row], p[Row + 1], above[0], above[1], above[Row],
    above[Row + 1] };
  for (double& corner : corners)
    corner = this->outward * (corner - this->isovalue);
  return corners;
}

BlockKernels ScalarBlockKernels() noexcept
{
  return { "scalar", Areas, Pick, Project };
}

std::vector<BlockKernels> AllBlockKernels()
{
  std::vector<BlockKernels> kernels{ ScalarBlockKernels() };
#if HASP_WITH_HIGHWAY
  const std::vector<BlockKernels> lanes = LanesBlockKernels();
  kernels.insert(kernels.end(), lanes.begin(), lanes.end());
#endif
  return kernels;
}

const BlockKernels& FastestBlockKernels()
{
#if HASP_WITH_HIGHWAY
  static const BlockKernels chosen = []
  {
    const std::string_view name = FastestContactKernels().name;
    BlockKernels same = ScalarBlockKernels();
    for (const BlockKernels& kernels : AllBlockKernels())
      if (kernels.name == name)
        same = kernels;
    return same;
  }();
#else
  static const BlockKernels chosen = ScalarBlockKernels();
#endif
  return chosen;
}

} // namespace hasp
