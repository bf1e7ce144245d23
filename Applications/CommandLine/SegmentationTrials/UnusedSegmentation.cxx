#include "ReportRegistry.h"
#include "SegmentationTrials.h"

#include "Segmentation/LabelSplit.h"

namespace hasp
{
namespace
{

/// A bar of bone, with so many voxels of air behind it along x.
struct Bar
{
  GridGeometry grid;
  std::vector<std::int16_t> samples;
  std::vector<Label> labels;

  explicit Bar(int air)
  {
    grid.dims = { 4 + air, 4, 4 };
    samples.resize(grid.Size());
    labels.resize(grid.Size());
    for (std::size_t v = 0; v < samples.size(); ++v)
      samples[v] = int(v) % grid.dims.x < 4 ? 1000 : -1000;
    ThresholdLabels(Samples(), 226.0, 1e6, { labels.data(), grid });
  }
  GridView<const std::int16_t> Samples() const { return { samples.data(), grid }; }
  LabelSplit Split() const { return { Samples(), { labels.data(), grid }, 1 }; }
};

} // namespace

void AddUnusedSegmentation(ReportContext& context)
{
  Bar bar(400);
  LabelSplit split = bar.Split();
  context.report.unused.push_back({ "graph and solver of air",
    split.Bytes() - Bar(0).Split().Bytes(), 0.0, "a graph has the voxels of bone alone" });
  const SeedVoxels stroke{ 1, { { 0, 2 } } }; // all of it keeps its label
  const LabelDelta delta = split.Share({ &stroke, 1 }, { bar.labels.data(), bar.grid });
  context.report.unused.push_back({ "undo of a split that changes nothing",
    delta.Bytes() - sizeof(delta), 0.0, "only runs of changed voxels are kept" });
}

} // namespace hasp
