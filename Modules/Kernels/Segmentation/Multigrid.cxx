#include "Segmentation/Multigrid.h"

#include "Segmentation/ConjugateGradients.h"

#include <algorithm>

namespace hasp::walk
{

namespace
{

/// Blocks that are smoothed one beside the other: enough for many cores, and thick enough that few
/// links leave them. Their number must not depend on the machine.
constexpr std::int64_t blockCount = 64;
constexpr std::int64_t leastBlock = 4096; ///< nodes

/// What flows into node n, as sums of differences: exact where neighbours agree.
template <typename Value, typename Convert>
Value InFlow(const VoxelGraph::Span& span, const float* const* along, const Lanes* x,
  std::int64_t n, Convert convert)
{
  const Lanes here = x[n];
  Value sum = convert(along[0][n]) * convert(x[n + 1] - here) +
              convert(along[0][n - 1]) * convert(x[n - 1] - here);
  for (int axis = 1; axis < 3; ++axis)
  {
    const float* w = along[axis] + n;
    const std::int32_t on = span.above[axis - 1];
    const std::int32_t back = span.below[axis - 1];
    sum += convert(w[0]) * convert(x[n + on] - here);
    sum += convert(w[back]) * convert(x[n + back] - here);
  }
  return sum;
}

struct InSingle
{
  float operator()(float w) const { return w; }
  Lanes operator()(Lanes v) const { return v; }
};
struct InDouble
{
  double operator()(float w) const { return w; }
  WideLanes operator()(Lanes v) const { return Widen(v); }
};

struct Weights
{
  explicit Weights(const VoxelGraph& graph)
    : along{ graph.Along(0), graph.Along(1), graph.Along(2) }
  {
  }
  const float* along[3];
};

} // namespace

Multigrid::Multigrid(std::shared_ptr<const VoxelGraph> g, const ProgressFunction& progress)
  : graph(std::move(g)),
    aggregates(AggregateVoxels(*graph)),
    coarse(Coarsen(*graph, aggregates)),
    coarseResidual(aggregates.Count()),
    coarseCorrection(aggregates.Count()),
    scratch(graph->Nodes())
{
  inverse.resize(static_cast<std::size_t>(graph->Nodes()));
  const std::int64_t size = std::max(graph->Nodes() / blockCount, leastBlock);
  const std::vector<VoxelGraph::Span>& spans = graph->Spans();
  for (std::size_t s = 0; s < spans.size(); ++s)
    if (blocks.empty() ||
        (spans[s].first - blocks.back().firstNode >= size && spans[s - 1].joined == 0))
      blocks.push_back({ static_cast<std::int64_t>(s), 0, spans[s].first });
  for (std::size_t b = 0; b < blocks.size(); ++b)
    blocks[b].endSpan =
      b + 1 < blocks.size() ? blocks[b + 1].firstSpan : static_cast<std::int64_t>(spans.size());
  ReportProgress(progress, 1.0);
}

void Multigrid::Fix(const std::vector<std::int32_t>& nodes)
{
  std::vector<std::uint8_t> fixed(inverse.size());
  for (const std::int32_t n : nodes)
    fixed[n] = 1;
  const Weights weights(*graph);
  std::vector<CoarseLevels::FixedLink> links;
  const auto add = [&](std::int32_t n, std::int32_t to, float weight)
  {
    // A link of two fixed nodes is met twice, and counts once; within an aggregate it is in no sum.
    const bool bothFixed = fixed[to] != 0;
    if (weight > 0.0F && (!bothFixed || (n < to && aggregates.of[n] != aggregates.of[to])))
      links.push_back({ aggregates.of[n], aggregates.of[to], weight, bothFixed });
  };
  for (const Block& block : blocks)
    for (std::int64_t s = block.firstSpan; s < block.endSpan; ++s)
    {
      const VoxelGraph::Span& span = graph->Spans()[s];
      for (std::int32_t n = span.first; n < span.first + span.count; ++n)
      {
        float sum = weights.along[0][n] + weights.along[0][n - 1];
        for (int axis = 1; axis < 3; ++axis)
        {
          sum += span.above[axis - 1] != 0 ? weights.along[axis][n] : 0.0F;
          sum += span.below[axis - 1] != 0 ? weights.along[axis][n + span.below[axis - 1]] : 0.0F;
        }
        inverse[n] = fixed[n] == 0 && sum > 0.0F ? 1.0F / sum : 0.0F;
        if (fixed[n] == 0)
          continue;
        add(n, n + 1, weights.along[0][n]);
        add(n, n - 1, weights.along[0][n - 1]);
        for (int axis = 1; axis < 3; ++axis)
        {
          if (const std::int32_t on = span.above[axis - 1]; on != 0)
            add(n, n + on, weights.along[axis][n]);
          if (const std::int32_t back = span.below[axis - 1]; back != 0)
            add(n, n + back, weights.along[axis][n + back]);
        }
      }
    }
  std::vector<std::int32_t> free(static_cast<std::size_t>(aggregates.Count()));
  for (std::size_t n = 0; n < inverse.size(); ++n)
    free[aggregates.of[n]] += inverse[n] > 0.0F ? 1 : 0;
  coarse.Fix(std::move(links), free);
}

void Multigrid::Residual(const NodeValues& x, NodeValues& residual) const
{
  const Weights weights(*graph);
  ParallelFor(0, static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t b, std::int64_t)
    {
      for (std::int64_t s = blocks[b].firstSpan; s < blocks[b].endSpan; ++s)
      {
        const VoxelGraph::Span& span = graph->Spans()[s];
        for (std::int64_t n = span.first; n < span.first + span.count; ++n)
          residual.data()[n] =
            Free(n) ? Narrow(InFlow<WideLanes>(span, weights.along, x.data(), n, InDouble{}))
                    : Lanes{};
      }
    });
}

WideLanes Multigrid::Multiply(const NodeValues& x, NodeValues& product) const
{
  const Weights weights(*graph);
  return SumOverChunks(static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t b, std::int64_t)
    {
      WideLanes dot{};
      for (std::int64_t s = blocks[b].firstSpan; s < blocks[b].endSpan; ++s)
      {
        const VoxelGraph::Span& span = graph->Spans()[s];
        Lanes part{};
        for (std::int64_t n = span.first; n < span.first + span.count; ++n)
        {
          const Lanes flow = InFlow<Lanes>(span, weights.along, x.data(), n, InSingle{});
          product.data()[n] = Free(n) ? -flow : Lanes{};
          part += x.data()[n] * product.data()[n];
        }
        dot += Widen(part);
      }
      return dot;
    });
}

void Multigrid::SmoothForwards(const NodeValues& r, NodeValues& z) const
{
  const Weights weights(*graph);
  ParallelFor(0, static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t b, std::int64_t)
    {
      const Block& block = blocks[b];
      Lanes* out = z.data();
      for (std::int64_t s = block.firstSpan; s < block.endSpan; ++s)
      {
        const VoxelGraph::Span& span = graph->Spans()[s];
        std::int32_t back[2];
        for (int axis = 0; axis < 2; ++axis) // what lies in another block is not asked
          back[axis] = span.first + span.below[axis] >= block.firstNode ? span.below[axis] : 0;
        Lanes last = span.first > block.firstNode ? out[span.first - 1] : Lanes{};
        for (std::int32_t n = span.first; n < span.first + span.count; ++n)
        {
          Lanes sum = r.data()[n] + weights.along[0][n - 1] * last;
          for (int axis = 0; axis < 2; ++axis)
            if (back[axis] != 0)
              sum += weights.along[axis + 1][n + back[axis]] * out[n + back[axis]];
          out[n] = last = inverse[n] * sum;
        }
      }
    });
}

void Multigrid::SmoothBackwards(const NodeValues& r, const NodeValues& before, NodeValues& z) const
{
  const Weights weights(*graph);
  ParallelFor(0, static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t b, std::int64_t)
    {
      const Block& block = blocks[b];
      const std::int64_t end =
        static_cast<std::size_t>(b) + 1 < blocks.size() ? blocks[b + 1].firstNode : graph->Nodes();
      const Lanes* old = before.data();
      Lanes* out = z.data();
      for (std::int64_t s = block.endSpan; s-- > block.firstSpan;)
      {
        const VoxelGraph::Span& span = graph->Spans()[s];
        const Lanes* beyond[2]; // what is new already, but not what lies in another block
        for (int axis = 0; axis < 2; ++axis)
          beyond[axis] = (span.first + span.above[axis] < end ? out : old) + span.above[axis];
        const std::int32_t next = span.first + span.count;
        Lanes last = (next < end ? out : old)[next];
        for (std::int32_t n = next - 1; n >= span.first; --n)
        {
          Lanes sum = r.data()[n] + weights.along[0][n - 1] * old[n - 1];
          for (int axis = 0; axis < 2; ++axis)
          {
            if (span.below[axis] != 0)
              sum += weights.along[axis + 1][n + span.below[axis]] * old[n + span.below[axis]];
            if (span.above[axis] != 0)
              sum += weights.along[axis + 1][n] * beyond[axis][n];
          }
          out[n] = last = inverse[n] * (sum + weights.along[0][n] * last);
        }
      }
    });
}

void Multigrid::Restrict(const NodeValues& fine)
{
  ParallelFor(0, aggregates.Count(), ValuesAChunk,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t a = first; a < last; ++a)
      {
        WideLanes sum{};
        for (std::int32_t c = aggregates.firstChild[a]; c < aggregates.firstChild[a + 1]; ++c)
          sum += Widen(fine.data()[aggregates.children[c]]);
        coarseResidual.data()[a] = Narrow(sum);
      }
    });
}

void Multigrid::Prolong(const NodeValues& from, NodeValues& to) const
{
  ParallelFor(0, graph->Nodes(), ValuesAChunk,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        to.data()[n] =
          Free(n) ? from.data()[n] + coarseCorrection.data()[aggregates.of[n]] : from.data()[n];
    });
}

void Multigrid::Precondition(const NodeValues& r, NodeValues& z)
{
  const Weights weights(*graph);
  SmoothForwards(r, z);
  ParallelFor(0, static_cast<std::int64_t>(blocks.size()), 1,
    [&](std::int64_t b, std::int64_t)
    {
      for (std::int64_t s = blocks[b].firstSpan; s < blocks[b].endSpan; ++s)
      {
        const VoxelGraph::Span& span = graph->Spans()[s];
        for (std::int64_t n = span.first; n < span.first + span.count; ++n)
          scratch.data()[n] =
            Free(n) ? r.data()[n] + InFlow<Lanes>(span, weights.along, z.data(), n, InSingle{})
                    : Lanes{};
      }
    });
  Restrict(scratch);
  coarse.Precondition(coarseResidual, coarseCorrection);
  Prolong(z, scratch);
  SmoothBackwards(r, scratch, z);
}

int Multigrid::SolveCoarse(const NodeValues& r, NodeValues& z, double tolerance)
{
  constexpr int most = 50;
  Restrict(r);
  NodeValues residual = coarseResidual;
  NodeValues solution(aggregates.Count());
  const SolverRun run =
    ConjugateGradients(coarse, solution, residual, NodeValues(), tolerance, most);
  std::copy_n(solution.data(), aggregates.Count(), coarseCorrection.data());
  std::fill_n(z.data(), graph->Nodes(), Lanes{});
  Prolong(z, z);
  return run.cycles;
}

std::size_t Multigrid::Bytes() const
{
  return inverse.capacity() * sizeof(float) + coarse.Bytes() + scratch.Bytes() +
         coarseResidual.Bytes() + coarseCorrection.Bytes() +
         (aggregates.of.capacity() + aggregates.children.capacity() +
           aggregates.firstChild.capacity()) *
           sizeof(std::int32_t);
}

} // namespace hasp::walk
