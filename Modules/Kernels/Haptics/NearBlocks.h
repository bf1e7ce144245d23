#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/MinMaxBlocks.h"
#include "Haptics/MapClearance.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace hasp
{

/// The blocks of a moving volume that may hold a piece of its isosurface within reach of a map's
/// body. Looks at groups of 4x4x4 blocks first, at each as long as need be only; that does not
/// depend on the isovalue. HAPTIC; takes memory when it is made.
class NearBlocks
{
public:
  NearBlocks(std::shared_ptr<const MinMaxBlocks> blocks, const GridGeometry& geometry,
    const glm::dvec3& origin);

  /// Of the ball around the origin that holds the whole grid, mm.
  double Radius() const noexcept { return this->Far; }
  std::size_t Bytes() const noexcept
  {
    return (this->GroupStates.size() + this->BlockStates.size()) * sizeof(MapClearance::State);
  }
  /// When MapClearance::Begin says that nothing holds.
  void Forget() noexcept;
  /// In terms of Travelled: until then no block with a surface is near. 0 if one was, as the last
  /// ForEach has found.
  double NoneUntil() const noexcept { return this->NoneNearUntil; }

  struct Ball
  {
    glm::dvec3 center;
    double radius;
  };
  /// Around `count` blocks along each axis, body axes, mm.
  Ball BallOf(const glm::ivec3& firstBlock, int count) const noexcept;
  /// x fastest.
  std::size_t IndexOf(const glm::ivec3& block) const noexcept
  {
    const glm::ivec3 n = this->Blocks->Blocks();
    return (static_cast<std::size_t>(block.z) * n.y + block.y) * n.x + block.x;
  }
  /// Calls visit(block) for each block near of which holds(range) is true.
  template <typename Holds, typename Visit>
  void ForEach(const MapClearance& clearance, const Holds& holds, const Visit& visit) noexcept
  {
    if (clearance.Travelled() < this->AllFarUntil)
      return;
    this->AllFarUntil = this->NoneNearUntil = std::numeric_limits<double>::infinity();
    MapClearance::State* state = this->GroupStates.data();
    for (int z = 0; z < this->Groups.z; ++z)
      for (int y = 0; y < this->Groups.y; ++y)
        for (int x = 0; x < this->Groups.x; ++x, ++state)
        {
          const glm::ivec3 first = glm::ivec3(x, y, z) * GroupSide;
          if (this->IsNear(clearance, first, GroupSide, *state))
            this->ForEachIn(first, clearance, holds, visit);
          else
            this->NoneNearUntil = std::min(this->NoneNearUntil, state->until);
          this->AllFarUntil = std::min(this->AllFarUntil, state->near ? 0.0 : state->until);
        }
  }

private:
  static constexpr int GroupSide = 4;

  bool IsNear(const MapClearance& clearance, const glm::ivec3& first, int count,
    MapClearance::State& state) const noexcept
  {
    if (!(clearance.Travelled() < state.until))
    {
      const Ball ball = this->BallOf(first, count);
      state = clearance.Look(ball.center, ball.radius);
    }
    return state.near;
  }
  template <typename Holds, typename Visit>
  void ForEachIn(const glm::ivec3& first, const MapClearance& clearance, const Holds& holds,
    const Visit& visit) noexcept
  {
    const glm::ivec3 end = glm::min(first + GroupSide, this->Blocks->Blocks());
    const MinMaxBlocks::Range* ranges = this->Blocks->Data();
    for (int z = first.z; z < end.z; ++z)
      for (int y = first.y; y < end.y; ++y)
      {
        const std::size_t row = this->IndexOf({ 0, y, z });
        for (int x = first.x; x < end.x; ++x)
        {
          if (!holds(ranges[row + x]))
            continue;
          MapClearance::State& state = this->BlockStates[row + x];
          if (this->IsNear(clearance, { x, y, z }, 1, state))
            visit(glm::ivec3(x, y, z));
          this->NoneNearUntil = std::min(this->NoneNearUntil, state.near ? 0.0 : state.until);
        }
      }
  }

  std::shared_ptr<const MinMaxBlocks> Blocks;
  GridGeometry Geometry;
  glm::dvec3 Origin;
  double Far = 0.0, AllFarUntil = 0.0, NoneNearUntil = 0.0;
  glm::ivec3 Groups{ 0 };
  std::vector<MapClearance::State> GroupStates, BlockStates;
};

} // namespace hasp
