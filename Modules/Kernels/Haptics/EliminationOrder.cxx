#include "Haptics/EliminationOrder.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace hasp
{

namespace
{

constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();
constexpr int MostNeighbors = 64;

/// Points sorted into cubes, found by a hash of the cube.
class CubeTable
{
public:
  CubeTable(std::span<const SurfacePoint> points, std::span<const std::uint32_t> chosen, float side)
  {
    glm::vec3 low(std::numeric_limits<float>::max());
    for (const std::uint32_t p : chosen)
      low = glm::min(low, points[p].position);
    struct Keyed
    {
      std::uint64_t key;
      std::uint32_t point;
    };
    std::vector<Keyed> keyed(chosen.size());
    for (std::size_t n = 0; n < chosen.size(); ++n)
    {
      const glm::vec3 cube = glm::min((points[chosen[n]].position - low) / side, glm::vec3(2e6F));
      keyed[n] = { KeyOf(glm::ivec3(cube) + 1), chosen[n] };
    }
    std::sort(keyed.begin(), keyed.end(),
      [](const Keyed& a, const Keyed& b)
      { return a.key != b.key ? a.key < b.key : a.point < b.point; });
    this->Points.reserve(keyed.size());
    for (std::size_t n = 0; n < keyed.size(); ++n)
    {
      if (n == 0 || keyed[n].key != keyed[n - 1].key)
        this->Cubes.push_back({ keyed[n].key, static_cast<std::uint32_t>(n) });
      this->Points.push_back(keyed[n].point);
    }
    this->Cubes.push_back({ 0, static_cast<std::uint32_t>(keyed.size()) });
    std::size_t size = 16;
    while (size < 2 * this->Cubes.size())
      size *= 2;
    this->Table.assign(size, None);
    for (std::uint32_t c = 0; c < this->Count(); ++c)
      this->Table[this->SlotOf(this->Cubes[c].key)] = c;
  }
  std::uint32_t Count() const { return static_cast<std::uint32_t>(this->Cubes.size() - 1); }
  std::span<const std::uint32_t> Sorted() const { return this->Points; }
  /// The positions in Sorted() of a cube's points: from, to.
  std::pair<std::uint32_t, std::uint32_t> RangeOf(std::uint32_t cube) const
  {
    return { this->Cubes[cube].first, this->Cubes[cube + 1].first };
  }
  /// Calls visit(cube) for the cube and those that touch it.
  template <typename Visit>
  void Around(std::uint32_t cube, const Visit& visit) const
  {
    const std::uint64_t key = this->Cubes[cube].key;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
        {
          const std::uint64_t beside = key + KeyOf({ x, y, z });
          if (const std::uint32_t found = this->Table[this->SlotOf(beside)]; found != None)
            visit(found);
        }
  }

private:
  struct Cube
  {
    std::uint64_t key;
    std::uint32_t first;
  };
  /// Steps to a neighbour add up, for no cube is nearer than 1 to either end of 21 bits.
  static std::uint64_t KeyOf(const glm::ivec3& c)
  {
    return (static_cast<std::uint64_t>(static_cast<std::int64_t>(c.z)) << 42) +
           (static_cast<std::uint64_t>(static_cast<std::int64_t>(c.y)) << 21) +
           static_cast<std::uint64_t>(static_cast<std::int64_t>(c.x));
  }
  /// Where the cube is, or the free slot where it would be.
  std::size_t SlotOf(std::uint64_t key) const
  {
    const std::size_t mask = this->Table.size() - 1;
    std::size_t slot = (key * 0x9e3779b97f4a7c15U) >> 20 & mask;
    while (this->Table[slot] != None && this->Cubes[this->Table[slot]].key != key)
      slot = (slot + 1) & mask;
    return slot;
  }

  std::vector<Cube> Cubes; ///< and one more: the end
  std::vector<std::uint32_t> Points, Table;
};

/// Who crowds whom, and how much. Points are numbered in the order of the cubes.
struct Crowding
{
  std::vector<std::uint32_t> points; ///< the caller's number of each
  std::vector<std::uint32_t> firsts; ///< of each point's neighbours; and the end
  struct Neighbor
  {
    std::uint32_t point;
    float weight;
  };
  std::vector<Neighbor> neighbors;
};

/// Yuksel's weight of a neighbour at a distance, 0 from 2 rMax on.
class Weight
{
public:
  Weight(double rMax, double left)
    : PerMm(static_cast<float>(0.5 / rMax)),
      Least(static_cast<float>(0.65 * (1.0 - std::pow(left, 1.5))))
  {
  }
  float operator()(float distance) const
  {
    const float w = 1.0F - std::max(distance * this->PerMm, this->Least);
    const float squared = w * w, fourth = squared * squared;
    return fourth * fourth;
  }

private:
  float PerMm, Least;
};

Crowding FindCrowding(std::span<const SurfacePoint> points, std::span<const std::uint32_t> chosen,
  double rMax, double left)
{
  const float reach = std::max(static_cast<float>(2.0 * rMax), std::numeric_limits<float>::min());
  const Weight weight(rMax, left);
  const CubeTable table(points, chosen, reach);
  const std::span<const std::uint32_t> sorted = table.Sorted();
  constexpr std::uint32_t Grain = 1024;
  std::vector<std::vector<Crowding::Neighbor>> pieces((table.Count() + Grain - 1) / Grain);
  Crowding crowding{ { sorted.begin(), sorted.end() }, {}, {} };
  crowding.firsts.assign(sorted.size() + 1, 0);
  const auto neighborsOf = [&](
                             std::uint32_t n, std::span<const std::uint32_t> candidates, auto& out)
  {
    const SurfacePoint& point = points[sorted[n]];
    std::uint32_t count = 0;
    for (const std::uint32_t c : candidates)
    {
      const SurfacePoint& other = points[sorted[c]];
      const glm::vec3 apart = other.position - point.position;
      const float squared = glm::dot(apart, apart);
      if (c == n || squared >= reach * reach || glm::dot(other.normal, point.normal) < -0.5F)
        continue;
      out.push_back({ c, weight(std::sqrt(squared)) });
      if (++count == MostNeighbors)
        break;
    }
    crowding.firsts[n + 1] = count;
  };
  ParallelFor(0, table.Count(), Grain,
    [&](std::int64_t first, std::int64_t end)
    {
      auto& out = pieces[first / Grain];
      std::vector<std::uint32_t> candidates;
      for (auto cube = static_cast<std::uint32_t>(first); cube < end; ++cube)
      {
        candidates.clear();
        table.Around(cube,
          [&](std::uint32_t beside)
          {
            const auto [from, to] = table.RangeOf(beside);
            for (std::uint32_t n = from; n < to && n < from + 4 * MostNeighbors; ++n)
              candidates.push_back(n);
          });
        const auto [from, to] = table.RangeOf(cube);
        for (std::uint32_t n = from; n < to; ++n)
          neighborsOf(n, candidates, out);
      }
    });
  for (const auto& piece : pieces)
    crowding.neighbors.insert(crowding.neighbors.end(), piece.begin(), piece.end());
  std::partial_sum(crowding.firsts.begin(), crowding.firsts.end(), crowding.firsts.begin());
  return crowding;
}

/// The point that is crowded most on top; equals by number. Weights only fall.
class CrowdedMost
{
public:
  explicit CrowdedMost(std::vector<float> weights)
    : Weights(std::move(weights)),
      Heap(this->Weights.size()),
      Places(this->Weights.size())
  {
    std::iota(this->Heap.begin(), this->Heap.end(), 0U);
    std::iota(this->Places.begin(), this->Places.end(), 0U);
    for (std::size_t n = this->Heap.size() / 2; n-- > 0;)
      this->Sink(n);
  }
  std::uint32_t Take()
  {
    const std::uint32_t top = this->Heap.front();
    this->Places[top] = None;
    const std::uint32_t last = this->Heap.back();
    this->Heap.pop_back();
    if (!this->Heap.empty())
    {
      this->Put(0, last);
      this->Sink(0);
    }
    return top;
  }
  void Relieve(std::uint32_t point, float weight)
  {
    if (this->Places[point] == None)
      return;
    this->Weights[point] -= weight;
    this->Sink(this->Places[point]);
  }
  std::span<const std::uint32_t> Left() const { return this->Heap; }

private:
  bool Before(std::uint32_t a, std::uint32_t b) const
  {
    return this->Weights[a] != this->Weights[b] ? this->Weights[a] > this->Weights[b] : a < b;
  }
  void Put(std::size_t place, std::uint32_t point)
  {
    this->Heap[place] = point;
    this->Places[point] = static_cast<std::uint32_t>(place);
  }
  void Sink(std::size_t place)
  {
    const std::uint32_t point = this->Heap[place];
    for (std::size_t below = 2 * place + 1; below < this->Heap.size(); below = 2 * place + 1)
    {
      if (below + 1 < this->Heap.size() && this->Before(this->Heap[below + 1], this->Heap[below]))
        ++below;
      if (!this->Before(this->Heap[below], point))
        break;
      this->Put(place, this->Heap[below]);
      place = below;
    }
    this->Put(place, point);
  }

  std::vector<float> Weights;
  std::vector<std::uint32_t> Heap, Places;
};

/// Those of `chosen` that are left when `count` are: ascending.
std::vector<std::uint32_t> Thin(std::span<const SurfacePoint> points,
  std::span<const std::uint32_t> chosen, double area, std::uint32_t count)
{
  const double rMax = std::sqrt(area / (2.0 * std::numbers::sqrt3 * count));
  const Crowding crowding = FindCrowding(points, chosen, rMax, double(count) / chosen.size());
  std::vector<float> weights(chosen.size(), 0.0F);
  for (const Crowding::Neighbor& neighbor : crowding.neighbors)
    weights[neighbor.point] += neighbor.weight;
  CrowdedMost crowded(std::move(weights));
  for (std::size_t left = chosen.size(); left > count; --left)
  {
    const std::uint32_t gone = crowded.Take();
    for (std::uint32_t n = crowding.firsts[gone]; n < crowding.firsts[gone + 1]; ++n)
      crowded.Relieve(crowding.neighbors[n].point, crowding.neighbors[n].weight);
  }
  std::vector<std::uint32_t> left;
  left.reserve(count);
  for (const std::uint32_t n : crowded.Left())
    left.push_back(crowding.points[n]);
  std::sort(left.begin(), left.end());
  return left;
}

} // namespace

std::vector<std::uint32_t> EliminationOrder(std::span<const SurfacePoint> points, double area,
  std::span<const std::uint32_t> ends, const ProgressFunction& progress)
{
  std::vector<std::uint32_t> left(points.size());
  std::iota(left.begin(), left.end(), 0U);
  std::vector<std::uint32_t> order(ends.empty() ? 0 : ends.back());
  for (std::size_t level = ends.size(); level-- > 0;)
  {
    // The first round is over four times the points of the second, and so on.
    ReportProgress(progress, 1.0 - std::pow(0.25, double(ends.size() - 1 - level)));
    if (left.size() > ends[level])
      left = Thin(points, left, area, ends[level]);
    const std::vector<std::uint32_t> next =
      level == 0 ? std::vector<std::uint32_t>() : Thin(points, left, area, ends[level - 1]);
    std::set_difference(left.begin(), left.end(), next.begin(), next.end(),
      order.begin() + static_cast<std::ptrdiff_t>(next.size()));
    left = next;
  }
  return order;
}

} // namespace hasp
