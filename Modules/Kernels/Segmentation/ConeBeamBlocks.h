#pragma once
#include "Grid/GridView.h"
#include "Grid/ParallelFor.h"
#include "Grid/Progress.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hasp
{

/// A volume cut into blocks of whole voxels; the last ones along an axis may be smaller. What is
/// known of each is thought to lie at the middle of a whole one.
struct BlockGrid
{
  glm::ivec3 dims{ 0 };   ///< samples of the volume
  glm::ivec3 voxels{ 1 }; ///< of a block along each axis, >= 1
  glm::ivec3 count{ 0 };  ///< blocks along each axis
  glm::dvec3 edgeMm{ 0.0 };

  std::size_t Size() const { return std::size_t(this->count.x) * this->count.y * this->count.z; }
  std::size_t Offset(const glm::ivec3& b) const
  {
    return (std::size_t(b.z) * this->count.y + b.y) * this->count.x + b.x;
  }
  /// Where a sample's index lies among the blocks' middles.
  double Place(int axis, double index) const { return (index + 0.5) / this->voxels[axis] - 0.5; }
};

/// Blocks of about edgeMm, larger where there would be more than 32,768.
BlockGrid MakeBlocks(const GridGeometry& geometry, double edgeMm);

/// What the samples of each block are: how many in each of 64 bins, and the mean of those.
struct BlockHistograms
{
  static constexpr int Bins = 64;
  struct Block
  {
    std::array<std::uint32_t, Bins> count{};
    std::array<float, Bins> mean{};
    glm::vec3 centroid{ 0.0F }; ///< of the samples counted, in blocks from the block's middle
  };
  std::vector<Block> blocks;
};

/// Histograms of value(sample number) over [low, high); what is NaN or beyond is not counted.
/// Reports progress; the same with any number of threads.
template <typename Value>
BlockHistograms CountBlocks(const BlockGrid& grid, double low, double high, const Value& value,
  const ProgressFunction& progress)
{
  constexpr int Bins = BlockHistograms::Bins;
  BlockHistograms histograms{ std::vector<BlockHistograms::Block>(grid.Size()) };
  struct Sums
  {
    std::array<double, Bins> value{};
    glm::dvec3 place{ 0.0 };
    double count = 0.0;
  };
  const double perBin = Bins / (high - low);
  const auto row = [&](std::int64_t n)
  {
    const glm::ivec3 first(0, n % grid.count.y, n / grid.count.y);
    const glm::ivec3 from = first * grid.voxels;
    const glm::ivec3 to = glm::min(from + grid.voxels, grid.dims);
    BlockHistograms::Block* blocks = &histograms.blocks[grid.Offset(first)];
    std::vector<Sums> sums(grid.count.x);
    for (int k = from.z; k < to.z; ++k)
      for (int j = from.y; j < to.y; ++j)
      {
        const std::size_t start = (std::size_t(k) * grid.dims.y + j) * grid.dims.x;
        const glm::dvec2 place(grid.Place(1, j) - first.y, grid.Place(2, k) - first.z);
        for (int b = 0; b < grid.count.x; ++b)
          for (int i = b * grid.voxels.x; i < std::min((b + 1) * grid.voxels.x, grid.dims.x); ++i)
          {
            const double v = value(start + i);
            if (!(v >= low && v < high))
              continue;
            const int bin = std::min(static_cast<int>((v - low) * perBin), Bins - 1);
            ++blocks[b].count[bin];
            sums[b].value[bin] += v;
            sums[b].place += glm::dvec3(grid.Place(0, i) - b, place);
            sums[b].count += 1.0;
          }
      }
    for (int b = 0; b < grid.count.x; ++b)
    {
      for (int bin = 0; bin < Bins; ++bin)
        if (blocks[b].count[bin] > 0)
          blocks[b].mean[bin] = float(sums[b].value[bin] / blocks[b].count[bin]);
      if (sums[b].count > 0.0)
        blocks[b].centroid = glm::vec3(sums[b].place / sums[b].count);
    }
  };
  const std::int64_t rows = std::int64_t(grid.count.y) * grid.count.z;
  constexpr std::int64_t together = 64; // between two looks at progress
  for (std::int64_t n = 0; n < rows; n += together)
  {
    ReportProgress(progress, double(n) / double(rows));
    ParallelFor(
      n, std::min(n + together, rows), 1, [&](std::int64_t at, std::int64_t) { row(at); });
  }
  return histograms;
}

/// One number a block, read in between: trilinear between the blocks' middles, and on along the
/// same line beyond the outermost of them.
class BlockField
{
public:
  BlockField(const BlockGrid& grid, std::vector<double> values);

  double At(const glm::dvec3& place) const; ///< in blocks, as BlockGrid::Place has it
  /// Of the samples of row (j, k): dims.x values.
  void Row(int j, int k, std::vector<float>& row) const;

private:
  struct Between
  {
    int below;
    double share; ///< of the one above; < 0 and > 1 beyond the ends
  };
  Between Along(int axis, double place) const;

  BlockGrid Grid;
  std::vector<double> Values;
  std::vector<Between> Columns;
};

} // namespace hasp
