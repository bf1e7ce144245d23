#include "CellChecks.h"

#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"
#include "Isosurface/ClusteredCells.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

namespace hasp
{
namespace
{

/// Calls visit(place in the cluster) for every active cell, in the order of their numbers.
template <typename Visit>
void ForEachCell(const CellCluster& cluster, const Visit& visit)
{
  for (int z = 0; z < 8; ++z)
    for (std::uint64_t bits = cluster.active[z]; bits != 0; bits &= bits - 1)
    {
      const int place = std::countr_zero(bits);
      visit(glm::ivec3(place & 7, place >> 3, z));
    }
}

std::array<double, 8> CornersOf(const AnyGridView& grid, const glm::ivec3& cell)
{
  return std::visit([&](const auto& view) { return CellCorners(view, cell); }, grid);
}

bool IsActive(const std::array<double, 8>& corners, double isovalue)
{
  int inside = 0;
  for (const double corner : corners)
  {
    if (!std::isfinite(corner))
      return false;
    inside += corner >= isovalue;
  }
  return inside != 0 && inside != 8;
}

std::size_t CountActive(const AnyGridView& grid, double isovalue)
{
  const glm::ivec3 size = GeometryOf(grid).Cells();
  std::atomic<std::size_t> count = 0;
  ParallelFor(0, size.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      std::size_t here = 0;
      for (auto z = int(first); z < last; ++z)
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x)
            here += IsActive(CornersOf(grid, { x, y, z }), isovalue);
      count += here;
    });
  return count;
}

template <typename T>
std::size_t DifferentBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  const auto bytesA = std::as_bytes(std::span(a)), bytesB = std::as_bytes(std::span(b));
  const std::size_t common = std::min(bytesA.size(), bytesB.size());
  std::size_t different = std::max(bytesA.size(), bytesB.size()) - common;
  if (common > 0 && std::memcmp(bytesA.data(), bytesB.data(), common) != 0)
    for (std::size_t n = 0; n < common; ++n)
      different += bytesA[n] != bytesB[n];
  return different;
}

} // namespace

LosslessCheck CheckLosslessSlab(const AnyGridView& slab, int first, const ClusteredCells& exact)
{
  LosslessCheck check;
  check.activeInVolume = CountActive(slab, exact.isovalue);
  const glm::ivec3& dims = GeometryOf(slab).dims;
  std::vector<bool> seen(GeometryOf(slab).Size());
  for (const CellCluster& cluster : exact.clusters)
  {
    if (cluster.Origin().z < first || cluster.Origin().z >= first + dims.z - 1)
      continue;
    std::size_t number = cluster.firstCell;
    ForEachCell(cluster,
      [&](const glm::ivec3& inCluster)
      {
        const glm::ivec3 cell = cluster.Origin() + inCluster - glm::ivec3(0, 0, first);
        const std::array<double, 8> truth = CornersOf(slab, cell);
        const std::array<float, 8> decoded = exact.Corners(number++);
        for (int c = 0; c < 8; ++c)
          check.wrongCorners += decoded[c] != truth[c];
        const std::size_t at = (std::size_t(cell.z) * dims.y + cell.y) * dims.x + cell.x;
        check.cells += IsActive(truth, exact.isovalue) && !seen[at];
        seen[at] = true;
      });
  }
  return check;
}

LosslessCheck CheckLossless(const AnyGridView& grid, const ClusteredCells& exact)
{
  return CheckLosslessSlab(grid, 0, exact);
}

CompactShift MeasureShift(const AnyGridView& grid, const ClusteredCells& compact)
{
  CompactShift shift;
  std::vector<double> shifts;
  double squares = 0.0;
  for (const CellCluster& cluster : compact.clusters)
    ForEachCell(cluster,
      [&](const glm::ivec3& inCluster)
      {
        std::array<double, 8> truth = CornersOf(grid, cluster.Origin() + inCluster);
        const std::array<float, 8> decoded = compact.CornersFromIsovalue(cluster, inCluster);
        bool same = true;
        for (int c = 0; c < 8; ++c)
        {
          truth[c] -= compact.isovalue;
          same &= (decoded[c] >= 0.0F) == (truth[c] >= 0.0);
        }
        shift.changedCells += !same;
        for (const int c : { 1, 2, 4 }) // each edge of the grid once: that of the cell it begins
          if ((truth[0] >= 0.0) != (truth[c] >= 0.0) && same)
          {
            const double exact = truth[0] / (truth[0] - truth[c]);
            const double shown = decoded[0] / (double(decoded[0]) - decoded[c]);
            shifts.push_back(std::abs(shown - exact));
            squares += shifts.back() * shifts.back();
          }
      });
  shift.edges = shifts.size();
  if (shifts.empty())
    return shift;
  shift.rms = std::sqrt(squares / double(shifts.size()));
  shift.max = *std::max_element(shifts.begin(), shifts.end());
  const auto rank = shifts.begin() + std::ptrdiff_t(0.999 * double(shifts.size() - 1));
  std::nth_element(shifts.begin(), rank, shifts.end());
  shift.p999 = *rank;
  return shift;
}

std::size_t DifferentBytes(const ClusteredCells& a, const ClusteredCells& b)
{
  return DifferentBytes(a.clusters, b.clusters) + DifferentBytes(a.corners, b.corners) +
         DifferentBytes(a.levels, b.levels) + (a.count != b.count) * sizeof(a.count);
}

} // namespace hasp
