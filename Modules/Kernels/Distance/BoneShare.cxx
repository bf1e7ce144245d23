#include "Distance/BoneShare.h"

#include "Distance/EuclideanDistance.h"
#include "Grid/LabelGrid.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double SoftFromMm = 2.0, SoftToMm = 5.0;
constexpr double OwnReachMm = 5.0; // farther from its own bone a voxel has no share
constexpr float MostShare = 1.3F;
constexpr std::size_t MostSoft = 1'000'000; // values that the median is of

void Check(const GridGeometry& scan, const GridGeometry& labels, const BoneShareSettings& s)
{
  CheckLabelGrid("bone share", scan, labels);
  if (!(s.depthMm > 0.0 && s.depthMm <= 20.0))
    throw std::invalid_argument(
      "bone share: depthMm is " + std::to_string(s.depthMm) + ", must be in (0, 20]");
  if (!(s.leastStep > 0.0) || !std::isfinite(s.leastStep))
    throw std::invalid_argument(
      "bone share: leastStep is " + std::to_string(s.leastStep) + ", must be finite and > 0");
  if (s.softValue && !std::isfinite(*s.softValue))
    throw std::invalid_argument("bone share: softValue is not finite");
}

/// visit(voxel's index, i, j, k) for all voxels, on all cores.
template <typename Visit>
void ForEachVoxel(const glm::ivec3& dims, const Visit& visit)
{
  ParallelFor(0, std::int64_t(dims.y) * dims.z, 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
        for (int i = 0; i < dims.x; ++i)
          visit(std::size_t(row) * dims.x + i, i, int(row % dims.y), int(row / dims.y));
    });
}

/// visit(index) for a voxel and its up to 26 neighbours.
template <typename Visit>
void ForNeighbours(const glm::ivec3& dims, int i, int j, int k, const Visit& visit)
{
  for (int z = std::max(0, k - 1); z <= std::min(dims.z - 1, k + 1); ++z)
    for (int y = std::max(0, j - 1); y <= std::min(dims.y - 1, j + 1); ++y)
      for (int x = std::max(0, i - 1); x <= std::min(dims.x - 1, i + 1); ++x)
        visit((std::size_t(z) * dims.y + y) * dims.x + x);
}

/// 1 where a voxel has a label and a neighbour of another, by a face.
std::vector<std::uint8_t> BorderOf(const GridView<const std::uint16_t>& labels)
{
  const glm::ivec3 dims = labels.geometry.dims;
  const std::size_t row = dims.x, slice = row * dims.y;
  std::vector<std::uint8_t> border(labels.geometry.Size(), 0);
  ForEachVoxel(dims,
    [&](std::size_t n, int i, int j, int k)
    {
      const std::uint16_t own = labels.data[n];
      const auto other = [&](bool there, std::size_t at)
      { return there && labels.data[at] != own; };
      border[n] = own != 0 && (other(i > 0, n - 1) || other(i + 1 < dims.x, n + 1) ||
                                other(j > 0, n - row) || other(j + 1 < dims.y, n + row) ||
                                other(k > 0, n - slice) || other(k + 1 < dims.z, n + slice));
    });
  return border;
}

/// Where a label is as deep as anywhere near: what its values are taken from.
std::vector<std::uint8_t> CoreOf(
  const GridView<const std::uint16_t>& labels, std::span<const float> toBorder2, double depthMm)
{
  const GridGeometry& grid = labels.geometry;
  const double step = std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
  // A border voxel is half a step deep already.
  const double deep = std::max(depthMm - step, 0.45 * step);
  std::vector<std::uint8_t> core(grid.Size(), 0);
  ForEachVoxel(grid.dims,
    [&](std::size_t n, int i, int j, int k)
    {
      if (labels.data[n] == 0)
        return;
      bool deepest = true;
      if (toBorder2[n] < deep * deep)
        ForNeighbours(grid.dims, i, j, k,
          [&](std::size_t at) {
            deepest =
              deepest && !(labels.data[at] == labels.data[n] && toBorder2[at] > toBorder2[n]);
          });
      core[n] = deepest;
    });
  return core;
}

/// Bone's own value at each voxel of the core: the mean of the core around it; in walls of two
/// voxels, where no core is deep, the brightest.
template <typename T>
std::vector<float> OwnValues(const GridView<const T>& grey,
  const GridView<const std::uint16_t>& labels, std::span<const std::uint8_t> core,
  std::span<const float> toBorder2)
{
  std::vector<float> own(core.size(), 0.0F);
  ForEachVoxel(labels.geometry.dims,
    [&](std::size_t n, int i, int j, int k)
    {
      if (core[n] == 0)
        return;
      double sum = 0.0, brightest = -1e300;
      int count = 0;
      ForNeighbours(labels.geometry.dims, i, j, k,
        [&](std::size_t at)
        {
          if (labels.data[at] != labels.data[n])
            return;
          const double value = double(grey.data[at]);
          brightest = std::max(brightest, value);
          if (core[at] != 0)
          {
            sum += value;
            ++count;
          }
        });
      own[n] = float(toBorder2[n] > 0.0F && count > 1 ? sum / count : brightest);
    });
  return own;
}

template <typename T>
double MeasuredSoft(const GridView<const T>& grey, const GridView<const std::uint16_t>& labels,
  std::span<const float> toBone2)
{
  std::vector<double> values;
  const auto soft = [&](std::size_t n)
  {
    return labels.data[n] == 0 && toBone2[n] >= SoftFromMm * SoftFromMm &&
           toBone2[n] <= SoftToMm * SoftToMm && std::isfinite(double(grey.data[n]));
  };
  std::size_t count = 0;
  for (std::size_t n = 0; n < toBone2.size(); ++n)
    count += soft(n);
  if (count == 0)
    throw std::runtime_error("bone share: there is nothing within 5 mm of the labels to measure "
                             "soft tissue with; say softValue");
  const std::size_t step = count / MostSoft + 1;
  count = 0;
  for (std::size_t n = 0; n < toBone2.size(); ++n)
    if (soft(n) && count++ % step == 0)
      values.push_back(double(grey.data[n]));
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
} // namespace

BoneShares ShareBone(const AnyGridView& grey, const GridView<const std::uint16_t>& labels,
  const BoneShareSettings& settings, const ProgressFunction& progress)
{
  const GridGeometry& grid = labels.geometry;
  Check(GeometryOf(grey), grid, settings);
  const std::vector<std::uint8_t> border = BorderOf(labels);
  if (std::none_of(border.begin(), border.end(), [](std::uint8_t b) { return b != 0; }))
    throw std::runtime_error("bone share: no voxel has a label beside one of another, or of none");
  std::vector<float> toBorder2 = NearestSeeds(grid, border, PartOf(progress, 0.0, 0.4)).squared;
  const std::vector<std::uint8_t> core = CoreOf(labels, toBorder2, settings.depthMm);
  const FeatureTransform nearest = NearestSeeds(grid, core, PartOf(progress, 0.4, 0.8));
  BoneShares made;
  made.shares.assign(grid.Size(), 0.0F);
  made.labels.assign(grid.Size(), 0);
  std::visit(
    [&]<typename T>(const GridView<const T>& view)
    {
      made.softValue =
        settings.softValue ? *settings.softValue : MeasuredSoft(view, labels, toBorder2);
      const std::vector<float> own = OwnValues(view, labels, core, toBorder2);
      ForEachVoxel(grid.dims,
        [&](std::size_t n, int, int, int)
        {
          const std::uint32_t from = nearest.seed[n];
          const std::uint16_t whose = labels.data[from];
          const double step = own[from] - made.softValue, value = double(view.data[n]);
          if ((labels.data[n] != 0 && labels.data[n] != whose) || !(step >= settings.leastStep) ||
              nearest.squared[n] > OwnReachMm * OwnReachMm || !std::isfinite(value))
            return;
          made.shares[n] = std::clamp(float((value - made.softValue) / step), 0.0F, MostShare);
          if (made.shares[n] >= 0.5F)
            made.labels[n] = whose;
        });
    },
    grey);
  ReportProgress(progress, 1.0);
  return made;
}

} // namespace hasp
