#include "Isosurface/CompactCells.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Curvature = 1000.0; // of the logarithm: range / c
constexpr int Levels = 128;
constexpr int ExponentBias = 1 << 15; // a cluster's base holds it unsigned
constexpr std::int64_t ClustersAtATime = 256;

/// Largest magnitude that level m stands for; the next stands for more.
double UpperEnd(double range, int m)
{
  return range / Curvature * std::expm1(std::log1p(Curvature) / Levels * (m + 1));
}

/// f(sample minus isovalue) for each stored corner, in order.
template <typename F>
void ForEachStored(const ClusteredCells& cells, const CellCluster& cluster, const F& f)
{
  const int width = cluster.Width(), count = cluster.CornerCount();
  const std::uint32_t mask = glsl::HaspLowBits(width);
  for (int n = 0; n < count; ++n)
  {
    const std::size_t bit = std::size_t(n) * width, word = cluster.firstWord + bit / 32;
    const std::uint64_t two = cells.corners[word] | std::uint64_t{ cells.corners[word + 1] } << 32;
    f(cells.SampleOf(cluster, static_cast<std::uint32_t>(two >> bit % 32) & mask) - cells.isovalue);
  }
}

int ExponentOf(const ClusteredCells& exact, const CellCluster& cluster)
{
  float largest = 0.0F;
  ForEachStored(exact, cluster, [&](float value) { largest = std::max(largest, std::abs(value)); });
  int exponent = std::numeric_limits<float>::max_exponent; // also where the difference overflows
  if (largest <= std::numeric_limits<float>::max())
    std::frexp(largest, &exponent);
  return std::max(exponent, LeastCompactExponent);
}

std::size_t WordsOf(const CellCluster& cluster)
{
  return (cluster.CornerCount() + 3) / 4;
}

} // namespace

std::vector<float> CompactLevels(double range)
{
  if (!(range > 0.0) || !std::isfinite(range))
    throw std::invalid_argument(
      "CompactLevels: range " + std::to_string(range) + " must be finite and above 0");
  std::vector<float> levels(Levels);
  for (int m = 0; m < Levels; ++m)
    levels[m] = float(range / Curvature * std::expm1(std::log1p(Curvature) / Levels * (m + 0.5)));
  return levels;
}

int CompactExponent(const CellCluster& cluster)
{
  return int(cluster.Base()) - ExponentBias;
}

int CompactExponent(const ClusteredCells& exact)
{
  int exponent = LeastCompactExponent;
  for (const CellCluster& cluster : exact.clusters)
    exponent = std::max(exponent, ExponentOf(exact, cluster));
  return exponent;
}

ClusteredCells CompactCells(const ClusteredCells& exact)
{
  return CompactCells(exact, CompactExponent(exact));
}

ClusteredCells CompactCells(const ClusteredCells& exact, int exponent)
{
  if (exact.precision == CellPrecision::Compact)
    throw std::invalid_argument("CompactCells: the cells are compact already");
  ClusteredCells compact;
  compact.geometry = exact.geometry;
  compact.isovalue = exact.isovalue;
  compact.cornerType = exact.cornerType;
  compact.precision = CellPrecision::Compact;
  compact.count = exact.count;
  compact.clusters = exact.clusters;
  compact.labels = exact.labels;
  compact.colors = exact.colors;
  compact.firstColors = exact.firstColors;
  const double range = std::ldexp(1.0, exponent);
  compact.levels = CompactLevels(range);
  std::array<float, Levels> ends{};
  for (int m = 0; m < Levels; ++m)
    ends[m] = static_cast<float>(UpperEnd(range, m));

  std::size_t words = 0;
  for (CellCluster& cluster : compact.clusters)
  {
    cluster.firstWord = static_cast<std::uint32_t>(words);
    words += WordsOf(cluster);
  }
  compact.corners.resize(words);
  const auto encode = [&](std::int64_t first, std::int64_t last)
  {
    for (std::int64_t c = first; c < last; ++c)
    {
      CellCluster& cluster = compact.clusters[c];
      std::uint32_t* out = compact.corners.data() + cluster.firstWord;
      int n = 0;
      ForEachStored(exact, exact.clusters[c],
        [&](float value)
        {
          const auto above = std::upper_bound(ends.begin(), ends.end() - 1, std::abs(value));
          const auto byte = static_cast<std::uint32_t>(above - ends.begin()) | (value < 0) << 7;
          out[n / 4] |= byte << n % 4 * 8;
          ++n;
        });
      const auto base =
        static_cast<std::uint32_t>(ExponentOf(exact, exact.clusters[c]) + ExponentBias);
      cluster.place.x = (cluster.place.x & 0x03FFFFFFU) | 8U << 26;
      cluster.place.y = (cluster.place.y & 0xFFFFU) | base << 16;
    }
  };
  ParallelFor(0, std::int64_t(compact.clusters.size()), ClustersAtATime, encode);
  FinishCells(compact);
  return compact;
}

} // namespace hasp
