#include "FragmentLabels.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <tuple>

namespace hasp
{

namespace
{
/// Calls visit(index, place) of the neighbours of a sample, 26 inside the grid.
template <typename Visit>
void VisitNeighbours(const glm::ivec3& dims, const glm::ivec3& at, Visit visit)
{
  const glm::ivec3 low = glm::max(at - 1, glm::ivec3(0)), high = glm::min(at + 1, dims - 1);
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i)
        visit((std::size_t(k) * dims.y + j) * dims.x + i, glm::ivec3(i, j, k));
}

} // namespace

std::pair<glm::ivec3, glm::ivec3> SamplesIn(const GridGeometry& grid, const ImplicitSolid::Box& box)
{
  glm::dvec3 low(1e9), high(-1e9);
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 corner(c & 1 ? box.high.x : box.low.x, c & 2 ? box.high.y : box.low.y,
      c & 4 ? box.high.z : box.low.z);
    const glm::dvec3 index = grid.WorldToIndex(corner);
    low = glm::min(low, index);
    high = glm::max(high, index);
  }
  return { glm::max(glm::ivec3(glm::floor(glm::clamp(low, -2.0, 1e6))) - 1, glm::ivec3(0)),
    glm::min(glm::ivec3(glm::ceil(glm::clamp(high, -2.0, 1e6))) + 1, grid.dims - 1) };
}
void FloodSamples(const glm::ivec3& dims, std::vector<std::uint8_t>& mark, std::size_t seed,
  std::uint8_t from, std::uint8_t to, const std::function<void(std::size_t)>& tell)
{
  std::vector<std::size_t> queue{ seed };
  mark[seed] = to;
  while (!queue.empty())
  {
    const std::size_t at = queue.back();
    queue.pop_back();
    if (tell)
      tell(at);
    VisitNeighbours(dims, SamplePlace(dims, at),
      [&](std::size_t next, const glm::ivec3&)
      {
        if (mark[next] != from)
          return;
        mark[next] = to;
        queue.push_back(next);
      });
  }
}

FragmentLabels::FragmentLabels(const GridGeometry& volume, std::span<const std::uint8_t> keep)
  : Grid(volume)
{
  glm::ivec3 low(volume.dims), high(0);
  for (std::size_t n = 0; n < keep.size(); ++n)
    if (keep[n])
    {
      low = glm::min(low, SamplePlace(volume.dims, n));
      high = glm::max(high, SamplePlace(volume.dims, n));
    }
  this->Grid.dims = glm::max(high - low + 1, glm::ivec3(1));
  this->Grid.origin = volume.IndexToWorld(glm::dvec3(low));
  this->Labels.resize(this->Grid.Size());
  constexpr std::uint32_t Unseen = ~0U;
  for (std::size_t n = 0; n < this->Labels.size(); ++n)
  {
    const glm::ivec3 at = low + SamplePlace(this->Grid.dims, n);
    if (keep[(std::size_t(at.z) * volume.dims.y + at.y) * volume.dims.x + at.x])
      this->Labels[n] = Unseen;
  }
  for (std::size_t n = 0; n < this->Labels.size(); ++n)
    if (this->Labels[n] == Unseen)
      this->Flood(Unseen, ++this->Last, n, nullptr);
}

std::uint32_t FragmentLabels::At(const glm::dvec3& world) const
{
  const glm::dvec3 index = this->Grid.WorldToIndex(world);
  const glm::ivec3 cell(glm::floor(index));
  std::uint32_t label = 0;
  double nearest = 1e30;
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 at = cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2);
    if (glm::any(glm::lessThan(at, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(at, this->Grid.dims)))
      continue;
    const std::uint32_t found =
      this->Labels[(std::size_t(at.z) * this->Grid.dims.y + at.y) * this->Grid.dims.x + at.x];
    const double away = glm::length((glm::dvec3(at) - index) * this->Grid.spacing);
    if (found != 0 && away < nearest)
      nearest = away, label = found;
  }
  return label;
}

void FragmentLabels::Flood(
  std::uint32_t from, std::uint32_t to, std::size_t seed, const CutTool* tool)
{
  this->Queue.assign(1, seed);
  this->Labels[seed] = to;
  while (!this->Queue.empty())
  {
    const std::size_t at = this->Queue.back();
    this->Queue.pop_back();
    const glm::ivec3 place = SamplePlace(this->Grid.dims, at);
    const bool near = tool && glm::all(glm::greaterThanEqual(place, this->NearLow)) &&
                      glm::all(glm::lessThanEqual(place, this->NearHigh));
    const glm::dvec3 world = near ? this->Grid.IndexToWorld(glm::dvec3(place)) : glm::dvec3(0.0);
    VisitNeighbours(this->Grid.dims, place,
      [&](std::size_t next, const glm::ivec3& neighbour)
      {
        if (this->Labels[next] != from ||
            (near && tool->Blocks(world, this->Grid.IndexToWorld(glm::dvec3(neighbour)))))
          return;
        this->Labels[next] = to;
        this->Queue.push_back(next);
      });
  }
}

void FragmentLabels::Part(std::uint32_t fragment, const CutTool& tool)
{
  std::tie(this->NearLow, this->NearHigh) = SamplesIn(this->Grid, tool.blade.Bounds());
  for (std::size_t n = 0; n < this->Labels.size(); ++n)
  {
    if (this->Labels[n] != fragment)
      continue;
    const glm::ivec3 at = SamplePlace(this->Grid.dims, n);
    if (glm::all(glm::greaterThanEqual(at, this->NearLow)) &&
        glm::all(glm::lessThanEqual(at, this->NearHigh)) &&
        tool.Takes(this->Grid.IndexToWorld(glm::dvec3(at))))
      this->Labels[n] = 0;
  }
  for (std::size_t n = 0; n < this->Labels.size(); ++n)
    if (this->Labels[n] == fragment)
      this->Flood(fragment, ++this->Last, n, &tool);
}

} // namespace hasp
