#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"

#include <algorithm>
#include <limits>

namespace hasp
{

namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();
}

MinMaxBlocks::MinMaxBlocks(const AnyGridView& grid)
{
  const GridGeometry& geometry = GeometryOf(grid);
  geometry.Validate();
  this->BlockCount = (geometry.Cells() + Side - 1) / Side;
  const glm::ivec3 n = this->BlockCount;
  this->Ranges.resize(static_cast<std::size_t>(n.x) * n.y * n.z);

  std::visit(
    [&](const auto& view)
    {
      const auto layer = [&](std::int64_t first, std::int64_t last)
      {
        for (int bz = int(first); bz < last; ++bz)
          for (int by = 0; by < n.y; ++by)
            for (int bx = 0; bx < n.x; ++bx)
            {
              const glm::ivec3 low = glm::ivec3(bx, by, bz) * Side;
              const glm::ivec3 high = glm::min(low + Side, geometry.dims - 1);
              Range range{ Infinity, -Infinity };
              for (int k = low.z; k <= high.z; ++k)
                for (int j = low.y; j <= high.y; ++j)
                  for (int i = low.x; i <= high.x; ++i)
                  {
                    const float value = static_cast<float>(view(i, j, k));
                    range.min = value < range.min ? value : range.min; // false for NaN
                    range.max = value > range.max ? value : range.max;
                  }
              this->Ranges[this->Index({ bx, by, bz })] = range;
            }
      };
      ParallelFor(0, n.z, 1, layer);
    },
    grid);

  this->Whole = { Infinity, -Infinity };
  for (const Range& range : this->Ranges)
  {
    this->Whole.min = std::min(this->Whole.min, range.min);
    this->Whole.max = std::max(this->Whole.max, range.max);
  }
}

} // namespace hasp
