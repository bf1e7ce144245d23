#include "Segmentation/LocalGraph.h"

#include "Grid/ParallelFor.h"

#include <algorithm>

namespace hasp::walk
{

namespace
{

float Largest(Lanes value)
{
  const Lanes a = Abs(value);
  return std::max(std::max(a[0], a[1]), std::max(a[2], a[3]));
}

/// Calls visit(k, j, run) for the runs of a layer of cells, slice by slice.
template <typename Visit>
void ForEachRun(const VoxelGraph& graph, std::int64_t layer, Visit visit)
{
  const glm::ivec3 dims = graph.Geometry().dims;
  const int first = static_cast<int>(layer) * MarkedCells::Size;
  for (int k = first; k < std::min(first + MarkedCells::Size, dims.z); ++k)
    for (int j = 0; j < dims.y; ++j)
    {
      const std::size_t row = static_cast<std::size_t>(k) * dims.y + j;
      for (std::int32_t r = graph.RowRuns()[row]; r < graph.RowRuns()[row + 1]; ++r)
        visit(k, j, graph.Runs()[r]);
    }
}

/// Calls visit(i, first, last) for the parts of a run that lie in one cell.
template <typename Visit>
void ForEachCell(const VoxelGraph::Run& run, Visit visit)
{
  for (std::int32_t x = run.x; x < run.x + run.count;)
  {
    const std::int32_t next =
      std::min(x / MarkedCells::Size * MarkedCells::Size + MarkedCells::Size, run.x + run.count);
    visit(x, run.first + x - run.x, run.first + next - run.x);
    x = next;
  }
}

/// Marks what lies beside a mark along one axis: `step` on in memory, `count` cells long.
void Widen(std::vector<std::uint8_t>& marked, std::size_t step, std::size_t count)
{
  std::vector<std::uint8_t> wide = marked;
  for (std::size_t c = 0; c < marked.size(); ++c)
    if (marked[c] != 0)
    {
      const std::size_t at = c / step % count;
      if (at > 0)
        wide[c - step] = 1;
      if (at + 1 < count)
        wide[c + step] = 1;
    }
  marked.swap(wide);
}

} // namespace

MarkedCells::MarkedCells(const VoxelGraph& graph, const NodeValues& values, float limit)
  : cells((graph.Geometry().dims + (Size - 1)) / Size)
{
  const auto x = static_cast<std::size_t>(cells.x);
  const auto y = static_cast<std::size_t>(cells.y);
  const auto z = static_cast<std::size_t>(cells.z);
  std::vector<float> largest(x * y * z);
  std::vector<std::int32_t> counts(x * y * z);
  ParallelFor(0, cells.z, 1,
    [&](std::int64_t layer, std::int64_t)
    {
      ForEachRun(graph, layer,
        [&](int k, int j, const VoxelGraph::Run& run)
        {
          ForEachCell(run,
            [&](std::int32_t i, std::int32_t first, std::int32_t last)
            {
              const std::size_t cell = Index(i / Size, j / Size, k / Size);
              Lanes most{};
              for (std::int32_t n = first; n < last; ++n)
                most = Max(most, Abs(values.data()[n]));
              largest[cell] = std::max(largest[cell], Largest(most));
              counts[cell] += last - first;
            });
        });
    });
  marked.resize(largest.size());
  std::transform(largest.begin(), largest.end(), marked.begin(),
    [&](float value) { return static_cast<std::uint8_t>(value > limit); });
  Widen(marked, 1, x);
  Widen(marked, x, y);
  Widen(marked, x * y, z);
  for (std::size_t c = 0; c < marked.size(); ++c)
    if (marked[c] != 0)
      nodes += counts[c];
    else
      largestOutside = std::max(largestOutside, largest[c]);
}

LocalGraph::LocalGraph(const VoxelGraph& whole, const MarkedCells& cells)
{
  const glm::ivec3 dims = whole.Geometry().dims;
  std::vector<std::vector<VoxelGraph::Run>> layers(
    (dims.z + MarkedCells::Size - 1) / MarkedCells::Size);
  std::vector<std::int32_t> rowRuns(whole.RowRuns().size());
  ParallelFor(0, static_cast<std::int64_t>(layers.size()), 1,
    [&](std::int64_t layer, std::int64_t)
    {
      ForEachRun(whole, layer,
        [&](int k, int j, const VoxelGraph::Run& run)
        {
          bool open = false;
          ForEachCell(run,
            [&](std::int32_t i, std::int32_t first, std::int32_t last)
            {
              const bool in = cells.At(i, j, k);
              if (in && open)
                layers[layer].back().count += last - first;
              else if (in)
              {
                layers[layer].push_back({ first, last - first, i });
                ++rowRuns[static_cast<std::size_t>(k) * dims.y + j + 1];
              }
              open = in;
            });
        });
    });
  std::vector<VoxelGraph::Run> runs;
  for (const std::vector<VoxelGraph::Run>& layer : layers)
    runs.insert(runs.end(), layer.begin(), layer.end());
  Cut(whole, std::move(runs), std::move(rowRuns));
}

LocalGraph::LocalGraph(const VoxelGraph& whole, const std::vector<std::uint8_t>& in)
{
  std::vector<VoxelGraph::Run> runs;
  std::vector<std::int32_t> rowRuns(whole.RowRuns().size());
  for (std::size_t row = 0; row + 1 < rowRuns.size(); ++row)
    for (std::int32_t r = whole.RowRuns()[row]; r < whole.RowRuns()[row + 1]; ++r)
    {
      const VoxelGraph::Run& run = whole.Runs()[r];
      const auto end = in.begin() + run.first + run.count;
      for (auto at = in.begin() + run.first;;)
      {
        const auto first = std::find_if(at, end, [](std::uint8_t v) { return v != 0; });
        if (first == end)
          break;
        at = std::find(first, end, std::uint8_t{ 0 });
        const auto node = static_cast<std::int32_t>(first - in.begin());
        runs.push_back({ node, static_cast<std::int32_t>(at - first), run.x + node - run.first });
        ++rowRuns[row + 1];
      }
    }
  Cut(whole, std::move(runs), std::move(rowRuns));
}

/// rowRuns: how many runs each row has, one place on.
void LocalGraph::Cut(
  const VoxelGraph& whole, std::vector<VoxelGraph::Run> runs, std::vector<std::int32_t> rowRuns)
{
  for (std::size_t row = 1; row < rowRuns.size(); ++row)
    rowRuns[row] += rowRuns[row - 1];
  std::int32_t nodes = 0;
  for (const VoxelGraph::Run& run : runs)
  {
    pieces.push_back({ run.first, nodes, run.count });
    nodes += run.count;
  }
  graph = std::make_shared<const VoxelGraph>(whole, std::move(runs), std::move(rowRuns));

  std::vector<std::uint8_t> inside(static_cast<std::size_t>(whole.Nodes()) + 2);
  std::uint8_t* const in = inside.data() + 1;
  for (const Piece& piece : pieces)
    std::fill_n(in + piece.whole, piece.count, std::uint8_t{ 1 });
  const std::vector<VoxelGraph::Span>& spans = whole.Spans();
  auto span = spans.begin();
  for (const Piece& piece : pieces)
  {
    span = std::upper_bound(span, spans.end(), piece.whole,
             [](std::int32_t n, const VoxelGraph::Span& s) { return n < s.first; }) -
           1;
    auto at = span;
    for (std::int32_t c = 0; c < piece.count; ++c)
    {
      const std::int32_t n = piece.whole + c;
      while (n >= at->first + at->count)
        ++at;
      bool cut = (whole.Along(0)[n] > 0.0F && in[n + 1] == 0) ||
                 (whole.Along(0)[n - 1] > 0.0F && in[n - 1] == 0);
      for (int axis = 0; axis < 2; ++axis) // 0 leads to the node itself
        cut = cut || in[n + at->above[axis]] == 0 || in[n + at->below[axis]] == 0;
      if (cut)
        rim.push_back(piece.local + c);
    }
  }
}

NodeValues LocalGraph::Take(const NodeValues& whole) const
{
  NodeValues local(graph->Nodes());
  for (const Piece& piece : pieces)
    std::copy_n(whole.data() + piece.whole, piece.count, local.data() + piece.local);
  return local;
}

void LocalGraph::Put(const NodeValues& local, NodeValues& whole) const
{
  for (const Piece& piece : pieces)
    std::copy_n(local.data() + piece.local, piece.count, whole.data() + piece.whole);
}

} // namespace hasp::walk
