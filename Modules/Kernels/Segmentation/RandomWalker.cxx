#include "Segmentation/RandomWalker.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Segmentation/ConjugateGradients.h"
#include "Segmentation/LocalGraph.h"
#include "Segmentation/Multigrid.h"
#include "Segmentation/WalkerSystems.h"

#include <algorithm>
#include <numeric>
#include <optional>
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

/// Of the coarse start: what its constants are off by themselves is more.
constexpr double coarseTolerance = 2e-2;
constexpr double mostLocal = 0.1; ///< of all voxels: above, a part is not worth being cut out

/// Hands `most` back. Throws std::invalid_argument if a solve takes more.
std::size_t CheckedBytes(const VoxelGraph& graph, std::size_t labels, std::size_t most)
{
  constexpr std::size_t ofSolver = 240; ///< a voxel, while it solves, with seeds everywhere
  const auto voxels = static_cast<std::size_t>(graph.Nodes());
  walk::CheckBytes(
    voxels * (ofSolver + walk::BatchesOf(labels) * sizeof(walk::Lanes)), graph, labels, most);
  return most;
}

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

struct RandomWalker::Internals
{
  std::shared_ptr<const VoxelGraph> graph;
  std::size_t mostBytes;
  walk::Multigrid multigrid;
  std::vector<std::int32_t> pieceOfSpan;
  std::vector<std::int32_t> pieceLabel; ///< the label of all its seeds, noLabel or severalLabels
  std::vector<WalkerSeed> seeds;        ///< ascending nodes
  walk::Systems systems;
  std::vector<NodeValues> batches; ///< probabilities, four labels each

  Internals(std::shared_ptr<const VoxelGraph> g, const ProgressFunction& progress, std::size_t most)
    : graph(std::move(g)),
      mostBytes(CheckedBytes(*graph, 2, most)),
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
    if (!used(systems.rest)) // all probabilities that were implied are lost
      ForgetLanes();
    const Label first = labels.empty() ? Label{ 0 } : labels.front();
    const Label without = systems.rest == 0 ? first : systems.rest;
    std::vector<Label> lanes = systems.lanes;
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
    for (std::size_t lane = 0; lane < systems.lanes.size(); ++lane)
      if (systems.lanes[lane] != 0 && systems.lanes[lane] != lanes[lane])
        FillLane(lane, 0.0F);
    systems.lanes = std::move(lanes);
    systems.rest = without;
  }

  void ForgetLanes()
  {
    systems.rest = 0;
    systems.lanes.clear();
    batches.clear();
  }

  void FillLane(std::size_t lane, float value)
  {
    NodeValues& batch = batches[lane / LaneCount];
    for (std::int64_t n = 0; n < graph->Nodes(); ++n)
      batch.data()[n][lane % LaneCount] = value;
  }

  void FindPieceLabels()
  {
    std::fill(pieceLabel.begin(), pieceLabel.end(), noLabel);
    for (const WalkerSeed& seed : seeds)
    {
      std::int32_t& label = pieceLabel[pieceOfSpan[SpanOf(seed.node)]];
      label = walk::WithSeed(label, seed.label);
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
              std::fill_n(x + span.first, span.count, systems.Known(b, label));
          }
        });
      for (const WalkerSeed& seed : seeds)
        x[seed.node] = systems.Known(b, seed.label);
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
  std::vector<WalkerSeed> each = walk::OrderSeeds(*in.graph, std::move(seeds));
  const std::vector<Label> labels = walk::LabelsOf(each);
  // A lane that is free stays: at most one batch more than there are labels now for.
  CheckedBytes(*in.graph, std::max(labels.size(), in.systems.lanes.size() + 1), in.mostBytes);
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
  walk::CheckSettings(settings);
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
  internals->AssignLanes(walk::LabelsOf(internals->seeds));
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
              voxel[n] =
                label == severalLabels ? in.systems.Best(in.batches, n) : static_cast<Label>(label);
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
  for (std::size_t lane = 0; lane < in.systems.lanes.size(); ++lane)
  {
    const double probability =
      in.batches[lane / LaneCount].data()[node][static_cast<int>(lane % LaneCount)];
    if (in.systems.lanes[lane] == label && label != 0)
      return probability;
    sum += probability;
  }
  return label == in.systems.rest ? 1.0 - sum : 0.0;
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
