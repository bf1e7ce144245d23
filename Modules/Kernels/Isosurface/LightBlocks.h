#pragma once
// Private to LightCache and SceneLightCache: where light is kept.
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// A place on a surface among the corners of a cubic lattice of one level.
struct LightPlace
{
  glm::ivec3 corner{ 0 };   ///< the lattice corner below it
  glm::vec3 within{ 0.0F }; ///< from there to the next, [0,1]
  int level = 0;            ///< corners lie 2^level units apart
  int face = 0;             ///< main direction of the normal: axis, plus 3 if it points down it

  /// The same place among the corners of the next level.
  LightPlace Coarser() const;
};

/// How much of the light was seen open there, and by how many samples: the trilinear mean of the
/// corners' sums over that of their counts.
struct LightMean
{
  float open = 0.0F;
  float samples = 0.0F; ///< weights included
};

/// The mean of colours that were added there.
struct ColorMean
{
  glm::vec3 color{ 0.0F };
  float samples = 0.0F; ///< weights included
};

/// A place's lattice corners in the table, x fastest.
struct LightSpot
{
  static constexpr std::uint32_t None = 0xFFFFFFFFU;
  std::uint32_t sums[8];   ///< which entry of the table; None if the block is not there
  std::uint8_t weights[8]; ///< trilinear, in 1/128
  bool whole;              ///< no block is missing
};

class LightBlockFinder;

/// Sums at lattice corners in blocks of 4^3, in a table of fixed size: 8 ways a bucket. What was
/// used longest ago goes first. A table is of openness, 8 bytes a corner, or of colours, 16.
///
/// Threads: Find and Mean from any number at a time, or Find and Add, with the same result, for
/// sums are integers; the others alone.
class LightBlocks
{
public:
  static constexpr int Side = 4, Entries = Side * Side * Side;
  using Key = std::uint64_t; ///< never 0

  enum class Of
  {
    Openness, ///< Mean and Add
    Colors    ///< MeanColor and AddColor
  };
  /// count: of blocks; a multiple of 8, a power of two.
  explicit LightBlocks(std::size_t count, Of what = Of::Openness);
  std::size_t Bytes() const;

  using Finder = LightBlockFinder;

  /// Where the place's sums are, until the next Advance or Forget; begins to fetch them. What is
  /// missing may be there after Make.
  LightSpot Find(Finder& finder, const LightPlace& place) const;
  LightMean Mean(const LightSpot& spot) const;
  /// Adds rays of which so many were open; what has no block is left out.
  void Add(const LightSpot& spot, int rays, int open);

  static constexpr float BrightestColor = 127.0F; ///< what is brighter is added as that
  static constexpr float ColorStep = 1.0F / 64.0F;
  ColorMean MeanColor(const LightSpot& spot) const;
  /// Adds one sample; round: in [0, 1), says whether parts of a ColorStep count up, so that their
  /// mean is right. A sum that is half full takes no more: 15,000 samples of 17.
  void AddColor(const LightSpot& spot, const glm::vec3& color, float round);

  /// The blocks that the place's corners lie in and that are not there, appended; a place's weight
  /// may make a corner's share 0.
  void ListMissing(Finder& finder, const LightPlace& place, std::vector<Key>& missing) const;

  /// A new frame: what is used from now on is newer.
  void Advance() { ++this->Now; }
  /// An empty block in the place of the oldest of its bucket; not if all were used in this frame.
  void Make(Key key);
  void Forget();
  /// All blocks of which a corner's neighbourhood meets the box, in units.
  void Forget(const glm::dvec3& low, const glm::dvec3& high);
  /// Colours count as at most so many samples from now on, so that new ones soon outweigh them. A
  /// pass over the table.
  void Age(float samples);

private:
  friend class LightBlockFinder;
  std::uint32_t Find(Key key) const;

  std::size_t Count;
  std::vector<Key> Keys;           ///< 0: free
  std::vector<std::uint32_t> Used; ///< when
  std::size_t Words;               ///< of an entry
  /// Open samples << 32 | samples, in 1/128; or red << 32 | green, blue << 32 | samples.
  std::unique_ptr<std::uint64_t[]> Sums;
  std::uint32_t Now = 1;
};

/// Finds blocks, and remembers those it found last, for places that lie close together. One a
/// thread, until the next Make or Forget.
class LightBlockFinder
{
public:
  explicit LightBlockFinder(LightBlocks* blocks) : Blocks(blocks) {}
  std::uint32_t operator()(LightBlocks::Key key);

private:
  static constexpr int Slots = 32;
  LightBlocks* Blocks;
  LightBlocks::Key Keys[Slots] = {};
  std::uint32_t Found[Slots] = {};
};

} // namespace hasp
