#include "Segmentation/CoarseGraph.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <numeric>

namespace hasp::walk
{

namespace
{

constexpr float strongShare = 0.25F;
constexpr std::int32_t mostChildren = 4;

/// Calls visit(node, neighbour, weight) for all six of each node of a span.
template <typename Visit>
void ForEachNeighbour(const VoxelGraph& graph, const VoxelGraph::Span& span, Visit visit)
{
  const float* x = graph.Along(0);
  for (std::int32_t n = span.first; n < span.first + span.count; ++n)
  {
    if (x[n] > 0.0F)
      visit(n, n + 1, x[n]);
    if (x[n - 1] > 0.0F)
      visit(n, n - 1, x[n - 1]);
    for (int axis = 1; axis < 3; ++axis)
    {
      const float* w = graph.Along(axis);
      if (const std::int32_t on = span.above[axis - 1]; on != 0)
        visit(n, n + on, w[n]);
      if (const std::int32_t back = span.below[axis - 1]; back != 0)
        visit(n, n + back, w[n + back]);
    }
  }
}

/// First spans of pieces of about equal size, and the end.
std::vector<std::int64_t> SlicePairs(const VoxelGraph& graph)
{
  const glm::ivec3 dims = graph.Geometry().dims;
  std::vector<std::int64_t> first;
  for (int k = 0; k < dims.z; k += 2)
  {
    const std::int32_t run = graph.RowRuns()[static_cast<std::size_t>(k) * dims.y];
    const std::int32_t node = run < static_cast<std::int32_t>(graph.Runs().size())
                                ? graph.Runs()[run].first
                                : static_cast<std::int32_t>(graph.Nodes());
    first.push_back(std::lower_bound(graph.Spans().begin(), graph.Spans().end(), node,
                      [](const VoxelGraph::Span& span, std::int32_t n) { return span.first < n; }) -
                    graph.Spans().begin());
  }
  first.push_back(static_cast<std::int64_t>(graph.Spans().size()));
  return first;
}

std::int32_t Root(std::vector<std::int32_t>& parent, std::int32_t n)
{
  while (parent[n] != n)
    n = parent[n] = parent[parent[n]];
  return n;
}

void Join(std::vector<std::int32_t>& parent, std::int32_t a, std::int32_t b)
{
  a = Root(parent, a);
  b = Root(parent, b);
  if (a != b)
    parent[std::max(a, b)] = std::min(a, b);
}

/// Numbers of aggregates in the order of their first nodes. `parent` leads to roots.
Aggregates Number(std::vector<std::int32_t> parent)
{
  Aggregates result;
  std::int32_t count = 0;
  const auto nodes = static_cast<std::int32_t>(parent.size());
  std::vector<std::int32_t>& of = parent; // a root comes before all that lead to it
  std::vector<std::int32_t> number(parent.size());
  for (std::int32_t n = 0; n < nodes; ++n)
    number[n] = parent[n] == n ? count++ : number[parent[n]];
  of = std::move(number);
  result.firstChild.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const std::int32_t aggregate : of)
    ++result.firstChild[aggregate + 1];
  std::partial_sum(result.firstChild.begin(), result.firstChild.end(), result.firstChild.begin());
  result.children.resize(of.size());
  std::vector<std::int32_t> next(result.firstChild.begin(), result.firstChild.end() - 1);
  for (std::int32_t n = 0; n < nodes; ++n)
    result.children[next[of[n]]++] = n;
  result.of = std::move(of);
  return result;
}

using Link = std::pair<std::int32_t, float>;

/// Rows of the coarse graph, a chunk of aggregates at a time. links(child, add) gives add(to,
/// weight).
template <typename Links>
CoarseGraph CoarsenRows(const Aggregates& aggregates, Links links)
{
  constexpr std::int32_t chunk = 4096;
  const std::int32_t count = aggregates.Count();
  struct Rows
  {
    std::vector<std::int32_t> sizes;
    std::vector<Link> links;
  };
  std::vector<Rows> chunks(static_cast<std::size_t>((count + chunk - 1) / chunk));
  ParallelFor(0, count, chunk,
    [&](std::int64_t first, std::int64_t last)
    {
      Rows& rows = chunks[static_cast<std::size_t>(first / chunk)];
      std::vector<Link> row;
      for (std::int64_t a = first; a < last; ++a)
      {
        row.clear();
        for (std::int32_t c = aggregates.firstChild[a]; c < aggregates.firstChild[a + 1]; ++c)
          links(aggregates.children[c],
            [&](std::int32_t to, float weight)
            {
              if (aggregates.of[to] != a)
                row.emplace_back(aggregates.of[to], weight);
            });
        // By number alone and stable: sums come in the order of the children, whatever sorts.
        // Rows are short.
        for (std::size_t l = 1; l < row.size(); ++l)
        {
          const Link link = row[l];
          std::size_t to = l;
          for (; to > 0 && row[to - 1].first > link.first; --to)
            row[to] = row[to - 1];
          row[to] = link;
        }
        const std::size_t before = rows.links.size();
        for (const Link& link : row)
          if (rows.links.size() > before && rows.links.back().first == link.first)
            rows.links.back().second += link.second;
          else
            rows.links.push_back(link);
        rows.sizes.push_back(static_cast<std::int32_t>(rows.links.size() - before));
      }
    });
  CoarseGraph graph;
  std::size_t all = 0;
  for (const Rows& rows : chunks)
    all += rows.links.size();
  graph.to.reserve(all);
  graph.weight.reserve(all);
  graph.firstLink.reserve(static_cast<std::size_t>(count) + 1);
  graph.firstLink.push_back(0);
  for (Rows& rows : chunks)
  {
    for (const std::int32_t size : rows.sizes)
      graph.firstLink.push_back(graph.firstLink.back() + size);
    for (const Link& link : rows.links)
    {
      graph.to.push_back(link.first);
      graph.weight.push_back(link.second);
    }
    rows = {};
  }
  return graph;
}

} // namespace

std::size_t CoarseGraph::Bytes() const
{
  return firstLink.capacity() * sizeof(std::int64_t) + to.capacity() * sizeof(std::int32_t) +
         weight.capacity() * sizeof(float);
}

Aggregates AggregateVoxels(const VoxelGraph& graph)
{
  const auto nodes = static_cast<std::size_t>(graph.Nodes());
  std::vector<float> strongest(nodes);
  std::vector<std::int32_t> strongestNode(nodes);
  const std::vector<std::int64_t> pairs = SlicePairs(graph);
  const auto pairCount = static_cast<std::int64_t>(pairs.size()) - 1;
  ParallelFor(0, pairCount, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t s = pairs[first]; s < pairs[last]; ++s)
        ForEachNeighbour(graph, graph.Spans()[s],
          [&](std::int32_t n, std::int32_t other, float weight)
          {
            if (weight > strongest[n])
            {
              strongest[n] = weight;
              strongestNode[n] = other;
            }
          });
    });

  // Within two slices, so that no two threads meet: blocks are two slices high.
  std::vector<std::int32_t> parent(nodes);
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<std::uint8_t> parity(nodes); // bit 0: odd x, bit 1: odd y, bit 2: odd z
  const glm::ivec3 dims = graph.Geometry().dims;
  ParallelFor(0, static_cast<std::int64_t>(dims.y) * dims.z, 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
        for (std::int32_t r = graph.RowRuns()[row]; r < graph.RowRuns()[row + 1]; ++r)
        {
          const VoxelGraph::Run& run = graph.Runs()[r];
          const auto rowParity =
            static_cast<std::uint8_t>((row % dims.y % 2) * 2 + (row / dims.y % 2) * 4);
          for (std::int32_t n = 0; n < run.count; ++n)
            parity[run.first + n] = static_cast<std::uint8_t>(rowParity + (run.x + n) % 2);
        }
    });
  ParallelFor(0, pairCount, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t s = pairs[first]; s < pairs[last]; ++s)
        ForEachNeighbour(graph, graph.Spans()[s],
          [&](std::int32_t n, std::int32_t other, float weight)
          {
            const int axisBit = parity[n] ^ parity[other];
            if (other < n && (parity[n] & axisBit) != 0 &&
                weight >= strongShare * std::max(strongest[n], strongest[other]))
              Join(parent, n, other);
          });
    });
  std::vector<std::uint8_t> alone(nodes, 1);
  for (std::size_t n = 0; n < nodes; ++n)
  {
    const std::int32_t root = Root(parent, static_cast<std::int32_t>(n));
    if (root != static_cast<std::int32_t>(n))
      alone[n] = alone[root] = 0;
  }
  for (std::size_t n = 0; n < nodes; ++n)
    if (alone[n] != 0 && strongest[n] > 0.0F)
      Join(parent, static_cast<std::int32_t>(n), strongestNode[n]);
  for (std::size_t n = 0; n < nodes; ++n)
    parent[n] = Root(parent, static_cast<std::int32_t>(n));
  return Number(std::move(parent));
}

Aggregates AggregateNodes(const CoarseGraph& graph)
{
  const std::int32_t nodes = graph.Nodes();
  std::vector<std::int32_t> parent(static_cast<std::size_t>(nodes), -1);
  std::vector<Link> near; // free neighbours of the aggregate that grows, and how strongly they hold
  for (std::int32_t n = 0; n < nodes; ++n)
  {
    if (parent[n] >= 0)
      continue;
    near.clear();
    std::int32_t size = 0;
    float strongest = 0.0F;
    std::int32_t strongestTaken = -1;
    float strongestTakenWeight = 0.0F;
    for (std::int32_t next = n; next >= 0 && size < mostChildren;)
    {
      parent[next] = n;
      ++size;
      for (std::int64_t l = graph.firstLink[next]; l < graph.firstLink[next + 1]; ++l)
      {
        const std::int32_t to = graph.to[l];
        const float weight = graph.weight[l];
        strongest = std::max(strongest, weight);
        if (parent[to] >= 0)
        {
          if (parent[to] != n && weight > strongestTakenWeight)
          {
            strongestTakenWeight = weight;
            strongestTaken = parent[to];
          }
          continue;
        }
        const auto known = std::find_if(
          near.begin(), near.end(), [&](const Link& link) { return link.first == to; });
        if (known == near.end())
          near.emplace_back(to, weight);
        else
          known->second += weight;
      }
      std::erase_if(near, [&](const Link& link) { return parent[link.first] >= 0; });
      const auto best = std::max_element(
        near.begin(), near.end(), [](const Link& p, const Link& q) { return p.second < q.second; });
      next = best != near.end() && best->second >= strongShare * strongest ? best->first : -1;
    }
    // What no free node holds to goes to where it holds most strongly itself.
    if (size == 1 && strongestTaken >= 0)
      parent[n] = strongestTaken;
  }
  // Roots come first: a lone node joined a lower number, so that Number's order holds.
  return Number(std::move(parent));
}

CoarseGraph Coarsen(const VoxelGraph& graph, const Aggregates& aggregates)
{
  // The span of a child is not known by its number: links are laid down node by node first.
  const auto nodes = static_cast<std::size_t>(graph.Nodes());
  std::vector<std::int32_t> spanOf(nodes);
  const auto spans = static_cast<std::int64_t>(graph.Spans().size());
  ParallelFor(0, spans, 8192,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t s = first; s < last; ++s)
        std::fill_n(spanOf.begin() + graph.Spans()[s].first, graph.Spans()[s].count,
          static_cast<std::int32_t>(s));
    });
  return CoarsenRows(aggregates,
    [&](std::int32_t child, auto add)
    {
      VoxelGraph::Span one = graph.Spans()[spanOf[child]];
      one.first = child;
      one.count = 1;
      ForEachNeighbour(
        graph, one, [&](std::int32_t, std::int32_t to, float weight) { add(to, weight); });
    });
}

CoarseGraph Coarsen(const CoarseGraph& graph, const Aggregates& aggregates)
{
  return CoarsenRows(aggregates,
    [&](std::int32_t child, auto add)
    {
      for (std::int64_t l = graph.firstLink[child]; l < graph.firstLink[child + 1]; ++l)
        add(graph.to[l], graph.weight[l]);
    });
}

} // namespace hasp::walk
