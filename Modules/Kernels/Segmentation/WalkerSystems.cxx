#include "Segmentation/WalkerSystems.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp::walk
{

void CheckBytes(std::size_t bytes, const VoxelGraph& graph, std::size_t labels, std::size_t most)
{
  if (bytes > most)
    throw std::invalid_argument(
      "sharing " + std::to_string(graph.Nodes()) + " voxels out among " + std::to_string(labels) +
      " labels takes " + std::to_string(bytes >> 20) + " MiB, may take " +
      std::to_string(most >> 20) + "; use fewer labels, or split in parts");
}

std::size_t BatchesOf(std::size_t labels)
{
  return labels < 2 ? 0 : (labels - 1 + LaneCount - 1) / LaneCount;
}

std::vector<WalkerSeed> OrderSeeds(const VoxelGraph& graph, std::vector<WalkerSeed> seeds)
{
  for (const WalkerSeed& seed : seeds)
    if (seed.node < 0 || seed.node >= graph.Nodes() || seed.label == 0)
      throw std::invalid_argument("a seed is at node " + std::to_string(seed.node) +
                                  " with label " + std::to_string(seed.label) +
                                  ", must be at a node in [0, " + std::to_string(graph.Nodes()) +
                                  ") with a label in [1, 65535]");
  std::stable_sort(seeds.begin(), seeds.end(),
    [](const WalkerSeed& a, const WalkerSeed& b) { return a.node < b.node; });
  std::vector<WalkerSeed> each;
  for (const WalkerSeed& seed : seeds)
    if (!each.empty() && each.back().node == seed.node)
      each.back() = seed;
    else
      each.push_back(seed);
  return each;
}

std::vector<Label> LabelsOf(const std::vector<WalkerSeed>& seeds)
{
  std::vector<Label> labels;
  for (const WalkerSeed& seed : seeds)
    labels.push_back(seed.label);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

void CheckSettings(const RandomWalkerSettings& settings)
{
  if (!(settings.tolerance > 0.0 && settings.tolerance <= 0.1))
    throw std::invalid_argument(
      "tolerance is " + std::to_string(settings.tolerance) + ", must be in (0, 0.1]");
  if (settings.mostIterations < 1 || settings.mostIterations > 100000)
    throw std::invalid_argument(
      "mostIterations is " + std::to_string(settings.mostIterations) + ", must be in [1, 100000]");
}

Lanes Systems::Known(std::size_t batch, std::int32_t label) const
{
  Lanes value{};
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const std::size_t at = batch * LaneCount + static_cast<std::size_t>(lane);
    if (at < lanes.size() && lanes[at] != 0 && lanes[at] == label)
      value[lane] = 1.0F;
  }
  return value;
}

Label Systems::Best(const std::vector<NodeValues>& batches, std::int64_t node) const
{
  float sum = 0.0F;
  float most = -1.0F;
  Label best = 0;
  const auto take = [&](Label label, float probability)
  {
    if (probability > most || (probability == most && label < best))
    {
      most = probability;
      best = label;
    }
  };
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    if (lanes[lane] != 0)
    {
      const float probability =
        batches[lane / LaneCount].data()[node][static_cast<int>(lane % LaneCount)];
      sum += probability;
      take(lanes[lane], probability);
    }
  take(rest, 1.0F - sum);
  return best;
}

} // namespace hasp::walk
