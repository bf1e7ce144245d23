#include "Segmentation/SharpWalker.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Segmentation/LocalGraph.h"
#include "Segmentation/SharpLevels.h"
#include "Segmentation/WalkerSystems.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

using walk::LaneCount;
using walk::NodeValues;
using walk::noLabel;
using walk::severalLabels;

namespace
{

/// Above, aggregates are joined once more: in bone of millions of voxels they are then some two
/// millimetres across, as they are in a coarser scan.
constexpr std::int32_t manyAggregates = 1 << 17;

template <typename Visit>
void ForNodes(std::int64_t count, const Visit& visit)
{
  ParallelFor(0, count, walk::nodesAPass,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        visit(n);
    });
}

/// Which piece of the graph each node is in.
std::vector<std::int32_t> FindPieces(const walk::CoarseGraph& graph, std::int32_t& pieces)
{
  std::vector<std::int32_t> piece(static_cast<std::size_t>(graph.Nodes()), -1);
  std::vector<std::int32_t> open;
  pieces = 0;
  for (std::int32_t start = 0; start < graph.Nodes(); ++start)
  {
    if (piece[start] >= 0)
      continue;
    piece[start] = pieces;
    open.assign(1, start);
    while (!open.empty())
    {
      const std::int32_t n = open.back();
      open.pop_back();
      for (std::int64_t l = graph.firstLink[n]; l < graph.firstLink[n + 1]; ++l)
        if (const std::int32_t to = graph.to[l]; piece[to] < 0)
        {
          piece[to] = pieces;
          open.push_back(to);
        }
    }
    ++pieces;
  }
  return piece;
}

/// What seeds say of aggregates.
struct CoarseSeeds
{
  std::vector<Label> label;        ///< that most of its seeds have, of equal ones the smallest
  std::vector<std::uint8_t> mixed; ///< it has seeds of others, too
};

CoarseSeeds SeedsOf(
  const std::vector<std::int32_t>& of, std::int32_t count, const std::vector<WalkerSeed>& seeds)
{
  std::vector<std::pair<std::int32_t, Label>> pairs;
  pairs.reserve(seeds.size());
  for (const WalkerSeed& seed : seeds)
    pairs.emplace_back(of[seed.node], seed.label);
  std::sort(pairs.begin(), pairs.end());
  CoarseSeeds result{ std::vector<Label>(count), std::vector<std::uint8_t>(count) };
  std::ptrdiff_t most = 0;
  for (auto first = pairs.begin(); first != pairs.end();)
  {
    const auto last = std::upper_bound(first, pairs.end(), *first);
    const std::int32_t node = first->first;
    result.mixed[node] = result.label[node] != 0;
    if (result.label[node] == 0 || last - first > most)
    {
      result.label[node] = first->second;
      most = last - first;
    }
    first = last;
  }
  return result;
}

void CheckNorm(double norm)
{
  if (!(norm >= 1.0 && norm <= 2.0))
    throw std::invalid_argument("norm is " + std::to_string(norm) + ", must be in [1, 2]");
}

/// A system for each label but the first.
walk::Systems SystemsOf(const std::vector<Label>& labels)
{
  return { { labels.begin() + 1, labels.end() }, labels.front() };
}

} // namespace

struct SharpWalker::Internals
{
  std::shared_ptr<const VoxelGraph> graph;
  std::size_t mostBytes;
  std::vector<std::int32_t> of; ///< a voxel's aggregate
  walk::CoarseGraph coarse;     ///< of aggregates
  std::vector<std::int32_t> piece;
  std::int32_t pieces = 0;

  Internals(std::shared_ptr<const VoxelGraph> g, const ProgressFunction& progress, std::size_t most)
    : graph(std::move(g)),
      mostBytes(walk::CheckBytes(*graph, 2, most))
  {
    walk::Aggregates blocks = walk::AggregateVoxels(*graph);
    ReportProgress(progress, 0.3);
    coarse = walk::Coarsen(*graph, blocks);
    of = std::move(blocks.of);
    ReportProgress(progress, 0.7);
    std::int32_t before = 0;
    do
    {
      before = coarse.Nodes();
      const walk::Aggregates up = walk::AggregateNodes(coarse);
      coarse = walk::Coarsen(coarse, up);
      ForNodes(graph->Nodes(), [&](std::int64_t n) { of[n] = up.of[of[n]]; });
    } while (coarse.Nodes() > manyAggregates && coarse.Nodes() < before / 2);
    piece = FindPieces(coarse, pieces);
    ReportProgress(progress, 1.0);
  }

  /// noLabel, severalLabels or the one label of a piece's seeds.
  std::vector<std::int32_t> PieceLabels(const std::vector<WalkerSeed>& seeds) const
  {
    std::vector<std::int32_t> labels(static_cast<std::size_t>(pieces), noLabel);
    for (const WalkerSeed& seed : seeds)
    {
      std::int32_t& label = labels[piece[of[seed.node]]];
      label = walk::WithSeed(label, seed.label);
    }
    return labels;
  }

  /// The label of each aggregate.
  std::vector<Label> SolveCoarse(const CoarseSeeds& seeds,
    const std::vector<std::int32_t>& pieceLabels, const walk::Systems& systems,
    const walk::SharpSettings& settings, const ProgressFunction& progress,
    walk::SharpRun& run) const
  {
    const std::int32_t nodes = coarse.Nodes();
    std::vector<Label> labels(static_cast<std::size_t>(nodes));
    std::vector<std::uint8_t> fixed(labels.size());
    std::vector<NodeValues> x;
    for (std::size_t b = 0; b * LaneCount < systems.lanes.size(); ++b)
      x.emplace_back(nodes);
    for (std::int32_t a = 0; a < nodes; ++a)
    {
      const std::int32_t known = pieceLabels[piece[a]];
      labels[a] = known > 0 ? static_cast<Label>(known) : seeds.label[a];
      fixed[a] = known != severalLabels || labels[a] != 0;
      for (std::size_t b = 0; b < x.size() && labels[a] != 0; ++b)
        x[b].data()[a] = systems.Known(b, labels[a]);
    }
    if (std::find(fixed.begin(), fixed.end(), 0) == fixed.end())
      return labels;
    run = walk::Sharpen(coarse, fixed, x, settings, progress);
    for (std::int32_t a = 0; a < nodes; ++a)
      if (fixed[a] == 0)
        labels[a] = systems.Best(x, a);
    return labels;
  }

  /// Voxels whose aggregate has a neighbour of another label, or seeds of several.
  std::vector<std::uint8_t> NearBorders(
    const std::vector<Label>& labels, const CoarseSeeds& seeds) const
  {
    std::vector<std::uint8_t> near(labels.size());
    ForNodes(coarse.Nodes(),
      [&](std::int64_t a)
      {
        bool border = seeds.mixed[a] != 0;
        for (std::int64_t l = coarse.firstLink[a]; l < coarse.firstLink[a + 1] && !border; ++l)
          border = labels[coarse.to[l]] != labels[a] || seeds.mixed[coarse.to[l]] != 0;
        near[a] = border;
      });
    std::vector<std::uint8_t> voxels(of.size());
    ForNodes(graph->Nodes(), [&](std::int64_t n) { voxels[n] = near[of[n]]; });
    return voxels;
  }

  /// Solves where `near` is not 0, and writes labels there. The outermost voxels hold.
  RandomWalkerRun SolveFine(const std::vector<WalkerSeed>& seeds,
    const std::vector<std::uint8_t>& near, const walk::Systems& systems,
    const walk::SharpSettings& settings, const ProgressFunction& progress,
    std::vector<Label>& labels) const
  {
    const walk::LocalGraph local(*graph, near);
    RandomWalkerRun result;
    if (local.pieces.empty())
      return result;
    std::vector<std::int32_t> fixed = local.rim;
    auto seed = seeds.begin();
    for (const walk::LocalGraph::Piece& part : local.pieces)
    {
      seed = std::lower_bound(seed, seeds.end(), part.whole,
        [](const WalkerSeed& s, std::int32_t node) { return s.node < node; });
      for (; seed != seeds.end() && seed->node < part.whole + part.count; ++seed)
        fixed.push_back(part.local + seed->node - part.whole);
    }
    std::sort(fixed.begin(), fixed.end());
    fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());

    std::vector<NodeValues> x;
    for (std::size_t b = 0; b * LaneCount < systems.lanes.size(); ++b)
    {
      x.emplace_back(local.graph->Nodes());
      for (const walk::LocalGraph::Piece& part : local.pieces)
        for (std::int32_t n = 0; n < part.count; ++n)
          x[b].data()[part.local + n] = systems.Known(b, labels[part.whole + n]);
    }
    const walk::SharpRun run = walk::Sharpen(local.graph, fixed, x, settings, progress);
    for (const walk::LocalGraph::Piece& part : local.pieces)
      for (std::int32_t n = 0; n < part.count; ++n)
        labels[part.whole + n] = systems.Best(x, part.local + n);
    result.iterations = run.cycles;
    result.work = run.cycles * double(local.graph->Nodes()) / double(graph->Nodes());
    result.error = run.error;
    result.converged = run.converged;
    return result;
  }
};

SharpWalker::SharpWalker(
  std::shared_ptr<const VoxelGraph> graph, const ProgressFunction& progress, std::size_t mostBytes)
  : internals(std::make_unique<const Internals>(std::move(graph), progress, mostBytes))
{
}

SharpWalker::~SharpWalker() = default;

SharpWalker::Shares SharpWalker::Solve(std::vector<WalkerSeed> given, double norm,
  const RandomWalkerSettings& settings, const ProgressFunction& progress) const
{
  CheckNorm(norm);
  walk::CheckSettings(settings);
  const Internals& in = *internals;
  const std::vector<WalkerSeed> seeds = walk::OrderSeeds(*in.graph, std::move(given));
  const std::vector<Label> names = walk::LabelsOf(seeds);
  walk::CheckBytes(*in.graph, names.size(), in.mostBytes);
  Shares shares;
  shares.labels.resize(in.of.size());
  if (names.empty())
    return shares;
  const walk::Systems systems = SystemsOf(names);
  const walk::SharpSettings sharp{ norm, settings.tolerance, settings.mostIterations };

  const CoarseSeeds coarseSeeds = SeedsOf(in.of, in.coarse.Nodes(), seeds);
  walk::SharpRun coarseRun;
  const std::vector<Label> coarse = in.SolveCoarse(
    coarseSeeds, in.PieceLabels(seeds), systems, sharp, PartOf(progress, 0.0, 0.4), coarseRun);
  ForNodes(in.graph->Nodes(), [&](std::int64_t n) { shares.labels[n] = coarse[in.of[n]]; });
  for (const WalkerSeed& seed : seeds)
    shares.labels[seed.node] = seed.label;
  shares.run = in.SolveFine(seeds, in.NearBorders(coarse, coarseSeeds), systems, sharp,
    PartOf(progress, 0.4, 1.0), shares.labels);
  shares.run.coarseIterations = coarseRun.cycles;
  shares.run.error = std::max<double>(shares.run.error, coarseRun.error);
  shares.run.converged = shares.run.converged && coarseRun.converged;
  ReportProgress(progress, 1.0);
  return shares;
}

std::size_t SharpWalker::Bytes() const
{
  const Internals& in = *internals;
  return (in.of.capacity() + in.piece.capacity()) * sizeof(std::int32_t) + in.coarse.Bytes();
}

} // namespace hasp
