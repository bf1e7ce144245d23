#pragma once
#include "ContactRivals.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace rival::o2
{

/// What a developer writes for a shell that follows contact: each tick it looks at all blocks that
/// the surface crosses, draws points at random in crossed cells of those that are near, puts them
/// onto the surface by Newton steps, and into a ring, where the oldest ones go. A block's cells are
/// looked for when it comes near, and forgotten when it goes: nothing is prepared. Points are not
/// spread evenly over the area, nor faded.
class DynamicShell
{
public:
  /// `own`, of the moving body, and `other` must outlive it. room: points of the ring.
  DynamicShell(const Map& own, const Map& other, std::size_t room);

  void Update(const Pose& pose, int draws, float marginMm);
  const std::vector<Point>& Points() const { return this->Ring; }

private:
  struct Block
  {
    glm::ivec3 first;
    std::vector<glm::ivec3> cells; ///< crossed; none: not looked for yet
  };
  void FindCells(Block& block) const;
  bool Crossed(const glm::ivec3& cell) const;
  bool Project(Point& point) const;
  std::uint32_t Random()
  {
    this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::uint32_t>(this->State >> 33);
  }
  float Share() { return static_cast<float>(this->Random()) * 0x1p-31F; }

  Map Own, Other;
  std::vector<Block> Blocks;
  std::vector<Block*> Near;
  std::vector<Point> Ring;
  std::size_t Room, Head = 0;
  std::uint64_t State = 1;
};

} // namespace rival::o2
