#pragma once
#include "Grid/GridView.h"

#include <utility>
#include <vector>

namespace hasp
{

/// Smallest and largest sample of each block of 8x8x8 cells (9x9x9 samples, shared faces included):
/// the coarse phase of extraction and ray casting (thesis 3.3.1 uses the same blocks for haptics).
///
/// A block can hold a piece of the isosurface only if min < isovalue <= max (inside is value >=
/// isovalue). NaN samples are left out of both. 8 bytes a block: about 1/64 of an int16 volume's
/// bytes per sample. Any thread may read, except during Update.
class MinMaxBlocks
{
public:
  static constexpr int Side = 8; ///< cells per block and axis

  MinMaxBlocks() = default;
  /// O(samples), all threads. Throws std::invalid_argument on an invalid geometry.
  explicit MinMaxBlocks(const AnyGridView& grid);

  /// Reads the blocks anew that hold or share one of the samples [low, high], which have changed;
  /// the grid must be the one these blocks were made of; throws std::invalid_argument if it has not
  /// their number of blocks. O(samples in them), all threads.
  void Update(const AnyGridView& grid, const glm::ivec3& low, const glm::ivec3& high);
  /// Reads the blocks [from, to) anew of the same grid, in the calling thread. Several threads may
  /// read, each its own blocks.
  void Read(const AnyGridView& grid, const glm::ivec3& from, const glm::ivec3& to);
  /// The blocks that Update reads: from the first to one past the last along each axis; both equal
  /// if there are none. Samples outside the grid are left out.
  std::pair<glm::ivec3, glm::ivec3> Touched(const glm::ivec3& low, const glm::ivec3& high) const;

  /// Blocks per axis; 0 on an axis with a single sample.
  const glm::ivec3& Blocks() const { return this->BlockCount; }
  std::size_t Count() const { return this->Ranges.size(); }
  std::size_t Bytes() const { return this->Ranges.size() * sizeof(Range); }

  struct Range
  {
    float min, max;
  };
  /// Of all blocks, x fastest; none if there are none.
  const Range* Data() const { return this->Ranges.data(); }

  bool Active(const glm::ivec3& block, double isovalue) const
  {
    const Range& r = this->Ranges[this->Index(block)];
    return r.min < isovalue && isovalue <= r.max;
  }
  ///@{
  /// Over the whole volume; min > max if it holds no number. O(blocks).
  float Min() const;
  float Max() const;
  ///@}

private:
  void ReadAll(const AnyGridView& grid, const glm::ivec3& from, const glm::ivec3& to);
  std::size_t Index(const glm::ivec3& b) const
  {
    return (static_cast<std::size_t>(b.z) * this->BlockCount.y + b.y) * this->BlockCount.x + b.x;
  }

  glm::ivec3 BlockCount{ 0 };
  std::vector<Range> Ranges;
};

} // namespace hasp
