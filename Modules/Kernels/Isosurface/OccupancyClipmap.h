#pragma once
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

/// A block of the volume: its place in units of 8 cells, each of `2^level` samples an axis.
struct BlockKey
{
  glm::ivec3 block{ 0 };
  int level = 0;
  bool operator==(const BlockKey&) const = default;

  static constexpr int Side = 8; ///< cells of its level, an axis
  /// The block of a level that a cell of the volume lies in.
  static BlockKey Of(const glm::ivec3& cell, int level)
  {
    return { cell / (Side << level), level };
  }
  /// The block of a coarser level (or its own) that it lies in.
  BlockKey At(int coarser) const { return { block >> (coarser - level), coarser }; }
  /// The eight of the next finer level that it is made of. level must be 1 or more.
  std::array<BlockKey, 8> Finer() const;
};

/// Which blocks are in a cache, at each level of detail in a window that follows the viewer (thesis
/// 3.2.1: "occupancy clipmap"). Every level has a window of at most WindowSide^3 blocks; block b is
/// kept at b modulo the window's size, so nothing moves when the window does.
///
/// The paper's map holds a bit; this one a number, of the block's record in the cache, so that the
/// record is found from the place.
///
/// Fixed memory: at most 2 MiB a level. Reading: any thread; changes: one thread, nobody reading.
class OccupancyClipmap
{
public:
  static constexpr int WindowSide = 64; ///< blocks, 512 cells: a power of two
  static constexpr std::uint32_t Empty = 0xFFFFFFFFU;

  OccupancyClipmap() = default;
  /// For a volume of so many cells an axis. The last level's window holds all of it.
  explicit OccupancyClipmap(const glm::ivec3& cells);

  int Levels() const { return static_cast<int>(this->Windows.size()); }
  std::size_t Bytes() const;

  /// Moves each window whose middle quarter the viewer (a place in index coordinates, clamped to
  /// the volume) has left, so that it is in the middle again. A window moves by eighths of its
  /// size; to move it back the viewer must go back by 32 cells of its level or more. What is in no
  /// window any more stays in the map: the caller must remove it. True if a window has moved.
  ///
  /// Windows are nested: what lies in one lies in all coarser ones; and their bounds are bounds of
  /// blocks of the next coarser level, so the eight finer blocks of a block are in a window or not
  /// together.
  bool Follow(const glm::dvec3& viewer);

  bool InWindow(const BlockKey& key) const
  {
    const Window& w = this->Windows[key.level];
    const glm::ivec3 in = key.block - w.first;
    return glm::all(glm::greaterThanEqual(in, glm::ivec3(0))) &&
           glm::all(glm::lessThan(in, w.size));
  }
  /// The number at the block's address, or Empty. Of blocks with one address one is in the window.
  std::uint32_t Get(const BlockKey& key) const
  {
    const std::uint32_t number = this->Numbers[this->Address(key)];
    return number < Dropped ? number : Empty;
  }
  /// number: below 2^31, or Empty.
  void Set(const BlockKey& key, std::uint32_t number);
  /// Empty, and it is remembered when: what DroppedAgo tells until the address is set again.
  void Drop(const BlockKey& key, std::uint32_t now) { this->Set(key, now | Dropped); }
  /// How long ago the block was dropped, or one that had its address in a window before; 2^31 - 1
  /// if it was not.
  std::uint32_t DroppedAgo(const BlockKey& key, std::uint32_t now) const
  {
    const std::uint32_t then = this->Numbers[this->Address(key)];
    return then < Dropped || then == Empty ? ~Dropped : (now - then) & ~Dropped;
  }

  /// The numbers of all finer blocks in the place of this one, which is in its window. A look where
  /// there are none.
  std::vector<std::uint32_t> FinerIn(const BlockKey& key) const;
  bool HasFiner(const BlockKey& key) const { return this->FinerCounts[this->Address(key)] > 0; }

private:
  static constexpr std::uint32_t Dropped = 0x80000000U; ///< or more: no number
  struct Window
  {
    glm::ivec3 first{ 0 }, size{ 1 }, blocks{ 1 }; ///< blocks: of the whole volume
    std::size_t offset = 0;                        ///< of its numbers
  };
  std::size_t Address(const BlockKey& key) const
  {
    const Window& w = this->Windows[key.level];
    const glm::ivec3 at = key.block & (w.size - 1);
    return w.offset + (static_cast<std::size_t>(at.z) * w.size.y + at.y) * w.size.x + at.x;
  }

  std::vector<Window> Windows;
  std::vector<std::uint32_t> Numbers;
  std::vector<std::uint32_t> FinerCounts; ///< by address: of the finer blocks in a block's place
};

} // namespace hasp
