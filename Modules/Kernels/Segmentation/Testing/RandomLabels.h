#pragma once
// Small random label maps on stretched and rotated grids, and what all edits promise.
#include "Segmentation/LabelDelta.h"
#include "Segmentation/LabelHash.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>
#include <vector>

namespace hasp::testing
{

/// A label map that owns its labels.
struct LabelMap
{
  GridGeometry geometry;
  std::vector<Label> labels;

  explicit LabelMap(const GridGeometry& grid, Label label = 0)
    : geometry(grid),
      labels(grid.Size(), label)
  {
  }
  GridView<Label> View() { return { labels.data(), geometry }; }
  GridView<const Label> View() const { return { labels.data(), geometry }; }
  Label& At(int i, int j, int k) { return View()(i, j, k); }
  std::uint64_t Hash() const { return HashLabels(View()); }
};

inline GridGeometry PlainGrid(const glm::ivec3& dims, const glm::dvec3& spacing = glm::dvec3(1))
{
  return { dims, glm::dvec3(0), spacing, glm::dmat3(1) };
}

/// Rotated about a skew axis, left-handed every other time, away from the world's origin.
inline GridGeometry SkewGrid(const glm::ivec3& dims, const glm::dvec3& spacing, int seed)
{
  GridGeometry grid{ dims, { 12.5, -40.0, 7.25 }, spacing, glm::dmat3(1) };
  grid.direction =
    glm::dmat3(glm::rotate(glm::dmat4(1), 0.3 + 0.7 * seed, glm::normalize(glm::dvec3(1, 2, -1))));
  if (seed % 2)
    grid.direction[2] *= -1.0;
  return grid;
}

/// `blobs` boxes of labels 1 ... most, later ones over earlier ones, with holes of label 0.
inline LabelMap RandomLabels(const GridGeometry& grid, int blobs, Label most, std::mt19937& random)
{
  LabelMap map(grid);
  const auto pick = [&](int low, int high)
  { return std::uniform_int_distribution<int>(low, high)(random); };
  for (int n = 0; n < blobs; ++n)
  {
    const Label label = static_cast<Label>(n % 4 == 3 ? 0 : pick(1, most));
    VoxelBox box;
    for (int a = 0; a < 3; ++a)
    {
      box.low[a] = pick(0, grid.dims[a] - 1);
      box.high[a] = pick(box.low[a] + 1, grid.dims[a]);
    }
    for (int k = box.low.z; k < box.high.z; ++k)
      for (int j = box.low.y; j < box.high.y; ++j)
        for (int i = box.low.x; i < box.high.x; ++i)
          map.At(i, j, k) = label;
  }
  return map;
}

/// Sizes and spacings that are awkward: 1 along an axis or all of them, 100:1, longer than a block.
inline std::vector<GridGeometry> AwkwardGrids()
{
  return { SkewGrid({ 13, 11, 9 }, { 0.3, 0.45, 0.8 }, 0), SkewGrid({ 1, 14, 10 }, { 1, 1, 1 }, 1),
    SkewGrid({ 19, 1, 7 }, { 0.3, 0.3, 1.2 }, 2), SkewGrid({ 21, 9, 1 }, { 0.5, 0.4, 2 }, 3),
    SkewGrid({ 1, 1, 1 }, { 1, 2, 3 }, 4), SkewGrid({ 8, 9, 40 }, { 5, 5, 0.05 }, 5),
    SkewGrid({ 40, 7, 6 }, { 0.05, 4, 5 }, 6), SkewGrid({ 6, 41, 5 }, { 3, 0.03, 3 }, 7) };
}

/// All voxels of a grid: visit(index, offset).
template <typename Visit>
void ForVoxels(const GridGeometry& grid, Visit&& visit)
{
  std::size_t v = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i, ++v)
        visit(glm::ivec3(i, j, k), v);
}

} // namespace hasp::testing
