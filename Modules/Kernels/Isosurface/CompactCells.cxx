#include "Isosurface/CompactCells.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/ClusterLayer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

constexpr double Curvature = 1000.0; // of the logarithm: range / c
constexpr int Levels = 128;
constexpr int ExponentBias = 1 << 15; // a cluster's base holds it unsigned
constexpr std::int64_t ClustersAtATime = 32;

/// f(stored) for each stored corner, in order.
template <typename F>
void ForEachStored(const ClusteredCells& cells, const CellCluster& cluster, const F& f)
{
  const int width = cluster.Width(), count = cluster.CornerCount();
  const std::uint32_t mask = glsl::HaspLowBits(width);
  for (int n = 0; n < count; ++n)
  {
    const std::size_t bit = std::size_t(n) * width, word = cluster.firstWord + bit / 32;
    const std::uint64_t two = cells.corners[word] | std::uint64_t{ cells.corners[word + 1] } << 32;
    f(static_cast<std::uint32_t>(two >> bit % 32) & mask);
  }
}

int ExponentOf(const ClusteredCells& exact, const CellCluster& cluster)
{
  float largest = 0.0F;
  ForEachStored(exact, cluster,
    [&](std::uint32_t stored)
    { largest = std::max(largest, std::abs(exact.SampleOf(cluster, stored) - exact.isovalue)); });
  int exponent = std::numeric_limits<float>::max_exponent; // also where the difference overflows
  if (largest <= std::numeric_limits<float>::max())
    std::frexp(largest, &exponent);
  return std::max(exponent, LeastCompactExponent);
}

/// Of each cluster.
std::vector<int> Exponents(const ClusteredCells& exact)
{
  std::vector<int> exponents(exact.clusters.size());
  ParallelFor(0, std::int64_t(exponents.size()), ClustersAtATime,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t c = first; c < last; ++c)
        exponents[c] = ExponentOf(exact, exact.clusters[c]);
    });
  return exponents;
}

int Largest(const std::vector<int>& exponents)
{
  return std::accumulate(exponents.begin(), exponents.end(), LeastCompactExponent,
    [](int a, int b) { return std::max(a, b); });
}

/// What a sample minus the isovalue becomes: 7 bits of magnitude, one of sign.
class Quantiser
{
public:
  explicit Quantiser(double range)
  {
    for (int m = 0; m < Levels - 1; ++m) // the last level has no end
      this->Ends[m] = static_cast<float>(
        range / Curvature * std::expm1(std::log1p(Curvature) / Levels * (m + 1)));
  }
  std::uint8_t operator()(float value) const
  {
    const auto above = std::upper_bound(this->Ends.begin(), this->Ends.end(), std::abs(value));
    return static_cast<std::uint8_t>((above - this->Ends.begin()) | (value < 0.0F) << 7);
  }

private:
  std::array<float, Levels - 1> Ends{};
};

/// The quantiser's answer for each 16-bit sample: a look-up in place of a search. Empty for floats,
/// and for fewer clusters than the table is worth (after an edit).
std::vector<std::uint8_t> TableOf(const Quantiser& quantise, const ClusteredCells& exact)
{
  constexpr std::size_t worthwhile = 400; // times some 160 corners: as many as the table has
  std::vector<std::uint8_t> table;
  if (exact.cornerType == CornerType::Float32 || exact.clusters.size() < worthwhile)
    return table;
  table.resize(1 << 16);
  for (std::uint32_t bits = 0; bits < table.size(); ++bits)
    table[bits] = quantise(exact.SampleOf(CellCluster{}, bits) - exact.isovalue);
  return table;
}

/// The stored corners of one cluster, each as a byte.
void Encode(const ClusteredCells& exact, const CellCluster& cluster, const Quantiser& quantise,
  const std::vector<std::uint8_t>& table, std::uint32_t* out)
{
  int n = 0;
  const auto put = [&](std::uint8_t byte)
  {
    out[n / 4] |= std::uint32_t{ byte } << n % 4 * 8;
    ++n;
  };
  if (table.empty())
    ForEachStored(exact, cluster,
      [&](std::uint32_t stored)
      { put(quantise(exact.SampleOf(cluster, stored) - exact.isovalue)); });
  else
    ForEachStored(exact, cluster,
      [&](std::uint32_t stored)
      { put(table[static_cast<std::uint16_t>(cluster.Base() + stored)]); });
}

ClusteredCells MakeCompact(
  const ClusteredCells& exact, const std::vector<int>& exponents, int exponent)
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

  std::size_t words = 0;
  for (std::size_t c = 0; c < compact.clusters.size(); ++c)
  {
    CellCluster& cluster = compact.clusters[c];
    const auto base = static_cast<std::uint32_t>(exponents[c] + ExponentBias);
    cluster.place.x = (cluster.place.x & 0x03FFFFFFU) | 8U << 26;
    cluster.place.y = (cluster.place.y & 0xFFFFU) | base << 16;
    cluster.firstWord = static_cast<std::uint32_t>(words);
    words += (cluster.CornerCount() + 3) / 4;
  }
  compact.corners.reserve(words + PaddingWords);
  compact.corners.resize(words);
  const Quantiser quantise(range);
  const std::vector<std::uint8_t> table = TableOf(quantise, exact);
  ParallelFor(0, std::int64_t(compact.clusters.size()), ClustersAtATime,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t c = first; c < last; ++c)
        Encode(exact, exact.clusters[c], quantise, table,
          compact.corners.data() + compact.clusters[c].firstWord);
    });
  FinishCells(compact);
  return compact;
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
  return Largest(Exponents(exact));
}

ClusteredCells CompactCells(const ClusteredCells& exact)
{
  const std::vector<int> exponents = Exponents(exact);
  return MakeCompact(exact, exponents, Largest(exponents));
}

ClusteredCells CompactCells(const ClusteredCells& exact, int exponent)
{
  return MakeCompact(exact, Exponents(exact), exponent);
}

} // namespace hasp
