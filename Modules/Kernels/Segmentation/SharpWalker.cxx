#include "Segmentation/SharpWalker.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Segmentation/LocalGraph.h"
#include "Segmentation/SharpLevels.h"
#include "Segmentation/WalkerSystems.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

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

/// Bytes of memory, but for seeds: of each voxel, each in a mixed aggregate, each near a border.
constexpr std::size_t ofVoxel = 80, ofMixed = 300, ofNear = 400;

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

/// Groups of voxels, each with one label at most among its seeds.
struct CoarseBone
{
  std::vector<std::int32_t> of;    ///< a voxel's group
  walk::CoarseGraph graph;         ///< of groups
  std::vector<std::int32_t> piece; ///< of the graph, that a group is in
  std::int32_t aggregates = 0;     ///< groups from here on are single voxels
};

/// Not 0: an aggregate with seeds of several labels.
std::vector<std::uint8_t> FindMixed(
  const std::vector<std::int32_t>& of, std::int32_t count, const std::vector<WalkerSeed>& seeds)
{
  std::vector<Label> first(static_cast<std::size_t>(count));
  std::vector<std::uint8_t> mixed(first.size());
  for (const WalkerSeed& seed : seeds)
  {
    const std::int32_t a = of[seed.node];
    mixed[a] |= first[a] != 0 && first[a] != seed.label;
    first[a] = seed.label;
  }
  return mixed;
}

struct CoarseLink
{
  std::int32_t from, to;
  float weight;
};

/// All links of voxels in mixed aggregates, both ways; in order, each once.
std::vector<CoarseLink> LinksOfMixed(const VoxelGraph& graph, const std::vector<std::int32_t>& of,
  const std::vector<std::int32_t>& single, const std::vector<std::uint8_t>& mixed)
{
  std::vector<CoarseLink> links;
  const auto add = [&](std::int32_t n, std::int32_t m, float weight)
  {
    if ((mixed[of[n]] == 0 && mixed[of[m]] == 0) || !(weight > 0.0F))
      return;
    links.push_back({ single[n], single[m], weight });
    links.push_back({ single[m], single[n], weight });
  };
  for (const VoxelGraph::Span& span : graph.Spans())
    for (std::int32_t n = span.first; n < span.first + span.count; ++n)
    {
      if (n + 1 < span.first + span.count || span.joined != 0)
        add(n, n + 1, graph.Along(0)[n]);
      for (int axis = 1; axis < 3; ++axis)
        if (const std::int32_t on = span.above[axis - 1]; on != 0)
          add(n, n + on, graph.Along(axis)[n]);
    }
  // Stable: sums come in the order of the voxels.
  std::stable_sort(links.begin(), links.end(),
    [](const CoarseLink& p, const CoarseLink& q)
    { return std::pair(p.from, p.to) < std::pair(q.from, q.to); });
  std::size_t count = 0;
  for (const CoarseLink& link : links)
    if (count > 0 && links[count - 1].from == link.from && links[count - 1].to == link.to)
      links[count - 1].weight += link.weight;
    else
      links[count++] = link;
  links.resize(count);
  return links;
}

/// Voxels of mixed aggregates become groups of their own, behind all others: an aggregate has one
/// label, and seeds of two would cut the one off from what lies behind it.
CoarseBone SplitMixed(
  const VoxelGraph& graph, const CoarseBone& bone, const std::vector<std::uint8_t>& mixed)
{
  CoarseBone result{ bone.of, {}, bone.piece, bone.aggregates };
  auto next = static_cast<std::int32_t>(mixed.size());
  for (std::int32_t& group : result.of)
    if (mixed[group] != 0)
    {
      result.piece.push_back(bone.piece[group]);
      group = next++;
    }
  const std::vector<CoarseLink> links = LinksOfMixed(graph, bone.of, result.of, mixed);
  result.graph.firstLink.push_back(0);
  auto more = links.begin();
  for (std::int32_t a = 0; a < next; ++a)
  {
    if (a < bone.aggregates && mixed[a] == 0)
      for (std::int64_t l = bone.graph.firstLink[a]; l < bone.graph.firstLink[a + 1]; ++l)
        if (mixed[bone.graph.to[l]] == 0)
        {
          result.graph.to.push_back(bone.graph.to[l]);
          result.graph.weight.push_back(bone.graph.weight[l]);
        }
    for (; more != links.end() && more->from == a; ++more) // to single voxels, which come last
    {
      result.graph.to.push_back(more->to);
      result.graph.weight.push_back(more->weight);
    }
    result.graph.firstLink.push_back(static_cast<std::int64_t>(result.graph.to.size()));
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
  CoarseBone bone;
  std::int32_t pieces = 0;

  Internals(std::shared_ptr<const VoxelGraph> g, const ProgressFunction& progress, std::size_t most)
    : graph(std::move(g)),
      mostBytes(most)
  {
    CheckBytes(2, {}, {});
    walk::Aggregates blocks = walk::AggregateVoxels(*graph);
    ReportProgress(progress, 0.3);
    bone.graph = walk::Coarsen(*graph, blocks);
    bone.of = std::move(blocks.of);
    ReportProgress(progress, 0.7);
    std::int32_t before = 0;
    do
    {
      before = bone.graph.Nodes();
      const walk::Aggregates up = walk::AggregateNodes(bone.graph);
      bone.graph = walk::Coarsen(bone.graph, up);
      ForNodes(graph->Nodes(), [&](std::int64_t n) { bone.of[n] = up.of[bone.of[n]]; });
    } while (bone.graph.Nodes() > manyAggregates && bone.graph.Nodes() < before / 2);
    bone.aggregates = bone.graph.Nodes();
    bone.piece = FindPieces(bone.graph, pieces);
    ReportProgress(progress, 1.0);
  }

  /// mixed: of aggregates; near: of voxels, four more labels each take more there. Throws
  /// std::invalid_argument.
  void CheckBytes(std::size_t labels, const std::vector<std::uint8_t>& mixed,
    const std::vector<std::uint8_t>& near) const
  {
    std::size_t mixedVoxels = 0;
    if (std::find(mixed.begin(), mixed.end(), 1) != mixed.end())
      mixedVoxels = static_cast<std::size_t>(std::count_if(
        bone.of.begin(), bone.of.end(), [&](std::int32_t a) { return mixed[a] != 0; }));
    const auto nearVoxels = static_cast<std::size_t>(std::count(near.begin(), near.end(), 1));
    const std::size_t bytes = static_cast<std::size_t>(graph->Nodes()) * ofVoxel +
                              mixedVoxels * ofMixed +
                              nearVoxels * (ofNear + walk::BatchesOf(labels) * sizeof(walk::Lanes));
    walk::CheckBytes(bytes, *graph, labels, mostBytes);
  }

  /// noLabel, severalLabels or the one label of a piece's seeds.
  std::vector<std::int32_t> PieceLabels(const std::vector<WalkerSeed>& seeds) const
  {
    std::vector<std::int32_t> labels(static_cast<std::size_t>(pieces), noLabel);
    for (const WalkerSeed& seed : seeds)
    {
      std::int32_t& label = labels[bone.piece[bone.of[seed.node]]];
      label = walk::WithSeed(label, seed.label);
    }
    return labels;
  }

  /// The label of each group.
  static std::vector<Label> SolveCoarse(const CoarseBone& groups,
    const std::vector<WalkerSeed>& seeds, const std::vector<std::int32_t>& pieceLabels,
    const walk::Systems& systems, const walk::SharpSettings& settings,
    const ProgressFunction& progress, walk::SharpRun& run)
  {
    const std::int32_t nodes = groups.graph.Nodes();
    std::vector<Label> labels(static_cast<std::size_t>(nodes));
    for (const WalkerSeed& seed : seeds)
      labels[groups.of[seed.node]] = seed.label;
    std::vector<std::uint8_t> fixed(labels.size());
    std::vector<NodeValues> x;
    for (std::size_t b = 0; b * LaneCount < systems.lanes.size(); ++b)
      x.emplace_back(nodes);
    for (std::int32_t a = 0; a < nodes; ++a)
    {
      const std::int32_t known = pieceLabels[groups.piece[a]];
      if (known > 0)
        labels[a] = static_cast<Label>(known);
      fixed[a] = known != severalLabels || labels[a] != 0;
      for (std::size_t b = 0; b < x.size() && labels[a] != 0; ++b)
        x[b].data()[a] = systems.Known(b, labels[a]);
    }
    if (std::find(fixed.begin(), fixed.end(), 0) == fixed.end())
      return labels;
    run = walk::Sharpen(groups.graph, fixed, x, settings, progress);
    for (std::int32_t a = 0; a < nodes; ++a)
      if (fixed[a] == 0)
        labels[a] = systems.Best(x, a);
    return labels;
  }

  /// Voxels whose group has a neighbour of another label, or is or has a single voxel.
  std::vector<std::uint8_t> NearBorders(
    const CoarseBone& groups, const std::vector<Label>& labels) const
  {
    const walk::CoarseGraph& links = groups.graph;
    std::vector<std::uint8_t> near(labels.size());
    ForNodes(links.Nodes(),
      [&](std::int64_t a)
      {
        bool border = a >= groups.aggregates;
        for (std::int64_t l = links.firstLink[a]; l < links.firstLink[a + 1] && !border; ++l)
          border = labels[links.to[l]] != labels[a] || links.to[l] >= groups.aggregates;
        near[a] = border;
      });
    std::vector<std::uint8_t> voxels(groups.of.size());
    ForNodes(graph->Nodes(), [&](std::int64_t n) { voxels[n] = near[groups.of[n]]; });
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
  Shares shares;
  shares.labels.resize(in.bone.of.size());
  if (names.empty())
    return shares;
  const walk::Systems systems = SystemsOf(names);
  const walk::SharpSettings sharp{ norm, settings.tolerance, settings.mostIterations };
  double shown = 0.0; // an error may rise for some cycles: progress stays where it was
  ProgressFunction forwards;
  if (progress)
    forwards = [&](double share) { return progress(shown = std::max(shown, share)); };

  const std::vector<std::uint8_t> mixed = FindMixed(in.bone.of, in.bone.aggregates, seeds);
  in.CheckBytes(names.size(), mixed, {});
  std::optional<CoarseBone> split;
  if (std::find(mixed.begin(), mixed.end(), 1) != mixed.end())
    split = SplitMixed(*in.graph, in.bone, mixed);
  const CoarseBone& groups = split ? *split : in.bone;
  walk::SharpRun coarseRun;
  const std::vector<Label> coarse = Internals::SolveCoarse(
    groups, seeds, in.PieceLabels(seeds), systems, sharp, PartOf(forwards, 0.0, 0.4), coarseRun);
  ForNodes(in.graph->Nodes(), [&](std::int64_t n) { shares.labels[n] = coarse[groups.of[n]]; });
  for (const WalkerSeed& seed : seeds)
    shares.labels[seed.node] = seed.label;
  const std::vector<std::uint8_t> near = in.NearBorders(groups, coarse);
  in.CheckBytes(names.size(), mixed, near);
  shares.run = in.SolveFine(seeds, near, systems, sharp, PartOf(forwards, 0.4, 1.0), shares.labels);
  shares.run.coarseIterations = coarseRun.cycles;
  shares.run.error = std::max<double>(shares.run.error, coarseRun.error);
  shares.run.converged = shares.run.converged && coarseRun.converged;
  ReportProgress(forwards, 1.0);
  return shares;
}

std::size_t SharpWalker::Bytes() const
{
  const Internals& in = *internals;
  return (in.bone.of.capacity() + in.bone.piece.capacity()) * sizeof(std::int32_t) +
         in.bone.graph.Bytes();
}

} // namespace hasp
