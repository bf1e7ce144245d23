#include "CellDraws.h"

#include <algorithm>

DrawRange DrawRange::Piece(std::size_t n, std::size_t pieces) const
{
  const std::size_t from = this->count * n / pieces, to = this->count * (n + 1) / pieces;
  return { this->part, this->points, this->first + from, to - from };
}

CellDraws::CellDraws(
  const hasp::VisibleClusters& visible, const std::vector<hasp::ClusterPart>& parts)
{
  this->entries.reserve(visible.rectangles.size() + visible.points.size());
  const auto add = [&](const std::vector<std::uint32_t>& clusters, bool points)
  {
    for (const hasp::ClusterPart& part : parts)
    {
      const std::size_t first = this->entries.size();
      for (const std::uint32_t cluster : clusters)
        if (cluster >= part.first && cluster < part.end)
          this->entries.push_back(static_cast<std::uint32_t>(cluster - part.first));
      if (this->entries.size() > first)
        this->ranges.push_back({ part, points, first, this->entries.size() - first });
    }
  };
  add(visible.rectangles, false);
  add(visible.points, true);
}
