#include "Isosurface/ClusterCulling.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

std::vector<ClusterPart> DivideClusters(const ClusteredCells& cells, std::size_t blockBytes)
{
  if (blockBytes < LeastBlockBytes)
    throw std::invalid_argument("storage blocks of " + std::to_string(blockBytes) +
                                " bytes are too small for clusters: at least " +
                                std::to_string(LeastBlockBytes) + " are needed");
  constexpr std::size_t clusterStep = 8, wordStep = 64;
  const std::size_t wordLimit = blockBytes / sizeof(std::uint32_t) - wordStep;
  // A vertex's number, 512 * 6 a cluster, must fit a GLint.
  const std::size_t clusterLimit =
    std::min<std::size_t>(blockBytes / sizeof(CellCluster), 0x7FFFFFFF / (512 * 6));
  const std::size_t count = cells.clusters.size();
  // Two words more: the last pair of corners is read as whole words.
  const auto endWord = [&](std::size_t c)
  {
    return c < count ? std::min<std::size_t>(cells.clusters[c].firstWord + 2, cells.corners.size())
                     : cells.corners.size();
  };
  std::vector<std::size_t> cornersBefore{ 0 }; // each may have a colour, a word
  for (const CellCluster& cluster : cells.clusters)
    cornersBefore.push_back(cornersBefore.back() + cluster.CornerCount());
  std::vector<ClusterPart> parts;
  for (std::size_t first = 0, end = 0; first < count; first = end)
  {
    const std::size_t firstWord = cells.clusters[first].firstWord / wordStep * wordStep;
    const auto fits = [&](std::size_t to)
    {
      return to - first <= clusterLimit && endWord(to) - firstWord <= wordLimit &&
             cornersBefore[to] - cornersBefore[first] <= wordLimit;
    };
    while (end < count && fits(std::min(end + clusterStep, count)))
      end = std::min(end + clusterStep, count);
    parts.push_back({ first, end, firstWord, endWord(end) });
  }
  return parts;
}

} // namespace hasp
