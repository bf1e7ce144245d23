#include "Segmentation/SharpLevels.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"
#include "Segmentation/ConjugateGradients.h"
#include "Segmentation/Multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp::walk
{

namespace
{

/// By which factor a link counts less, of the labels' difference along it.
class LinkFactor
{
public:
  LinkFactor(const std::vector<NodeValues>& x, double norm)
    : batches(x),
      exponent(static_cast<float>(2.0 - norm))
  {
  }
  float operator()(std::int64_t a, std::int64_t b) const
  {
    float largest = 0.0F;
    float rest = 0.0F; // of the label without a system: all probabilities add up to 1
    for (const NodeValues& batch : batches)
    {
      const Lanes step = batch.data()[a] - batch.data()[b];
      rest += step[0] + step[1] + step[2] + step[3];
      const Lanes size = Abs(step);
      largest = std::max(largest, std::max(std::max(size[0], size[1]), std::max(size[2], size[3])));
    }
    largest = std::max(largest, std::abs(rest));
    const float factor = SharpEnd / (largest + SharpEnd);
    return exponent == 1.0F ? factor : std::pow(factor, exponent);
  }

private:
  const std::vector<NodeValues>& batches;
  float exponent;
};

/// One solve of all batches. residual(x, r) fills r.
template <typename System, typename Residual>
void SolveRound(System& system, const Residual& residual, std::vector<NodeValues>& batches,
  const SharpSettings& settings, const ProgressFunction& progress, SharpRun& run)
{
  int cycles = 0;
  run.error = 0.0F;
  for (std::size_t b = 0; b < batches.size(); ++b)
  {
    NodeValues r(batches[b].Nodes());
    residual(batches[b], r);
    const SolverRun one =
      ConjugateGradients(system, batches[b], r, NodeValues(), settings.tolerance, settings.most,
        PartOf(progress, b / double(batches.size()), (b + 1) / double(batches.size())));
    cycles = std::max(cycles, one.cycles);
    run.error = std::max(run.error, one.error);
    run.converged = run.converged && one.converged;
  }
  run.cycles += cycles;
}

/// round(progress) for the walk and each round that sharpens it.
template <typename Round>
void ForRounds(double norm, const ProgressFunction& progress, const Round& round)
{
  const int rounds = norm < 2.0 ? SharpRounds : 0;
  for (int r = 0; r <= rounds; ++r)
    round(r, PartOf(progress, r / double(rounds + 1), (r + 1) / double(rounds + 1)));
}

CoarseGraph Reweigh(const CoarseGraph& graph, const LinkFactor& factor)
{
  CoarseGraph result = graph;
  ParallelFor(0, graph.Nodes(), nodesAPass,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t a = first; a < last; ++a)
        for (std::int64_t l = graph.firstLink[a]; l < graph.firstLink[a + 1]; ++l)
          result.weight[l] *= factor(a, graph.to[l]);
    });
  return result;
}

void Fix(CoarseLevels& levels, const CoarseGraph& graph, const std::vector<std::uint8_t>& fixed)
{
  std::vector<CoarseLevels::FixedLink> links;
  std::vector<std::int32_t> free(fixed.size(), 1);
  for (std::int32_t a = 0; a < graph.Nodes(); ++a)
  {
    if (fixed[a] == 0)
      continue;
    free[a] = 0;
    for (std::int64_t l = graph.firstLink[a]; l < graph.firstLink[a + 1]; ++l)
    {
      const std::int32_t b = graph.to[l];
      if (fixed[b] == 0 || a < b) // a link of two fixed nodes is met twice, and counts once
        links.push_back({ a, b, graph.weight[l], fixed[b] != 0 });
    }
  }
  levels.Fix(std::move(links), free);
}

void Residual(const CoarseGraph& graph, const std::vector<std::uint8_t>& fixed, const NodeValues& x,
  NodeValues& residual)
{
  ParallelFor(0, graph.Nodes(), nodesAPass,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t a = first; a < last; ++a)
      {
        WideLanes sum{};
        if (fixed[a] == 0)
          for (std::int64_t l = graph.firstLink[a]; l < graph.firstLink[a + 1]; ++l)
            sum +=
              static_cast<double>(graph.weight[l]) * Widen(x.data()[graph.to[l]] - x.data()[a]);
        residual.data()[a] = Narrow(sum);
      }
    });
}

std::shared_ptr<const VoxelGraph> Reweigh(const VoxelGraph& graph, const LinkFactor& factor)
{
  std::array<std::vector<float>, 3> weights;
  for (std::vector<float>& axis : weights)
    axis.resize(static_cast<std::size_t>(graph.Nodes()) + 2);
  const auto spans = static_cast<std::int64_t>(graph.Spans().size());
  ParallelFor(0, spans, nodesAPass,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t s = first; s < last; ++s)
      {
        const VoxelGraph::Span& span = graph.Spans()[s];
        for (std::int32_t n = span.first; n < span.first + span.count; ++n)
        {
          if (n + 1 < span.first + span.count || span.joined != 0)
            weights[0][n + 1] = graph.Along(0)[n] * factor(n, n + 1);
          for (int axis = 1; axis < 3; ++axis)
            if (const std::int32_t on = span.above[axis - 1]; on != 0)
              weights[axis][n + 1] = graph.Along(axis)[n] * factor(n, n + on);
        }
      }
    });
  return std::make_shared<const VoxelGraph>(graph, std::move(weights));
}

} // namespace

SharpRun Sharpen(const CoarseGraph& graph, const std::vector<std::uint8_t>& fixed,
  std::vector<NodeValues>& batches, const SharpSettings& settings, const ProgressFunction& progress)
{
  SharpRun run;
  ForRounds(settings.norm, progress,
    [&](int round, const ProgressFunction& part)
    {
      const CoarseGraph now =
        round == 0 ? graph : Reweigh(graph, LinkFactor(batches, settings.norm));
      CoarseLevels levels(now);
      Fix(levels, now, fixed);
      SolveRound(
        levels, [&](const NodeValues& x, NodeValues& r) { Residual(now, fixed, x, r); }, batches,
        settings, part, run);
    });
  return run;
}

SharpRun Sharpen(std::shared_ptr<const VoxelGraph> graph, const std::vector<std::int32_t>& fixed,
  std::vector<NodeValues>& batches, const SharpSettings& settings, const ProgressFunction& progress)
{
  SharpRun run;
  ForRounds(settings.norm, progress,
    [&](int round, const ProgressFunction& part)
    {
      Multigrid system(
        round == 0 ? graph : Reweigh(*graph, LinkFactor(batches, settings.norm)), {});
      system.Fix(fixed);
      SolveRound(
        system, [&](const NodeValues& x, NodeValues& r) { system.Residual(x, r); }, batches,
        settings, part, run);
    });
  return run;
}

} // namespace hasp::walk
