#include "Evaluation/BonePieces.h"

#include "Grid/Trilinear.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hasp
{

BonePieces::BonePieces(const AnyGridView& volume, double isovalue, double ignoreBelowMm3)
  : Volume(volume),
    Isovalue(isovalue)
{
  const glm::dvec3& s = GeometryOf(volume).spacing;
  this->LeastSamples = static_cast<std::size_t>(std::ceil(ignoreBelowMm3 / (s.x * s.y * s.z)));
}

double BonePieces::ValueAt(std::size_t sample) const
{
  return std::visit([sample](const auto& view) { return double(view.data[sample]); }, this->Volume);
}

bool BonePieces::Counts(const glm::dvec3& world)
{
  const GridGeometry& g = GeometryOf(this->Volume);
  const auto at = LocateCell(g, g.WorldToIndex(world));
  if (!at)
    return false;
  std::size_t greatest = 0;
  double most = -HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 p = at->cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const std::size_t sample = (std::size_t(p.z) * g.dims.y + p.y) * g.dims.x + p.x;
    if (const double value = this->ValueAt(sample); value > most)
    {
      most = value;
      greatest = sample;
    }
  }
  if (!(most >= this->Isovalue))
    return false;
  if (this->LeastSamples <= 1)
    return true;
  const auto known = this->Known.find(greatest);
  return known != this->Known.end() ? known->second : this->Flood(greatest);
}

bool BonePieces::Flood(std::size_t start)
{
  const glm::ivec3& dims = GeometryOf(this->Volume).dims;
  std::vector<std::size_t> piece{ start };
  std::unordered_map<std::size_t, bool> seen{ { start, true } };
  bool counts = false;
  for (std::size_t n = 0; n < piece.size() && !counts; ++n)
  {
    const glm::ivec3 p(int(piece[n] % dims.x), int(piece[n] / dims.x % dims.y),
      int(piece[n] / (std::size_t(dims.x) * dims.y)));
    const glm::ivec3 low = glm::max(p - 1, glm::ivec3(0)), high = glm::min(p + 1, dims - 1);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
        {
          const std::size_t sample = (std::size_t(k) * dims.y + j) * dims.x + i;
          if (seen.contains(sample) || !(this->ValueAt(sample) >= this->Isovalue))
            continue;
          const auto known = this->Known.find(sample);
          counts |= known != this->Known.end() && known->second;
          seen[sample] = true;
          piece.push_back(sample);
        }
    counts |= piece.size() >= this->LeastSamples;
  }
  for (const std::size_t sample : piece)
    this->Known[sample] = counts;
  return counts;
}

} // namespace hasp
