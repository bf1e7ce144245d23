#include "Segmentation/RandomWalker.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Segmentation/ConjugateGradients.h"
#include "Segmentation/LocalGraph.h"
#include "Segmentation/Multigrid.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

namespace hasp
{

using walk::LaneCount;
using walk::NodeValues;

namespace
{

constexpr std::int32_t noLabel = -1; ///< no seed in this piece of the graph
constexpr std::int32_t severalLabels = -2;
/// Of the coarse start: what its constants are off by themselves is more.
constexpr double coarseTolerance = 2e-2;
constexpr double mostLocal = 0.1; ///< of all voxels: above, a part is not worth being cut out

/// Pieces of the graph, by span.
std::vector<std::int32_t> FindPieces(const VoxelGraph& graph, std::int32_t& pieces)
{
  const std::vector<VoxelGraph::Span>& spans = graph.Spans();
  std::vector<std::int32_t> parent(spans.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t s)
  {
    while (parent[s] != s)
      s = parent[s] = parent[parent[s]];
    return s;
  };
  const auto join = [&](std::int32_t a, std::int32_t b)
  {
    a = root(a);
    b = root(b);
    parent[std::max(a, b)] = std::min(a, b);
  };
  // Where the span of a neighbour is looked for: rows are met in order, so the place only moves on.
  std::size_t at[2] = { 0, 0 };
  for (std::size_t s = 0; s < spans.size(); ++s)
  {
    if (spans[s].joined != 0)
      join(static_cast<std::int32_t>(s), static_cast<std::int32_t>(s + 1));
    for (int axis = 0; axis < 2; ++axis)
      if (spans[s].above[axis] != 0)
      {
        const std::int32_t other = spans[s].first + spans[s].above[axis];
        while (spans[at[axis]].first + spans[at[axis]].count <= other)
          ++at[axis];
        join(static_cast<std::int32_t>(s), static_cast<std::int32_t>(at[axis]));
      }
  }
  pieces = 0;
  std::vector<std::int32_t> piece(spans.size());
  for (std::size_t s = 0; s < spans.size(); ++s)
  {
    const std::int32_t r = root(static_cast<std::int32_t>(s));
    piece[s] = r == static_cast<std::int32_t>(s) ? pieces++ : piece[r];
  }
  return piece;
}

} // namespace

namespace
{

/// Hands `most` back. Throws std::invalid_argument if a solve takes more.
std::size_t CheckBytes(const VoxelGraph& graph, std::size_t labels, std::size_t most)
{
  constexpr std::size_t ofSolver = 160; ///< a voxel, while it solves
  const std::size_t batches = labels < 2 ? 0 : (labels - 1 + LaneCount - 1) / LaneCount;
  const auto voxels = static_cast<std::size_t>(graph.Nodes());
  const std::size_t bytes = voxels * (ofSolver + batches * sizeof(walk::Lanes));
  if (bytes > most)
    throw std::invalid_argument(
      "sharing " + std::to_string(voxels) + " voxels out among " + std::to_string(labels) +
      " labels takes " + std::to_string(bytes >> 20) + " MiB, may take " +
      std::to_string(most >> 20) + "; use fewer labels, or split in parts");
  return most;
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

} // namespace

struct RandomWalker::Internals
{
  std::shared_ptr<const VoxelGraph> graph;
  std::size_t mostBytes;
  walk::Multigrid multigrid;
  std::vector<std::int32_t> pieceOfSpan;
  std::vector<std::int32_t> pieceLabel; ///< the label of all its seeds, noLabel or severalLabels
  std::vector<WalkerSeed> seeds;        ///< ascending nodes
  Label rest = 0;                       ///< the label without a system of its own
  std::vector<Label> laneLabels;        ///< of the systems; 0: free
  std::vector<NodeValues> batches;      ///< probabilities, four labels each

  Internals(std::shared_ptr<const VoxelGraph> g, const ProgressFunction& progress, std::size_t most)
    : graph(std::move(g)),
      mostBytes(CheckBytes(*graph, 2, most)),
      multigrid(graph, progress)
  {
    std::int32_t pieces = 0;
    pieceOfSpan = FindPieces(*graph, pieces);
    pieceLabel.assign(static_cast<std::size_t>(pieces), noLabel);
  }

  std::size_t SpanOf(std::int32_t node) const
  {
    const auto after = std::upper_bound(graph->Spans().begin(), graph->Spans().end(), node,
      [](std::int32_t n, const VoxelGraph::Span& span) { return n < span.first; });
    return static_cast<std::size_t>(after - graph->Spans().begin()) - 1;
  }

  /// A system for each label but one; labels that had one keep it. labels: of the seeds.
  void AssignLanes(const std::vector<Label>& labels)
  {
    const auto used = [&](Label l) { return std::binary_search(labels.begin(), labels.end(), l); };
    if (!used(rest)) // all probabilities that were implied are lost
      ForgetLanes();
    const Label first = labels.empty() ? Label{ 0 } : labels.front();
    const Label without = rest == 0 ? first : rest;
    std::vector<Label> lanes = laneLabels;
    for (Label& lane : lanes)
      if (!used(lane))
        lane = 0;
    for (const Label label : labels)
      if (label != without && std::find(lanes.begin(), lanes.end(), label) == lanes.end())
      {
        const auto free = std::find(lanes.begin(), lanes.end(), Label{ 0 });
        if (free != lanes.end())
          *free = label;
        else
          lanes.push_back(label);
      }
    // What memory is needed is taken before anything says that it is there.
    const std::size_t needed = (lanes.size() + LaneCount - 1) / LaneCount;
    while (batches.size() < needed)
      batches.emplace_back(graph->Nodes());
    for (std::size_t lane = 0; lane < laneLabels.size(); ++lane)
      if (laneLabels[lane] != 0 && laneLabels[lane] != lanes[lane])
        FillLane(lane, 0.0F);
    laneLabels = std::move(lanes);
    rest = without;
  }

  void ForgetLanes()
  {
    rest = 0;
    laneLabels.clear();
    batches.clear();
  }

  void FillLane(std::size_t lane, float value)
  {
    NodeValues& batch = batches[lane / LaneCount];
    for (std::int64_t n = 0; n < graph->Nodes(); ++n)
      batch.data()[n][lane % LaneCount] = value;
  }

  /// 1 in the system of the label, 0 in all others.
  walk::Lanes Known(std::size_t batch, std::int32_t label) const
  {
    walk::Lanes value{};
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const std::size_t at = batch * LaneCount + static_cast<std::size_t>(lane);
      if (at < laneLabels.size() && laneLabels[at] != 0 && laneLabels[at] == label)
        value[lane] = 1.0F;
    }
    return value;
  }

  void FindPieceLabels()
  {
    std::fill(pieceLabel.begin(), pieceLabel.end(), noLabel);
    for (const WalkerSeed& seed : seeds)
    {
      std::int32_t& label = pieceLabel[pieceOfSpan[SpanOf(seed.node)]];
      label = label == noLabel || label == seed.label ? seed.label : severalLabels;
    }
  }

  /// What is known without solving.
  void SetKnown()
  {
    for (std::size_t b = 0; b < batches.size(); ++b)
    {
      walk::Lanes* x = batches[b].data();
      ParallelFor(0, static_cast<std::int64_t>(pieceOfSpan.size()), 4096,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t s = first; s < last; ++s)
          {
            const std::int32_t label = pieceLabel[pieceOfSpan[s]];
            const VoxelGraph::Span& span = graph->Spans()[s];
            if (label != severalLabels)
              std::fill_n(x + span.first, span.count, Known(b, label));
          }
        });
      for (const WalkerSeed& seed : seeds)
        x[seed.node] = Known(b, seed.label);
    }
  }

  /// Solves on where cells are marked; elsewhere x is as it is to be, and holds. An error there is
  /// no larger than at the rim, but for what is left to solve: harmonic functions have no peaks.
  walk::SolverRun SolveLocally(const walk::MarkedCells& cells, NodeValues& x, double tolerance,
    int most, const ProgressFunction& progress) const
  {
    const walk::LocalGraph local(*graph, cells);
    walk::Multigrid system(local.graph, {});
    std::vector<std::int32_t> fixed = local.rim;
    for (const walk::LocalGraph::Piece& piece : local.pieces)
      for (std::int32_t n = 0; n < piece.count; ++n)
        if (!multigrid.Free(piece.whole + n))
          fixed.push_back(piece.local + n);
    std::sort(fixed.begin(), fixed.end());
    fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
    system.Fix(fixed);
    NodeValues part = local.Take(x);
    NodeValues residual(part.Nodes());
    system.Residual(part, residual);
    const walk::SolverRun run =
      walk::ConjugateGradients(system, part, residual, NodeValues(), tolerance, most, progress);
    local.Put(part, x);
    return run;
  }

  /// The most likely label of a node whose piece has several.
  Label Best(std::int64_t node) const
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
    for (std::size_t lane = 0; lane < laneLabels.size(); ++lane)
      if (laneLabels[lane] != 0)
      {
        const float probability =
          batches[lane / LaneCount].data()[node][static_cast<int>(lane % LaneCount)];
        sum += probability;
        take(laneLabels[lane], probability);
      }
    take(rest, 1.0F - sum);
    return best;
  }
};

RandomWalker::RandomWalker(
  std::shared_ptr<const VoxelGraph> graph, const ProgressFunction& progress, std::size_t mostBytes)
  : internals(std::make_unique<Internals>(std::move(graph), progress, mostBytes))
{
}

RandomWalker::~RandomWalker() = default;

void RandomWalker::SetSeeds(std::vector<WalkerSeed> seeds)
{
  Internals& in = *internals;
  for (const WalkerSeed& seed : seeds)
    if (seed.node < 0 || seed.node >= in.graph->Nodes() || seed.label == 0)
      throw std::invalid_argument(
        "a seed is at node " + std::to_string(seed.node) + " with label " +
        std::to_string(seed.label) + ", must be at a node in [0, " +
        std::to_string(in.graph->Nodes()) + ") with a label in [1, 65535]");
  std::stable_sort(seeds.begin(), seeds.end(),
    [](const WalkerSeed& a, const WalkerSeed& b) { return a.node < b.node; });
  std::vector<WalkerSeed> each;
  for (const WalkerSeed& seed : seeds)
    if (!each.empty() && each.back().node == seed.node)
      each.back() = seed;
    else
      each.push_back(seed);
  const std::vector<Label> labels = LabelsOf(each);
  // A lane that is free stays: at most one batch more than there are labels now for.
  CheckBytes(*in.graph, std::max(labels.size(), in.laneLabels.size() + 1), in.mostBytes);
  in.AssignLanes(labels);
  in.seeds = std::move(each);
  in.FindPieceLabels();
  std::vector<std::int32_t> fixed;
  fixed.reserve(in.seeds.size());
  for (const WalkerSeed& seed : in.seeds)
    fixed.push_back(seed.node);
  in.multigrid.Fix(fixed);
}

RandomWalkerRun RandomWalker::Solve(
  const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  if (!(settings.tolerance > 0.0 && settings.tolerance <= 0.1))
    throw std::invalid_argument(
      "tolerance is " + std::to_string(settings.tolerance) + ", must be in (0, 0.1]");
  if (settings.mostIterations < 1 || settings.mostIterations > 100000)
    throw std::invalid_argument(
      "mostIterations is " + std::to_string(settings.mostIterations) + ", must be in [1, 100000]");
  Internals& in = *internals;
  in.SetKnown();
  RandomWalkerRun all;
  NodeValues residual(in.batches.empty() ? 0 : in.graph->Nodes());
  for (std::size_t b = 0; b < in.batches.size(); ++b)
  {
    NodeValues& x = in.batches[b];
    in.multigrid.Residual(x, residual);
    NodeValues start;
    if (settings.coarseStart)
    {
      start = NodeValues(in.graph->Nodes());
      all.coarseIterations = std::max(all.coarseIterations,
        in.multigrid.SolveCoarse(residual, start, std::max(settings.tolerance, coarseTolerance)));
    }
    double shown = 0.0; // of this batch: errors may grow again, and the local end begins anew
    const auto report = [&](double share)
    {
      shown = std::max(shown, share);
      return !progress || progress((b + shown) / static_cast<double>(in.batches.size()));
    };
    std::optional<walk::MarkedCells> cells;
    walk::SolverRun run = walk::ConjugateGradients(in.multigrid, x, residual, std::move(start),
      settings.tolerance, settings.mostIterations, report,
      [&](const NodeValues& z)
      {
        if (!settings.localEnd)
          return false;
        cells.emplace(*in.graph, z, static_cast<float>(settings.tolerance) * walk::SeenShare);
        return static_cast<double>(cells->Nodes()) <=
               mostLocal * static_cast<double>(in.graph->Nodes());
      });
    double work = run.cycles;
    if (run.left)
    {
      const int before = run.cycles;
      run = in.SolveLocally(*cells, x, settings.tolerance, settings.mostIterations - before,
        PartOf(report, shown, 1.0));
      work +=
        run.cycles * static_cast<double>(cells->Nodes()) / static_cast<double>(in.graph->Nodes());
      run.error = std::max(run.error, cells->LargestOutside() / walk::SeenShare);
      run.cycles += before;
    }
    all.iterations = std::max(all.iterations, run.cycles);
    all.work = std::max(all.work, work);
    all.error = std::max<double>(all.error, run.error);
    all.converged = all.converged && run.converged;
  }
  ReportProgress(progress, 1.0);
  return all;
}

void RandomWalker::Reset()
{
  // Which label has which system must not depend on what was before, either.
  internals->ForgetLanes();
  internals->AssignLanes(LabelsOf(internals->seeds));
}

void RandomWalker::WriteLabels(GridView<Label> labels, Label unreached) const
{
  const Internals& in = *internals;
  if (labels.geometry.dims != in.graph->Geometry().dims)
    throw std::invalid_argument("the label map must be as large as the scan");
  const std::vector<VoxelGraph::Run>& runs = in.graph->Runs();
  const std::vector<VoxelGraph::Span>& spans = in.graph->Spans();
  const std::int64_t rows = static_cast<std::int64_t>(in.graph->RowRuns().size()) - 1;
  ParallelFor(0, rows, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        for (std::int32_t r = in.graph->RowRuns()[row]; r < in.graph->RowRuns()[row + 1]; ++r)
        {
          Label* voxel = labels.data + row * labels.geometry.dims.x + runs[r].x - runs[r].first;
          const std::int32_t end = runs[r].first + runs[r].count;
          for (std::size_t s = in.SpanOf(runs[r].first); s < spans.size() && spans[s].first < end;
               ++s)
          {
            const std::int32_t seeded = in.pieceLabel[in.pieceOfSpan[s]];
            const std::int32_t label = seeded == noLabel ? unreached : seeded;
            if (label == 0)
              continue;
            for (std::int32_t n = spans[s].first; n < spans[s].first + spans[s].count; ++n)
              voxel[n] = label == severalLabels ? in.Best(n) : static_cast<Label>(label);
          }
        }
    });
}

double RandomWalker::Probability(std::int32_t node, Label label) const
{
  const Internals& in = *internals;
  if (node < 0 || node >= in.graph->Nodes())
    throw std::invalid_argument("node " + std::to_string(node) + " is not of the graph");
  const std::int32_t known = in.pieceLabel[in.pieceOfSpan[in.SpanOf(node)]];
  if (known != severalLabels)
    return known == label ? 1.0 : 0.0;
  double sum = 0.0;
  for (std::size_t lane = 0; lane < in.laneLabels.size(); ++lane)
  {
    const double probability =
      in.batches[lane / LaneCount].data()[node][static_cast<int>(lane % LaneCount)];
    if (in.laneLabels[lane] == label && label != 0)
      return probability;
    sum += probability;
  }
  return label == in.rest ? 1.0 - sum : 0.0;
}

const VoxelGraph& RandomWalker::Graph() const
{
  return *internals->graph;
}

std::size_t RandomWalker::Bytes() const
{
  std::size_t bytes = internals->multigrid.Bytes() +
                      internals->seeds.capacity() * sizeof(WalkerSeed) +
                      internals->pieceOfSpan.capacity() * sizeof(std::int32_t);
  for (const NodeValues& batch : internals->batches)
    bytes += batch.Bytes();
  return bytes;
}

} // namespace hasp
