#include "Segmentation/ConjugateGradients.h"
#include "Segmentation/Multigrid.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace hasp::walk
{

namespace
{

constexpr std::int32_t coarsestNodes = 200;
/// Blocks that are smoothed one beside the other: thick, so that few links leave them. Their number
/// must not depend on the machine.
constexpr std::int64_t blockCount = 64;
constexpr std::int64_t leastBlock = 4096; ///< nodes
constexpr std::int64_t chunk = 8192;      ///< nodes a thread takes at once

double Inverse(double value)
{
  return value > 0.0 ? 1.0 / value : 0.0;
}

} // namespace

struct CoarseLevels::Level
{
  struct Link
  {
    std::int32_t to;
    float weight; ///< graph.weight less what is fixed
  };
  CoarseGraph graph;                               ///< as it is with all voxels free
  std::vector<Link> links;                         ///< of graph: read together, kept together
  std::int64_t block;                              ///< nodes smoothed one behind another
  std::vector<float> ground;                       ///< links to what is fixed
  std::vector<float> inverse;                      ///< of the diagonal; 0: nothing of it is free
  std::vector<std::int32_t> free;                  ///< free voxels in it
  std::vector<std::int64_t> changed;               ///< links whose weight is not the graph's
  Aggregates up;                                   ///< into the next level; empty in the coarsest
  std::vector<Lanes> residual, correction, rest;   ///< of this level
  std::vector<Lanes> first, product, firstProduct; ///< of Refine

  explicit Level(CoarseGraph g)
    : graph(std::move(g)),
      links(graph.to.size()),
      block(std::max<std::int64_t>(graph.Nodes() / blockCount, leastBlock))
  {
    for (std::size_t l = 0; l < links.size(); ++l)
      links[l] = { graph.to[l], graph.weight[l] };
    const auto nodes = static_cast<std::size_t>(graph.Nodes());
    ground.resize(nodes);
    inverse.resize(nodes);
    free.resize(nodes, 1);
    residual.resize(nodes);
    correction.resize(nodes);
    rest.resize(nodes);
  }

  std::span<const Link> LinksOf(std::int64_t n) const
  {
    return { links.data() + graph.firstLink[n], links.data() + graph.firstLink[n + 1] };
  }

  void Take(std::int32_t from, std::int32_t to, float amount)
  {
    const std::span<const Link> row = LinksOf(from);
    const auto found = std::lower_bound(
      row.begin(), row.end(), to, [](const Link& link, std::int32_t n) { return link.to < n; });
    const std::int64_t at = &*found - links.data();
    if (links[at].weight == graph.weight[at])
      changed.push_back(at);
    links[at].weight = std::max(links[at].weight - amount, 0.0F);
  }

  void FindInverse()
  {
    ParallelFor(0, graph.Nodes(), chunk,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          float sum = ground[n];
          for (const Link& link : LinksOf(n))
            sum += link.weight;
          inverse[n] = free[n] > 0 && sum > 0.0F ? 1.0F / sum : 0.0F;
        }
      });
  }

  /// rest = r - A x, 0 where nothing is free.
  void Rest(const Lanes* r, const Lanes* x, Lanes* out) const
  {
    ParallelFor(0, graph.Nodes(), chunk,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          const Lanes here = x[n];
          Lanes sum = r[n] - ground[n] * here;
          for (const Link& link : LinksOf(n))
            sum += link.weight * (x[link.to] - here);
          out[n] = inverse[n] > 0.0F ? sum : Lanes{};
        }
      });
  }

  WideLanes Dot(const std::vector<Lanes>& a, const std::vector<Lanes>& b) const
  {
    return SumOverChunks(graph.Nodes(), chunk,
      [&](std::int64_t begin, std::int64_t end)
      {
        WideLanes sum{};
        for (std::int64_t n = begin; n < end; ++n)
          sum += Widen(a[n]) * Widen(b[n]);
        return sum;
      });
  }

  /// out = A x, 0 where nothing is free. Returns x . out.
  WideLanes Multiply(const Lanes* x, Lanes* out) const
  {
    return SumOverChunks(graph.Nodes(), chunk,
      [&](std::int64_t begin, std::int64_t end)
      {
        WideLanes dot{};
        for (std::int64_t n = begin; n < end; ++n)
        {
          const Lanes here = x[n];
          Lanes sum = ground[n] * here;
          for (const Link& link : LinksOf(n))
            sum += link.weight * (here - x[link.to]);
          out[n] = inverse[n] > 0.0F ? sum : Lanes{};
          dot += Widen(x[n]) * Widen(out[n]);
        }
        return dot;
      });
  }

  /// x = (D + L)^-1 r, block by block.
  void SmoothForwards(const Lanes* r, Lanes* x) const
  {
    ParallelFor(0, graph.Nodes(), block,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          Lanes sum = r[n];
          for (const Link& link : LinksOf(n))
          {
            if (link.to >= n)
              break;
            if (link.to >= first)
              sum += link.weight * x[link.to];
          }
          x[n] = inverse[n] * sum;
        }
      });
  }

  /// x = x + (D + U)^-1 (r - A x), block by block, of x as it is in `old`: one pass, that takes
  /// what is new where it is there.
  void SmoothBackwards(const Lanes* r, const Lanes* old, Lanes* x) const
  {
    ParallelFor(0, graph.Nodes(), block,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = last - 1; n >= first; --n)
        {
          // What is new comes last, and the next node's last of all: it is what is waited for.
          Lanes sum = r[n];
          const Link* link = links.data() + graph.firstLink[n];
          const Link* end = links.data() + graph.firstLink[n + 1];
          for (; link != end && link->to < n; ++link)
            sum += link->weight * old[link->to];
          while (end-- != link)
            sum += end->weight * (end->to < last ? x : old)[end->to];
          x[n] = inverse[n] * sum;
        }
      });
  }
};

CoarseLevels::~CoarseLevels() = default;

CoarseLevels::CoarseLevels(CoarseGraph finest)
{
  levels.push_back(std::make_unique<Level>(std::move(finest)));
  while (levels.back()->graph.Nodes() > coarsestNodes)
  {
    Level& level = *levels.back();
    level.up = AggregateNodes(level.graph);
    if (level.up.Count() > level.graph.Nodes() * 9 / 10) // islands: nothing holds together any more
    {
      level.up = {};
      break;
    }
    levels.push_back(std::make_unique<Level>(Coarsen(level.graph, level.up)));
  }
  for (const auto& level : levels)
    std::vector<std::int32_t>().swap(level->graph.to); // the links have it
}

void CoarseLevels::Fix(std::vector<FixedLink> here, const std::vector<std::int32_t>& free)
{
  levels.front()->free = free;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    Level& level = *levels[l];
    for (const std::int64_t link : level.changed)
      level.links[link].weight = level.graph.weight[link];
    level.changed.clear();
    std::fill(level.ground.begin(), level.ground.end(), 0.0F);
    for (const FixedLink& link : here)
    {
      if (link.a != link.b)
      {
        level.Take(link.a, link.b, link.weight);
        level.Take(link.b, link.a, link.weight);
      }
      if (!link.bothFixed)
        level.ground[link.b] += link.weight;
    }
    level.FindInverse();
    if (l + 1 == levels.size())
      break;
    Level& next = *levels[l + 1];
    std::fill(next.free.begin(), next.free.end(), 0);
    for (std::size_t n = 0; n < level.free.size(); ++n)
      next.free[level.up.of[n]] += level.free[n];
    for (FixedLink& link : here)
    {
      link.a = level.up.of[link.a];
      link.b = level.up.of[link.b];
    }
  }
  Factorise();
}

/// L D L^T without a subtraction: a pivot is the sum of what a node is tied to (Grassmann, Taksar
/// and Heyman), so that the weakest tie counts beside the strongest.
void CoarseLevels::Factorise()
{
  factor.clear();
  const Level& level = *levels.back();
  const auto n = static_cast<std::size_t>(level.graph.Nodes());
  if (level.graph.Nodes() > 4 * coarsestNodes)
    return; // islands without end: they are smoothed
  factor.assign(n * n, 0.0);
  std::vector<double> ground(level.ground.begin(), level.ground.end());
  for (std::size_t i = 0; i < n; ++i)
    for (const Level::Link& link : level.LinksOf(static_cast<std::int64_t>(i)))
      factor[i * n + link.to] = link.weight;
  for (std::size_t k = 0; k < n; ++k)
  {
    double pivot = ground[k];
    for (std::size_t j = k + 1; j < n; ++j)
      pivot += factor[k * n + j];
    const bool free = level.inverse[k] > 0.0F && pivot > 0.0;
    const double inverse = free ? 1.0 / pivot : 0.0;
    factor[k * n + k] = inverse;
    for (std::size_t i = k + 1; i < n; ++i)
    {
      const double share = factor[i * n + k] * inverse;
      if (share == 0.0)
        continue;
      ground[i] += share * ground[k];
      for (std::size_t j = k + 1; j < n; ++j)
        if (j != i)
          factor[i * n + j] += share * factor[k * n + j];
      factor[i * n + k] = share;
    }
  }
}

void CoarseLevels::SolveCoarsest(const Lanes* residual, Lanes* correction)
{
  Level& level = *levels.back();
  const auto n = static_cast<std::size_t>(level.graph.Nodes());
  if (factor.empty())
  {
    level.SmoothForwards(residual, correction);
    for (int sweep = 0; sweep < 8; ++sweep)
    {
      std::copy_n(correction, n, level.rest.data());
      level.SmoothBackwards(residual, level.rest.data(), correction);
    }
    return;
  }
  std::vector<WideLanes> x(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    x[i] = Widen(residual[i]);
    for (std::size_t k = 0; k < i; ++k)
      x[i] += factor[i * n + k] * x[k];
  }
  for (std::size_t i = n; i-- > 0;)
  {
    x[i] *= factor[i * n + i];
    for (std::size_t k = i + 1; k < n; ++k)
      x[i] += factor[k * n + i] * x[k];
    correction[i] = Narrow(x[i]);
  }
}

void CoarseLevels::Cycle(std::size_t l, const Lanes* residual, Lanes* correction)
{
  if (l + 1 == levels.size())
  {
    SolveCoarsest(residual, correction);
    return;
  }
  Level& level = *levels[l];
  Level& next = *levels[l + 1];
  level.SmoothForwards(residual, correction);
  level.Rest(residual, correction, level.rest.data());
  ParallelFor(0, next.graph.Nodes(), chunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t a = begin; a < end; ++a)
      {
        Lanes sum{};
        for (std::int32_t c = level.up.firstChild[a]; c < level.up.firstChild[a + 1]; ++c)
          sum += level.rest[level.up.children[c]];
        next.residual[a] = sum;
      }
    });
  Cycle(l + 1, next.residual.data(), next.correction.data());
  if (l + 2 < levels.size())
    Refine(l + 1);
  ParallelFor(0, level.graph.Nodes(), chunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        level.rest[n] =
          level.inverse[n] > 0.0F ? correction[n] + next.correction[level.up.of[n]] : Lanes{};
    });
  level.SmoothBackwards(residual, level.rest.data(), correction);
}

/// A second cycle at a level, and of both the combination that comes nearest to the solution
/// (K-cycle, Notay 2008): piecewise constant corrections alone fall short, the more the more levels
/// there are. Uses the level's residual up.
void CoarseLevels::Refine(std::size_t l)
{
  Level& level = *levels[l];
  const std::int64_t nodes = level.graph.Nodes();
  const auto resize = [&](std::vector<Lanes>& values) { values.resize(level.residual.size()); };
  resize(level.first);
  resize(level.product);
  resize(level.firstProduct);
  level.first.swap(level.correction);
  const WideLanes curvature1 = level.Multiply(level.first.data(), level.firstProduct.data());
  const WideLanes gain1 = level.Dot(level.first, level.residual);
  Lanes step{};
  for (int lane = 0; lane < LaneCount; ++lane)
    step[lane] = static_cast<float>(gain1[lane] * Inverse(curvature1[lane]));
  ParallelFor(0, nodes, chunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        level.residual[n] -= step * level.firstProduct[n];
    });

  Cycle(l, level.residual.data(), level.correction.data());
  const WideLanes curvature2 = level.Multiply(level.correction.data(), level.product.data());
  const WideLanes gain2 = level.Dot(level.correction, level.residual);
  const WideLanes mixed = level.Dot(level.correction, level.firstProduct);
  Lanes share1{}, share2{};
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const double inverse1 = Inverse(curvature1[lane]);
    const double own = curvature2[lane] - mixed[lane] * mixed[lane] * inverse1;
    const double second = gain2[lane] * Inverse(own);
    share2[lane] = static_cast<float>(second);
    share1[lane] = static_cast<float>((gain1[lane] - mixed[lane] * second) * inverse1);
  }
  ParallelFor(0, nodes, chunk,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
        level.correction[n] = share1 * level.first[n] + share2 * level.correction[n];
    });
}

void CoarseLevels::Precondition(const NodeValues& r, NodeValues& z)
{
  Cycle(0, r.data(), z.data());
}

WideLanes CoarseLevels::Multiply(const NodeValues& x, NodeValues& product) const
{
  return levels.front()->Multiply(x.data(), product.data());
}

std::size_t CoarseLevels::Bytes() const
{
  std::size_t bytes = factor.capacity() * sizeof(double);
  for (const auto& level : levels)
    bytes +=
      level->graph.Bytes() + level->links.capacity() * sizeof(Level::Link) +
      static_cast<std::size_t>(level->graph.Nodes()) * (6 * sizeof(Lanes) + 3 * sizeof(float)) +
      (level->up.of.capacity() + level->up.children.capacity() + level->up.firstChild.capacity()) *
        sizeof(std::int32_t);
  return bytes;
}

} // namespace hasp::walk
