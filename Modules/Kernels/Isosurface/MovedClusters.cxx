#include "Isosurface/MovedClusters.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

enum State : std::uint8_t
{
  Hidden,
  Point,
  Rectangle
};

using States = std::vector<State>; ///< by cluster

void Join(States& states, const VisibleClusters& seen, std::span<const std::uint32_t> numbers)
{
  for (const std::uint32_t n : seen.points)
    states[numbers[n]] = std::max(states[numbers[n]], Point);
  for (const std::uint32_t n : seen.rectangles)
    states[numbers[n]] = Rectangle;
}

VisibleClusters VisibleOf(const States& states)
{
  VisibleClusters visible;
  for (std::uint32_t c = 0; c < states.size(); ++c)
    if (states[c] == Hidden)
      ++visible.culled;
    else
      (states[c] == Point ? visible.points : visible.rectangles).push_back(c);
  return visible;
}

} // namespace

MovedClusters::MovedClusters(
  const ClusteredCells& cells, std::span<const std::uint32_t> moveOfLabel, std::size_t moveCount)
  : Groups(moveCount),
    ClusterCount(cells.clusters.size())
{
  if (cells.labels.size() != cells.Count() || moveCount == 0)
    throw std::invalid_argument("MovedClusters: " + std::to_string(cells.labels.size()) +
                                " labels for " + std::to_string(cells.Count()) + " cells and " +
                                std::to_string(moveCount) +
                                " moves; there must be a label a cell and a move");
  for (const std::uint32_t move : moveOfLabel)
    if (move >= moveCount)
      throw std::invalid_argument("MovedClusters: move " + std::to_string(move) + " of " +
                                  std::to_string(moveCount) + "; they count from 0");
  for (std::size_t c = 0; c < cells.clusters.size(); ++c)
  {
    const std::size_t first = cells.clusters[c].firstCell;
    const std::size_t end =
      c + 1 < cells.clusters.size() ? cells.clusters[c + 1].firstCell : cells.Count();
    for (std::size_t n = first; n < end; ++n)
    {
      const std::uint16_t label = cells.labels[n];
      Group& group = this->Groups[label < moveOfLabel.size() ? moveOfLabel[label] : 0];
      if (!group.numbers.empty() && group.numbers.back() == c)
        continue;
      group.numbers.push_back(static_cast<std::uint32_t>(c));
      group.cells.clusters.push_back(cells.clusters[c]);
    }
  }
}

VisibleClusters MovedClusters::Cull(const glm::dmat4& indexToClip,
  std::span<const glm::dmat4> moves, const glm::ivec2& viewport, double pointLimit,
  double margin) const
{
  return this->Cull(std::span(&indexToClip, 1), moves, viewport, pointLimit, margin).front();
}

std::vector<VisibleClusters> MovedClusters::Cull(std::span<const glm::dmat4> indexToClip,
  std::span<const glm::dmat4> moves, const glm::ivec2& viewport, double pointLimit,
  double margin) const
{
  if (moves.size() != this->Groups.size())
    throw std::invalid_argument("MovedClusters: " + std::to_string(moves.size()) + " moves, not " +
                                std::to_string(this->Groups.size()));
  std::vector<States> ofViews(indexToClip.size(), States(this->ClusterCount, Hidden));
  for (std::size_t m = 0; m < moves.size(); ++m)
  {
    const Group& group = this->Groups[m];
    if (group.numbers.empty()) // a label that no cell has
      continue;
    std::vector<glm::dmat4> moved;
    for (const glm::dmat4& matrix : indexToClip)
      moved.push_back(matrix * moves[m]);
    const auto seen = CullClusters(group.cells, moved, viewport, pointLimit, margin);
    for (std::size_t v = 0; v < seen.size(); ++v)
      Join(ofViews[v], seen[v], group.numbers);
  }
  std::vector<VisibleClusters> visible;
  for (const States& states : ofViews)
    visible.push_back(VisibleOf(states));
  return visible;
}

std::size_t MovedClusters::Bytes() const
{
  std::size_t bytes = 0;
  for (const Group& group : this->Groups)
    bytes += group.numbers.size() * (sizeof(CellCluster) + sizeof(std::uint32_t));
  return bytes;
}

} // namespace hasp
