#include "Isosurface/ClusteredCells.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <tuple>

namespace hasp
{

namespace
{

glm::uvec2 Words(std::uint64_t bits)
{
  return { static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32) };
}

/// The samples of two corners that are stored one after the other, as they are in the stream.
std::array<std::uint32_t, 2> StoredPair(
  const ClusteredCells& cells, const CellCluster& cluster, std::uint32_t first)
{
  const int width = cluster.Width();
  const std::size_t bit = std::size_t{ first } * width, word = cluster.firstWord + bit / 32;
  const std::uint64_t two =
    (cells.corners[word] | std::uint64_t{ cells.corners[word + 1] } << 32) >> bit % 32;
  const std::uint32_t mask = glsl::HaspLowBits(width);
  return { static_cast<std::uint32_t>(two) & mask,
    static_cast<std::uint32_t>(two >> width) & mask };
}

/// f(c, stored) for each corner c of the cell, x fastest.
template <typename F>
void ForEachCorner(
  const ClusteredCells& cells, const CellCluster& cluster, const glm::ivec3& cell, const F& f)
{
  for (int row = 0; row < 4; ++row)
  {
    const int y = cell.y + row % 2, z = cell.z + row / 2;
    const std::uint32_t before = (z > 0 ? cluster.cornersBefore[z - 1] : 0) +
                                 glsl::HaspCornersBefore(Words(cluster.TouchSlice(z)), cell.x, y);
    const auto pair = StoredPair(cells, cluster, before);
    f(2 * row, pair[0]);
    f(2 * row + 1, pair[1]);
  }
}

} // namespace

int CellCluster::CellCount() const
{
  int count = 0;
  for (const std::uint64_t slice : this->active)
    count += std::popcount(slice);
  return count;
}

int CellCluster::CornerCount() const
{
  return this->cornersBefore[7] +
         static_cast<int>(glsl::HaspCornersBefore(Words(this->active[7]), 9, 8));
}

std::size_t ClusteredCells::Bytes() const
{
  const auto bytes = [](const auto& values) { return values.size() * sizeof(values[0]); };
  return bytes(this->clusters) + bytes(this->corners) + bytes(this->levels) + bytes(this->labels) +
         bytes(this->colors) + bytes(this->firstColors);
}

std::size_t ClusteredCells::ClusterOf(std::size_t n) const
{
  const auto after = std::upper_bound(this->clusters.begin(), this->clusters.end(), n,
    [](std::size_t cell, const CellCluster& cluster) { return cell < cluster.firstCell; });
  return after - this->clusters.begin() - 1;
}

glm::ivec3 ClusteredCells::Cell(std::size_t n) const
{
  const CellCluster& cluster = this->clusters[this->ClusterOf(n)];
  auto left = static_cast<std::uint32_t>(n - cluster.firstCell);
  int z = 0;
  while (static_cast<int>(left) >= std::popcount(cluster.active[z]))
    left -= std::popcount(cluster.active[z++]);
  const auto place = static_cast<int>(glsl::HaspSelectBit(Words(cluster.active[z]), left));
  return cluster.Origin() + glm::ivec3(place & 7, place >> 3, z);
}

std::optional<std::size_t> ClusteredCells::Find(const glm::ivec3& cell) const
{
  const glm::ivec3 origin = cell / 8 * 8, in = cell - origin;
  if (std::min({ in.x, in.y, in.z }) < 0)
    return std::nullopt;
  const auto rasterBefore = [](const CellCluster& cluster, const glm::ivec3& place)
  {
    const glm::ivec3 at = cluster.Origin();
    return std::tie(at.z, at.y, at.x) < std::tie(place.z, place.y, place.x);
  };
  const auto cluster =
    std::lower_bound(this->clusters.begin(), this->clusters.end(), origin, rasterBefore);
  if (cluster == this->clusters.end() || cluster->Origin() != origin || !cluster->Active(in))
    return std::nullopt;
  std::size_t n = cluster->firstCell;
  for (int z = 0; z < in.z; ++z)
    n += std::popcount(cluster->active[z]);
  const std::uint64_t before = (std::uint64_t{ 1 } << (in.y << 3 | in.x)) - 1;
  return n + std::popcount(cluster->active[in.z] & before);
}

float ClusteredCells::SampleOf(const CellCluster& cluster, std::uint32_t stored) const
{
  if (this->cornerType == CornerType::Float32)
    return std::bit_cast<float>(stored);
  const auto value = static_cast<std::uint16_t>(cluster.Base() + stored);
  return this->cornerType == CornerType::Int16
           ? static_cast<float>(static_cast<std::int16_t>(value))
           : static_cast<float>(value);
}

std::array<float, 8> ClusteredCells::CornersFromIsovalue(
  const CellCluster& cluster, const glm::ivec3& inCluster) const
{
  std::array<float, 8> corners{};
  ForEachCorner(*this, cluster, inCluster,
    [&](int c, std::uint32_t stored)
    {
      if (this->precision == CellPrecision::Compact)
        corners[c] = (stored & 0x80 ? -1.0F : 1.0F) * this->levels[stored & 0x7F];
      else
        corners[c] = this->SampleOf(cluster, stored) - this->isovalue;
    });
  return corners;
}

std::array<float, 8> ClusteredCells::Corners(std::size_t n) const
{
  if (this->precision == CellPrecision::Compact)
    throw std::logic_error("ClusteredCells::Corners: compact cells do not hold the samples");
  const CellCluster& cluster = this->clusters[this->ClusterOf(n)];
  std::array<float, 8> corners{};
  ForEachCorner(*this, cluster, this->Cell(n) - cluster.Origin(),
    [&](int c, std::uint32_t stored) { corners[c] = this->SampleOf(cluster, stored); });
  return corners;
}

} // namespace hasp
