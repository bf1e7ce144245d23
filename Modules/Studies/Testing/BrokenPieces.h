#pragma once
// Connected pieces of a label map, counted plainly.
#include "Segmentation/LabelMap.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace hasp::testing
{

/// Voxels of each piece of what `in` holds, faces touching, the largest first.
/// joins   whether two neighbours of it belong together
inline std::vector<std::vector<std::size_t>> PiecesOf(
  const GridGeometry& grid, const std::function<bool(std::size_t)>& in,
  const std::function<bool(std::size_t, std::size_t)>& joins = [](std::size_t, std::size_t)
  { return true; })
{
  const std::size_t row = grid.dims.x, slice = row * grid.dims.y, size = grid.Size();
  std::vector<char> seen(size, 0);
  std::vector<std::vector<std::size_t>> pieces;
  for (std::size_t start = 0; start < size; ++start)
  {
    if (seen[start] != 0 || !in(start))
      continue;
    std::vector<std::size_t> piece{ start };
    seen[start] = 1;
    for (std::size_t n = 0; n < piece.size(); ++n)
    {
      const std::size_t v = piece[n], i = v % row, j = v % slice / row, k = v / slice;
      const auto visit = [&](bool inside, std::size_t to)
      {
        if (!inside || seen[to] != 0 || !in(to) || !joins(v, to))
          return;
        seen[to] = 1;
        piece.push_back(to);
      };
      visit(i > 0, v - 1);
      visit(i + 1 < row, v + 1);
      visit(j > 0, v - row);
      visit(v % slice + row < slice, v + row);
      visit(k > 0, v - slice);
      visit(v + slice < size, v + slice);
    }
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(
    pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return pieces;
}

} // namespace hasp::testing
