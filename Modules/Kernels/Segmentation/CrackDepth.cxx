#include "Segmentation/CrackDepth.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hasp
{
namespace
{

/// A way through a voxel: so many steps of `step` to each side.
struct Way
{
  glm::ivec3 step;
  int reach;
};

/// One of each two opposite directions to the 26 neighbours.
std::vector<Way> WaysOf(const glm::dvec3& spacing)
{
  const double least = std::min({ spacing.x, spacing.y, spacing.z });
  std::vector<Way> ways;
  for (int n = 14; n < 27; ++n)
  {
    const glm::ivec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const double length = glm::length(glm::dvec3(step) * spacing);
    ways.push_back({ step, std::max(1, static_cast<int>(std::lround(2.0 * least / length))) });
  }
  return ways;
}

/// What fills a crack.
float SoftLevel(std::vector<float> samples)
{
  const auto quantile = [&](double share)
  {
    const auto at =
      samples.begin() + static_cast<std::ptrdiff_t>(share * double(samples.size() - 1));
    std::nth_element(samples.begin(), at, samples.end());
    return double(*at);
  };
  const double low = quantile(0.01);
  return static_cast<float>(
    std::max<double>(low - 0.35 * (quantile(0.5) - low), std::numeric_limits<float>::lowest()));
}

/// The largest value along a side; nothing: the least there is.
template <typename T>
float Brightest(const GridView<const T>& view, glm::ivec3 at, const glm::ivec3& step, int reach)
{
  const glm::ivec3& dims = view.geometry.dims;
  float brightest = std::numeric_limits<float>::lowest();
  for (int n = 0; n < reach; ++n)
  {
    at += step;
    if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= dims.x || at.y >= dims.y || at.z >= dims.z)
      break;
    const auto value = static_cast<float>(view(at.x, at.y, at.z));
    if (value > brightest && value <= std::numeric_limits<float>::max())
      brightest = value;
  }
  return brightest;
}

template <typename T>
float DepthAt(const GridView<const T>& view, const std::vector<Way>& ways, const glm::ivec3& at,
  float value, float soft)
{
  float deepest = 0.0F;
  for (const Way& way : ways)
  {
    const float front = Brightest(view, at, way.step, way.reach);
    if (!(front > value))
      continue;
    const float m = std::min(front, Brightest(view, at, -way.step, way.reach));
    if (m > value && m > soft) // halves, so that nothing overflows
      deepest =
        std::max(deepest, std::min((0.5F * m - 0.5F * value) / (0.5F * m - 0.5F * soft), 1.0F));
  }
  return deepest;
}

} // namespace

std::vector<float> CrackDepths(
  const VoxelGraph& graph, const AnyGridView& grid, const std::vector<float>& samples)
{
  std::vector<float> depths(samples.size());
  if (samples.empty())
    return depths;
  const float soft = SoftLevel(samples);
  const std::vector<Way> ways = WaysOf(graph.Geometry().spacing);
  const glm::ivec3 dims = graph.Geometry().dims;
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, static_cast<std::int64_t>(dims.y) * dims.z, 64,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t row = first; row < last; ++row)
            for (std::int32_t r = graph.RowRuns()[row]; r < graph.RowRuns()[row + 1]; ++r)
            {
              const VoxelGraph::Run& run = graph.Runs()[r];
              for (std::int32_t n = 0; n < run.count; ++n)
                depths[run.first + n] = DepthAt(view, ways,
                  { run.x + n, static_cast<int>(row % dims.y), static_cast<int>(row / dims.y) },
                  samples[run.first + n], soft);
            }
        });
    },
    grid);
  return depths;
}

} // namespace hasp
