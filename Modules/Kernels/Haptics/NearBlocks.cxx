#include "Haptics/NearBlocks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{

NearBlocks::NearBlocks(std::shared_ptr<const MinMaxBlocks> blocks, const GridGeometry& geometry,
  const glm::dvec3& origin)
  : Blocks(std::move(blocks)),
    Geometry(geometry),
    Origin(origin),
    Groups((this->Blocks->Blocks() + GroupSide - 1) / GroupSide),
    GroupStates(static_cast<std::size_t>(this->Groups.x) * this->Groups.y * this->Groups.z),
    BlockStates(this->Blocks->Count())
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 at = glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * geometry.Cells();
    this->Far = std::max(this->Far, glm::distance(geometry.IndexToWorld(at), origin));
  }
}

void NearBlocks::Forget() noexcept
{
  this->AllFarUntil = this->NoneNearUntil = 0.0;
  std::fill(this->GroupStates.begin(), this->GroupStates.end(), MapClearance::State());
  std::fill(this->BlockStates.begin(), this->BlockStates.end(), MapClearance::State());
}

NearBlocks::Ball NearBlocks::BallOf(const glm::ivec3& firstBlock, int count) const noexcept
{
  const glm::ivec3 low = firstBlock * MinMaxBlocks::Side;
  const glm::ivec3 high = glm::min(low + count * MinMaxBlocks::Side, this->Geometry.Cells());
  const glm::dvec3 middle = 0.5 * glm::dvec3(low + high);
  return { this->Geometry.IndexToWorld(middle) - this->Origin,
    0.5 * glm::length(glm::dvec3(high - low) * this->Geometry.spacing) };
}

} // namespace hasp
