#include "Segmentation/LabelSplit.h"

#include "Grid/ProgressPart.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace hasp
{

namespace
{

/// Nodes of a run: within its row they follow each other, where they are bone.
void AddSeeds(
  const VoxelGraph& graph, const VoxelRun& run, Label label, std::vector<WalkerSeed>& seeds)
{
  const glm::ivec3 dims = graph.Geometry().dims;
  const auto row = static_cast<std::int64_t>(run.first / static_cast<std::uint64_t>(dims.x));
  const int x = static_cast<int>(run.first % static_cast<std::uint64_t>(dims.x));
  for (std::uint32_t n = 0; n < run.length; ++n)
    if (const std::int32_t node = graph.NodeAt(
          x + static_cast<int>(n), static_cast<int>(row % dims.y), static_cast<int>(row / dims.y));
        node >= 0)
      seeds.push_back({ node, label });
}

} // namespace

LabelSplit::LabelSplit(const AnyGridView& grid, GridView<const Label> labels, Label l,
  const EdgeWeightSettings& weights, const ProgressFunction& progress)
  : label(l),
    walker(std::make_shared<const VoxelGraph>(grid, labels, l, weights, PartOf(progress, 0.0, 0.5)),
      PartOf(progress, 0.5, 1.0))
{
}

LabelDelta LabelSplit::Share(std::span<const SeedVoxels> strokes, GridView<Label> labels,
  const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  if (labels.geometry.dims != Graph().Geometry().dims)
    throw std::invalid_argument("the label map must be as large as the one that is split");
  std::vector<WalkerSeed> seeds;
  for (const SeedVoxels& stroke : strokes)
    for (const VoxelRun& voxels : stroke.voxels)
      AddSeeds(Graph(), voxels, stroke.label, seeds);
  walker.SetSeeds(std::move(seeds));
  run = walker.Solve(settings, PartOf(progress, 0.0, 0.95));

  const std::size_t size = labels.geometry.Size();
  std::vector<Label> after(labels.data, labels.data + size);
  walker.WriteLabels({ after.data(), labels.geometry }, label);
  const GridView<const Label> view{ after.data(), labels.geometry };
  LabelDelta delta = DifferenceOf(
    { labels.data, labels.geometry }, view, VoxelBox{ glm::ivec3(0), labels.geometry.dims });
  ReportProgress(progress, 1.0);
  std::copy(after.begin(), after.end(), labels.data);
  return delta;
}

} // namespace hasp
