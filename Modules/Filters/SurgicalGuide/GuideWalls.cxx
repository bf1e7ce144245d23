#include "GuideWalls.h"

#include "Distance/CoverageDistance.h"
#include "Distance/Csg.h"
#include "Distance/GridSolid.h"
#include "Distance/NearSurface.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace hasp
{

namespace
{
/// Marks the neighbours of what is marked, corners too.
void MarkAround(const glm::ivec3& dims, std::vector<std::uint8_t>& marks)
{
  const std::int64_t strides[] = { 1, dims.x, std::int64_t(dims.x) * dims.y };
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t stride = strides[axis], count = dims[axis];
    const std::int64_t lines = std::int64_t(marks.size()) / count;
    ParallelFor(0, lines, 1024,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t line = first; line < last; ++line)
        {
          std::uint8_t* at = &marks[line / stride * stride * count + line % stride];
          std::uint8_t before = 0;
          for (std::int64_t n = 0; n < count; ++n, at += stride)
          {
            const std::uint8_t here = *at, next = n + 1 < count ? at[stride] : 0;
            *at = before | here | next;
            before = here;
          }
        }
      });
  }
}
} // namespace

SolidPointer ThickParts(const SolidPointer& solid, const GridGeometry& grid, double ballMm,
  double keptMm, const ProgressFunction& progress)
{
  const double cell = grid.spacing.x;
  const auto half = [&](double from)
  { return [&progress, from](double share) { return !progress || progress(from + 0.5 * share); }; };
  std::vector<float> centres =
    DenseValues(EvaluateNearSurface(*solid, grid, ballMm + cell, half(0.0)));
  // Only beside a sample that is deep enough: half covered alone is a film of centres, too.
  std::vector<std::uint8_t> deep(centres.size());
  std::transform(centres.begin(), centres.end(), deep.begin(),
    [&](float value) { return std::uint8_t(value <= -ballMm); });
  if (std::find(deep.begin(), deep.end(), 1) == deep.end())
    return nullptr;
  MarkAround(grid.dims, deep);
  // Balls' centres, as coverage: what a plane at this depth leaves of a cell.
  for (std::size_t n = 0; n < centres.size(); ++n)
    centres[n] =
      deep[n] ? static_cast<float>(std::clamp(0.5 - (centres[n] + ballMm) / cell, 0.0, 1.0)) : 0.0F;
  auto distance =
    std::make_shared<const std::vector<float>>(CoverageDistanceBand(grid, centres, half(0.5)));
  return MakeIntersection(
    { solid, MakeOffset(MakeGridSolid(std::move(distance), grid), ballMm + keptMm) });
}

} // namespace hasp
