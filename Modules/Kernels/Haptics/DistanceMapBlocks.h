#pragma once
#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"

#include <algorithm>
#include <cmath>

namespace hasp
{

/// Distances as they count: NaN is +range, infinities are as far as the grid is wide.
class Counted
{
public:
  Counted(const GridView<const float>& distances, float range);
  float operator()(int i, int j, int k) const
  {
    const float d = this->Grid(i, j, k);
    return std::isnan(d) ? this->Range : std::clamp(d, -this->Far, this->Far);
  }

  const GridView<const float>& Grid;

private:
  float Range, Far;
};

/// Of one block: the samples' range, and the square of the steepest slope in its cells that are not
/// wholly inside.
struct BlockFacts
{
  MinMaxBlocks::Range range;
  float slopeSquared;
};

BlockFacts FactsOf(const Counted& counted, const glm::ivec3& block);

} // namespace hasp
