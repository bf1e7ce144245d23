#include "Isosurface/ValidateCells.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"
#include "Isosurface/CompactCells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side;
constexpr int MostCells = Side << 13; // along an axis: what a cluster's origin can say
constexpr std::size_t LevelCount = 128;

[[noreturn]] void Refuse(const std::string& what)
{
  throw std::invalid_argument("these are no sound active cells: " + what);
}

void RequireSize(const char* what, std::size_t found, std::size_t expected)
{
  if (found != expected)
    Refuse(std::to_string(found) + " " + what + ", must be " + std::to_string(expected));
}

void CheckLevels(const ClusteredCells& cells)
{
  const bool compact = cells.precision == CellPrecision::Compact;
  RequireSize("levels", cells.levels.size(), compact ? LevelCount : 0);
  float last = 0.0F;
  for (const float level : cells.levels)
  {
    if (!(level > last && level <= std::numeric_limits<float>::max()))
      Refuse("the levels are not finite, above 0 and ascending");
    last = level;
  }
}

void CheckWhole(const ClusteredCells& cells)
{
  cells.geometry.Validate();
  const glm::ivec3 dims = cells.geometry.dims;
  if (std::max({ dims.x, dims.y, dims.z }) - 1 > MostCells)
    Refuse("an axis has more than 65537 samples");
  if (!std::isfinite(cells.isovalue))
    Refuse("the isovalue is not finite");
  if (cells.cornerType != CornerType::Int16 && cells.cornerType != CornerType::UInt16 &&
      cells.cornerType != CornerType::Float32)
    Refuse("their sample type is unknown");
  if (cells.precision != CellPrecision::Exact && cells.precision != CellPrecision::Compact)
    Refuse("their precision is unknown");
  CheckLevels(cells);
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (cells.count > most || cells.corners.size() > most)
    Refuse("there are more than 32 bits can number");
}

/// What the cells' bits say of the corner slices; nothing else of the cluster is trusted.
struct Counts
{
  int cells = 0, corners = 0;
};

Counts CheckPrefixes(const CellCluster& cluster, const std::string& name)
{
  Counts counts;
  for (int z = 0; z <= Side; ++z)
  {
    if (z > 0 && cluster.cornersBefore[z - 1] != counts.corners)
      Refuse(name + "the corners before a slice do not follow from its cells");
    const std::uint64_t touch = cluster.TouchSlice(z);
    counts.corners += static_cast<int>(glsl::HaspCornersBefore(
      { static_cast<std::uint32_t>(touch), static_cast<std::uint32_t>(touch >> 32) }, 9, Side));
    counts.cells += z < Side ? std::popcount(cluster.active[z]) : 0;
  }
  if (counts.cells == 0)
    Refuse(name + "it has no active cell");
  return counts;
}

void CheckPlace(const ClusteredCells& cells, const CellCluster& cluster, const std::string& name)
{
  const glm::ivec3 origin = cluster.Origin();
  const glm::ivec3 room = cells.geometry.Cells() - origin; // cells of the grid from there on
  if (std::min({ room.x, room.y, room.z }) <= 0)
    Refuse(name + "it lies outside the grid");
  std::uint64_t legal = 0;
  for (int y = 0; y < std::min(Side, room.y); ++y)
    legal |= std::uint64_t{ (1U << std::min(Side, room.x)) - 1U } << Side * y;
  for (int z = 0; z < Side; ++z)
    if (cluster.active[z] & ~(z < room.z ? legal : 0))
      Refuse(name + "an active cell lies outside the grid");
}

void CheckWidth(const ClusteredCells& cells, const CellCluster& cluster, const std::string& name)
{
  const int width = cluster.Width();
  bool legal = width >= 1 && width <= 16;
  if (cells.precision == CellPrecision::Compact)
  {
    const int exponent = CompactExponent(cluster);
    legal = width == 8 && exponent >= LeastCompactExponent &&
            exponent <= std::numeric_limits<float>::max_exponent;
  }
  else if (cells.cornerType == CornerType::Float32)
    legal = width == 32 && cluster.Base() == 0;
  if (!legal || (cluster.place.y & 0xE000U) != 0)
    Refuse(name + "the width or base of its corners is not legal");
}

/// Everything of the clusters but their corners: cheap, and what makes those safe to read.
void CheckClusters(const ClusteredCells& cells)
{
  std::size_t cellCount = 0, cornerCount = 0, words = 0;
  const bool colored = !cells.colors.empty() || !cells.firstColors.empty();
  RequireSize(
    "cells that have labels", cells.labels.size(), cells.labels.empty() ? 0 : cells.count);
  RequireSize(
    "clusters that have colours", cells.firstColors.size(), colored ? cells.clusters.size() : 0);
  std::tuple<int, int, int> last{ -1, -1, -1 };
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
  {
    const CellCluster& cluster = cells.clusters[c];
    const std::string name = "cluster " + std::to_string(c) + ": ";
    const glm::ivec3 at = cluster.Origin();
    if (last >= std::tuple(at.z, at.y, at.x))
      Refuse(name + "it does not follow the one before in raster order");
    last = { at.z, at.y, at.x };
    CheckPlace(cells, cluster, name);
    CheckWidth(cells, cluster, name);
    const Counts counts = CheckPrefixes(cluster, name);
    if (cluster.firstCell != cellCount || cluster.firstWord != words)
      Refuse(name + "its cells or corners do not follow those of the one before");
    if (colored && cells.firstColors[c] != cornerCount)
      Refuse(name + "its colours do not follow those of the one before");
    cellCount += counts.cells;
    cornerCount += counts.corners;
    words += (std::size_t(counts.corners) * cluster.Width() + 31) / 32;
    if (words > cells.corners.size())
      Refuse(name + "its corners are missing");
  }
  RequireSize("active cells", cells.count, cellCount);
  RequireSize("words of corners", cells.corners.size(), words + PaddingWords);
  RequireSize("colours of corners", cells.colors.size(), colored ? cornerCount : 0);
  if (cells.corners[words] != 0 || cells.corners[words + 1] != 0)
    Refuse("the words after the corners are not 0");
}

/// Which corners of a cluster are inside, a bit each, in rows along x; 0 where none is stored.
using InsideRows = std::array<std::array<std::uint32_t, Side + 1>, Side + 1>;

/// largest: of what is stored, before the base is added.
InsideRows ReadInside(
  const ClusteredCells& cells, const CellCluster& cluster, std::uint32_t& largest)
{
  const bool compact = cells.precision == CellPrecision::Compact;
  const int width = cluster.Width();
  const std::uint32_t mask = glsl::HaspLowBits(width);
  InsideRows inside{};
  std::size_t bit = std::size_t{ cluster.firstWord } * 32;
  for (int z = 0; z <= Side; ++z)
  {
    std::uint64_t slice = cluster.TouchSlice(z);
    for (std::uint32_t y = 0, below = 0; slice != 0 || below != 0; ++y, slice >>= 8)
    {
      const std::uint32_t row = slice & 0xFF, touched = row | below;
      below = row;
      for (std::uint32_t left = touched | touched << 1; left != 0; left &= left - 1, bit += width)
      {
        const std::uint64_t two =
          cells.corners[bit / 32] | std::uint64_t{ cells.corners[bit / 32 + 1] } << 32;
        const std::uint32_t stored = static_cast<std::uint32_t>(two >> bit % 32) & mask;
        largest = std::max(largest, stored);
        const bool isInside =
          compact ? (stored & 0x80) == 0 : cells.SampleOf(cluster, stored) - cells.isovalue >= 0.0F;
        inside[z][y] |= std::uint32_t{ isInside } << std::countr_zero(left);
      }
    }
  }
  return inside;
}

/// Whether a corner is beyond 16 bits: it would wrap where it is decoded in 16 and not in 32.
bool Wraps(const ClusteredCells& cells, const CellCluster& cluster, std::uint32_t largest)
{
  if (cells.precision == CellPrecision::Compact || cells.cornerType == CornerType::Float32)
    return false;
  const std::uint16_t base = cluster.Base();
  if (cells.cornerType == CornerType::UInt16)
    return base + largest > std::numeric_limits<std::uint16_t>::max();
  const auto least = std::int64_t{ static_cast<std::int16_t>(base) };
  return least + largest > std::numeric_limits<std::int16_t>::max();
}

/// What is wrong with a cluster's corners, or nothing. CheckClusters has let it pass.
const char* CornerFault(const ClusteredCells& cells, const CellCluster& cluster)
{
  const std::size_t bits = std::size_t(cluster.CornerCount()) * cluster.Width();
  const std::uint32_t* words = cells.corners.data() + cluster.firstWord;
  if (bits % 32 != 0 && words[bits / 32] >> bits % 32 != 0)
    return "there are bits after its corners that are not 0";
  if (cells.precision == CellPrecision::Exact && cells.cornerType == CornerType::Float32)
    for (std::size_t n = 0; n < bits / 32; ++n)
      if (!std::isfinite(std::bit_cast<float>(words[n])))
        return "a corner is NaN or infinite";
  std::uint32_t largest = 0;
  const InsideRows inside = ReadInside(cells, cluster, largest);
  if (Wraps(cells, cluster, largest))
    return "a corner is beyond what its sample type holds";
  for (int z = 0; z < Side; ++z)
    for (int y = 0; y < Side; ++y)
    {
      const std::uint32_t active = cluster.active[z] >> Side * y & 0xFF;
      const std::uint32_t a = inside[z][y], b = inside[z][y + 1];
      const std::uint32_t c = inside[z + 1][y], d = inside[z + 1][y + 1];
      const std::uint32_t any = a | b | c | d, all = a & b & c & d;
      if (active & ~((any | any >> 1) & ~(all & all >> 1)))
        return "an active cell has all corners on one side of the isovalue";
    }
  return nullptr;
}

void CheckCorners(const ClusteredCells& cells, const ProgressFunction& progress)
{
  constexpr std::int64_t grain = 256, atATime = 256 * grain; // progress and cancel between them
  const std::int64_t count = std::ssize(cells.clusters);
  std::vector<std::pair<std::int64_t, const char*>> faults(atATime / grain);
  for (std::int64_t begin = 0; begin < count; begin += atATime)
  {
    ReportProgress(progress, double(begin) / double(count));
    std::fill(faults.begin(), faults.end(), std::pair<std::int64_t, const char*>{});
    const auto check = [&](std::int64_t first, std::int64_t last)
    {
      auto& [at, fault] = faults[(first - begin) / grain];
      for (at = first; at < last; ++at)
        if ((fault = CornerFault(cells, cells.clusters[at])))
          return;
    };
    ParallelFor(begin, std::min(count, begin + atATime), grain, check);
    for (const auto& [at, fault] : faults)
      if (fault)
        Refuse("cluster " + std::to_string(at) + ": " + fault);
  }
}

} // namespace

void ValidateCells(const ClusteredCells& cells, const ProgressFunction& progress)
{
  CheckWhole(cells);
  CheckClusters(cells);
  CheckCorners(cells, progress);
  ReportProgress(progress, 1.0);
}

} // namespace hasp
