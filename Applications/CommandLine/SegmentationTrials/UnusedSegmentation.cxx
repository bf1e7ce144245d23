#include "ReportRegistry.h"
#include "SegmentationTrials.h"

#include "Segmentation/LabelSplit.h"

namespace hasp
{

void AddUnusedSegmentation(ReportContext& context)
{
  GridGeometry grid;
  grid.dims = { 4, 4, 4 };
  const std::vector<std::int16_t> samples(grid.Size(), -1000);
  std::vector<Label> labels(grid.Size());
  const GridView<const std::int16_t> air{ samples.data(), grid };
  ThresholdLabels(air, 226.0, 1e6, { labels.data(), grid });
  const VoxelGraph graph(air, { labels.data(), grid }, 1);
  std::size_t bytes = 0;
  for (int axis = 0; axis < 3; ++axis)
    bytes += static_cast<std::size_t>(graph.Nodes()) * sizeof(float);
  context.report.unused.push_back(
    { "nodes and links of air", bytes, 0.0, "a graph has the voxels of bone alone" });
  LabelSplit split(air, { labels.data(), grid }, 1);
  const LabelDelta delta = split.Share({}, { labels.data(), grid });
  context.report.unused.push_back({ "undo of a split that changes nothing", delta.runs.size() * 16,
    0.0, "only runs of changed voxels are kept" });
}

} // namespace hasp
