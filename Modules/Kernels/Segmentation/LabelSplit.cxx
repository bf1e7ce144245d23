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
template <typename Visit>
void ForNodes(const VoxelGraph& graph, const VoxelRun& run, const Visit& visit)
{
  const glm::ivec3 dims = graph.Geometry().dims;
  const auto row = static_cast<std::int64_t>(run.first / static_cast<std::uint64_t>(dims.x));
  const int x = static_cast<int>(run.first % static_cast<std::uint64_t>(dims.x));
  for (std::uint32_t n = 0; n < run.length; ++n)
    if (const std::int32_t node = graph.NodeAt(
          x + static_cast<int>(n), static_cast<int>(row % dims.y), static_cast<int>(row / dims.y));
        node >= 0)
      visit(node);
}

} // namespace

LabelSplit::LabelSplit(const AnyGridView& grid, GridView<const Label> labels, Label l,
  const SplitSettings& settings, const ProgressFunction& progress)
  : label(l),
    norm(settings.norm)
{
  if (!(norm >= 1.0 && norm <= 2.0))
    throw std::invalid_argument("norm is " + std::to_string(norm) + ", must be in [1, 2]");
  graph = std::make_shared<const VoxelGraph>(
    grid, labels, label, settings.weights, PartOf(progress, 0.0, 0.5));
  if (norm < 2.0)
    sharp.emplace(graph, PartOf(progress, 0.5, 1.0));
  else
    walker.emplace(graph, PartOf(progress, 0.5, 1.0));
}

void LabelSplit::Forget()
{
  if (walker)
    walker->SetSeeds({});
}

LabelDelta LabelSplit::Share(std::span<const SeedVoxels> strokes, GridView<Label> labels,
  const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  if (labels.geometry.dims != Graph().Geometry().dims)
    throw std::invalid_argument("the label map must be as large as the one that is split");
  std::vector<WalkerSeed> seeds;
  for (const SeedVoxels& stroke : strokes)
    for (const VoxelRun& voxels : stroke.voxels)
      ForNodes(Graph(), voxels,
        [&](std::int32_t node) {
          seeds.push_back({ node, stroke.label });
        });
  const std::size_t size = labels.geometry.Size();
  std::vector<Label> after(labels.data, labels.data + size);
  Solve(std::move(seeds), { after.data(), labels.geometry }, settings, PartOf(progress, 0.0, 0.95));
  const GridView<const Label> view{ after.data(), labels.geometry };
  LabelDelta delta = DifferenceOf(
    { labels.data, labels.geometry }, view, VoxelBox{ glm::ivec3(0), labels.geometry.dims });
  ReportProgress(progress, 1.0);
  std::copy(after.begin(), after.end(), labels.data);
  return delta;
}

/// Writes the labels of all voxels of the split.
void LabelSplit::Solve(std::vector<WalkerSeed> seeds, GridView<Label> labels,
  const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  std::vector<Label> shares; // of nodes; none where the walker writes them itself
  if (sharp)
  {
    SharpWalker::Shares solved = sharp->Solve(std::move(seeds), norm, settings, progress);
    shares = std::move(solved.labels);
    run = solved.run;
  }
  else
  {
    walker->SetSeeds(std::move(seeds));
    run = walker->Solve(settings, progress);
  }
  const auto forRuns = [&](const auto& visit)
  {
    for (std::size_t row = 0; row + 1 < Graph().RowRuns().size(); ++row)
      for (std::int32_t n = Graph().RowRuns()[row]; n < Graph().RowRuns()[row + 1]; ++n)
      {
        const VoxelGraph::Run& part = Graph().Runs()[std::size_t(n)];
        Label* first = labels.data + row * std::size_t(labels.geometry.dims.x) + part.x;
        visit(part, first, first + part.count);
      }
  };
  forRuns(
    [&](const VoxelGraph::Run& part, Label* first, Label* last)
    {
      if (sharp)
        std::copy_n(shares.begin() + part.first, part.count, first);
      else
        std::fill(first, last, Label(0));
    });
  if (walker)
    walker->WriteLabels(labels); // what no seed is connected to keeps its 0
  unreached = 0;
  forRuns(
    [&](const VoxelGraph::Run&, Label* first, Label* last)
    {
      unreached += static_cast<std::uint64_t>(std::count(first, last, Label(0)));
      std::replace(first, last, Label(0), label);
    });
}

bool LabelSplit::Touches(const SeedVoxels& stroke) const
{
  return std::any_of(stroke.voxels.begin(), stroke.voxels.end(),
    [&](const VoxelRun& voxels)
    {
      bool touches = false;
      ForNodes(Graph(), voxels, [&](std::int32_t) { touches = true; });
      return touches;
    });
}

} // namespace hasp
