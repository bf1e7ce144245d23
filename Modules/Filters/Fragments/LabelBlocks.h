#pragma once
#include "Grid/GridView.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <map>
#include <vector>

namespace hasp
{

/// Where a label is: first and last sample along each axis, and how many there are.
struct LabelExtent
{
  glm::ivec3 low{ 0 }, high{ -1 };
  std::size_t voxels = 0;
};

/// Which labels a map holds, where, and which of them an edit has changed, without a copy of the
/// map: of each block of 32^3 samples the labels in it, each with its box and a sum of hashes of
/// its places. After an edit the blocks that it touches are read anew and held against what they
/// were. Label 0 is nothing.
///
/// The hash has 64 bits: two different sets of voxels of a block look alike once in 2^64.
/// Threads: any number may read, except during Update. O(samples) to make, O(samples of the blocks
/// touched + blocks) to update, all cores. About 50 bytes for each label in each block.
class LabelBlocks
{
public:
  explicit LabelBlocks(const GridView<const std::uint16_t>& labels);

  /// Reads the blocks that touch samples [low, high], clamped, anew. Returns the labels whose
  /// voxels are others than before: those that have lost some, have gained some, or both;
  /// ascending.
  std::vector<std::uint16_t> Update(
    const GridView<const std::uint16_t>& labels, const glm::ivec3& low, const glm::ivec3& high);

  /// Of all labels that have voxels.
  const std::map<std::uint16_t, LabelExtent>& Extents() const { return this->Found; }

private:
  struct InBlock
  {
    std::uint16_t label = 0;
    LabelExtent extent;
    std::uint64_t places = 0; ///< sum of hashes
  };
  using Block = std::vector<InBlock>; ///< labels ascending

  static Block Read(const GridView<const std::uint16_t>& labels, const glm::ivec3& block);
  Block& At(const glm::ivec3& block)
  {
    return this
      ->Blocks[(std::size_t(block.z) * this->Counts.y + block.y) * this->Counts.x + block.x];
  }
  void ReadAll(
    const GridView<const std::uint16_t>& labels, const glm::ivec3& from, const glm::ivec3& to);
  void AddUp();

  glm::ivec3 Counts{ 0 };
  std::vector<Block> Blocks;
  std::map<std::uint16_t, LabelExtent> Found;
};

} // namespace hasp
