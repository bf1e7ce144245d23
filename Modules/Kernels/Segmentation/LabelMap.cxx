#include "Segmentation/LabelMap.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

std::vector<std::size_t> CountLabels(GridView<const Label> labels)
{
  const auto voxels = static_cast<std::int64_t>(labels.geometry.Size());
  constexpr std::int64_t grain = 1 << 20;
  std::vector<std::vector<std::size_t>> pieces(
    static_cast<std::size_t>((voxels + grain - 1) / grain));
  ParallelFor(0, voxels, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<std::size_t>& counts = pieces[static_cast<std::size_t>(first / grain)];
      for (std::int64_t v = first; v < last; ++v)
      {
        const Label label = labels.data[v];
        if (label >= counts.size())
          counts.resize(label + 1U);
        ++counts[label];
      }
    });
  std::vector<std::size_t> sum(1);
  for (const std::vector<std::size_t>& counts : pieces)
  {
    sum.resize(std::max(sum.size(), counts.size()));
    for (std::size_t label = 0; label < counts.size(); ++label)
      sum[label] += counts[label];
  }
  return sum;
}

void ThresholdLabels(const AnyGridView& grid, double lowest, double highest, GridView<Label> labels,
  const ProgressFunction& progress)
{
  if (!(lowest <= highest))
    throw std::invalid_argument("thresholds are " + std::to_string(lowest) + " to " +
                                std::to_string(highest) + ", must be numbers, the lowest first");
  if (GeometryOf(grid).dims != labels.geometry.dims)
    throw std::invalid_argument("the label map must be as large as the scan");
  const glm::ivec3 dims = labels.geometry.dims;
  const std::int64_t slice = static_cast<std::int64_t>(dims.x) * dims.y;
  std::visit(
    [&](const auto& view)
    {
      constexpr int slices = 16; // between two looks at progress
      for (int k = 0; k < dims.z; k += slices)
      {
        ReportProgress(progress, static_cast<double>(k) / dims.z);
        ParallelFor(k * slice, std::min(k + slices, dims.z) * slice, slice,
          [&](std::int64_t first, std::int64_t last)
          {
            for (std::int64_t v = first; v < last; ++v)
            {
              const double value = view.data[v];
              labels.data[v] = value >= lowest && value <= highest;
            }
          });
      }
    },
    grid);
  ReportProgress(progress, 1.0);
}

} // namespace hasp
