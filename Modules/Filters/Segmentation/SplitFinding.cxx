#include "SplitFinding.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

namespace hasp
{
namespace
{

/// Marks what a stroke does; whether a voxel of the split was not marked before.
bool Mark(const VoxelGraph& graph, const SeedVoxels& stroke, std::vector<bool>& marked)
{
  const auto width = static_cast<std::uint64_t>(graph.Geometry().dims.x),
             height = static_cast<std::uint64_t>(graph.Geometry().dims.y);
  bool isFirst = false;
  for (const VoxelRun& run : stroke.voxels)
    for (std::uint64_t n = run.first; n < run.first + run.length; ++n)
    {
      const std::int32_t node =
        graph.NodeAt(int(n % width), int(n / width % height), int(n / width / height));
      if (node < 0 || marked[std::size_t(node)])
        continue;
      marked[std::size_t(node)] = true;
      isFirst = true;
    }
  return isFirst;
}

/// Labels of strokes that mark no voxel in the end. The last stroke first: it counts.
std::vector<Label> LabelsWithoutSeeds(const VoxelGraph& graph, std::span<const SeedVoxels> strokes)
{
  std::vector<bool> marked(std::size_t(graph.Nodes()));
  std::set<Label> all, marking;
  for (auto stroke = strokes.rbegin(); stroke != strokes.rend(); ++stroke)
  {
    all.insert(stroke->label);
    if (Mark(graph, *stroke, marked))
      marking.insert(stroke->label);
  }
  std::vector<Label> without;
  std::set_difference(
    all.begin(), all.end(), marking.begin(), marking.end(), std::back_inserter(without));
  return without;
}

} // namespace

void FindSplit(
  const LabelSplit& split, std::span<const SeedVoxels> strokes, SegmentationFinding& found)
{
  found.walk = split.LastRun();
  for (std::size_t n = 0; n < strokes.size(); ++n)
    if (!split.Touches(strokes[n]))
      found.besideBone.push_back(n);
  found.withoutSeeds = LabelsWithoutSeeds(split.Graph(), strokes);
  found.unreached = split.Unreached();
}

} // namespace hasp
