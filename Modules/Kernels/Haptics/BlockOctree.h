#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/DistanceMap.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// The coarse phase of Papers I-IV, for comparison: an octree with leaves of a fixed size, blocks
/// of 8x8x8 cells, over a body's distance map; two trees are walked down together (McNeely,
/// Puterbaugh and Troy 1999). What is used is CoarsePhase.
///
/// Static; immutable. Memory: 28 B a node.
class BlockOctree
{
public:
  enum class Leaves
  {
    Surface, ///< blocks that the surface crosses: of a body that touches with its points
    Solid    ///< these and those inside: of a body that is touched
  };
  BlockOctree(const DistanceMap& map, Leaves leaves);

  /// The leaves, by block number (x fastest), in the order of the tree.
  std::span<const std::uint32_t> Blocks() const noexcept { return this->LeafBlocks; }
  std::size_t Bytes() const noexcept;

  /// Marks with 1 each leaf of this tree whose box meets a box of a leaf of the other; does not
  /// touch the rest of `marks`, one a leaf. Boxes in any pose are held apart by the 15 axes of
  /// Gottschalk, Lin and Manocha (1996).
  /// thisInOther  this body's axes in the other's, mm
  /// HAPTIC: takes no memory. O(pairs of nodes that meet).
  void MarkOverlaps(const BlockOctree& other, const RigidPose& thisInOther,
    std::span<std::uint8_t> marks) const noexcept;

private:
  struct Node
  {
    glm::vec3 center, half; ///< of the box, along the grid's axes, mm from the body's origin
    std::uint32_t first;    ///< child, or leaf
    std::uint32_t children; ///< 0: a leaf
  };
  struct Walk;
  void Add(const DistanceMapView<std::int16_t>& view, std::span<const std::vector<bool>> levels,
    std::uint32_t node, int level, const glm::ivec3& at);

  glm::dmat3 GridAxes{ 1.0 }; ///< columns, body axes
  glm::dvec3 Spacing{ 1.0 };
  std::vector<Node> Nodes; ///< the root first; none without leaves
  std::vector<std::uint32_t> LeafBlocks;
};

} // namespace hasp
