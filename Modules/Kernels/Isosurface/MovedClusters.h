#pragma once
#include "Isosurface/ClusterCulling.h"

#include <span>

namespace hasp
{

/// Culling of clusters whose cells are moved, each by the move of its label: a cluster is in view
/// if one of the moves that its cells make takes it there. Immutable. Any thread.
class MovedClusters
{
public:
  MovedClusters() = default;

  /// moveOfLabel  by label, the number of its move; labels beyond the last make move 0
  /// moveCount    moves, at least one
  /// Throws std::invalid_argument if the cells have no labels or a number is not below moveCount.
  /// O(cells); 100 bytes for each cluster and move made in it.
  MovedClusters(
    const ClusteredCells& cells, std::span<const std::uint32_t> moveOfLabel, std::size_t moveCount);

  /// As CullClusters, where moves[n] takes index coordinates to moved ones; one for each move. A
  /// cluster that is a point by one of its moves and a rectangle by another is a rectangle. Both
  /// lists ascend.
  VisibleClusters Cull(const glm::dmat4& indexToClip, std::span<const glm::dmat4> moves,
    const glm::ivec2& viewport, double pointLimit, double margin = 0.0) const;

  /// The same for several views, as CullClusters.
  std::vector<VisibleClusters> Cull(std::span<const glm::dmat4> indexToClip,
    std::span<const glm::dmat4> moves, const glm::ivec2& viewport, double pointLimit,
    double margin = 0.0) const;

  std::size_t Bytes() const;

private:
  /// The clusters with cells of one move, without their corners, and their numbers.
  struct Group
  {
    ClusteredCells cells;
    std::vector<std::uint32_t> numbers;
  };
  std::vector<Group> Groups; ///< by move
  std::size_t ClusterCount = 0;
};

} // namespace hasp
