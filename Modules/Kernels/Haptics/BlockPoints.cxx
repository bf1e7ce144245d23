#include "Haptics/BlockPoints.h"
#include "Haptics/Hash.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{

BlockPoints::BlockPoints(const GridGeometry& geometry, const glm::dvec3& origin,
  std::uint32_t points, int blendTicks, std::uint32_t seed)
  : Kernels(FastestBlockKernels()),
    Cells(geometry.Cells()),
    Direction(geometry.direction),
    ToBody(geometry.direction),
    ToIndex(1.0),
    First(geometry.IndexToWorld(glm::dvec3(0.0)) - origin),
    BlendTicks(blendTicks),
    Seed(seed),
    Points(points)
{
  for (int axis = 0; axis < 3; ++axis)
    this->ToBody[axis] *= geometry.spacing[axis];
  this->ToIndex = glm::inverse(this->ToBody);
}

void BlockPoints::SetChunk(const ServedBlock& served, std::int32_t c, const BlockPlaces& places,
  std::uint32_t found) noexcept
{
  this->Points[c].alive = static_cast<std::uint8_t>(std::popcount(found));
  const glm::dvec3 first =
    this->First + this->ToBody * glm::dvec3(served.block * MinMaxBlocks::Side);
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    const auto at = [n](const auto& of) { return glm::dvec3(of[0][n], of[1][n], of[2][n]); };
    if ((found >> n & 1U) != 0)
      this->Points.SetPoint(
        c, n, first + this->ToBody * at(places.index), this->Direction * at(places.normal));
    else
      this->Points.Kill(c, n);
  }
}

void BlockPoints::Measure(ServedBlock& served) const noexcept
{
  served.settled = false;
  served.surface->FindCells(this->Kernels);
  served.area = served.surface->Area();
  served.step = std::abs(served.area - served.shown) / this->BlendTicks;
}

int BlockPoints::Draw(ServedBlock& served) noexcept
{
  const std::int32_t c = served.surface->Area() > 0.0 ? this->Points.Take() : PointRing::None;
  if (c == PointRing::None)
    return -1;
  PointRing::Chunk& chunk = this->Points[c];
  const std::uint64_t seed = HashOf(this->Seed, served.number);
  // One point to each 16th of the area; the next chunk's lie in the widest gaps between.
  const double shift = UnitHash(seed, 0) + 0.61803398874989485 * served.drawn;
  BlockSurface::Shares shares;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    const std::uint64_t number = 2 * (std::uint64_t(served.drawn) * PointRing::ChunkPoints + n) + 1;
    shares.area[n] = (n + shift - std::floor(shift)) / PointRing::ChunkPoints;
    shares.u[n] = UnitHash(seed, number);
    shares.v[n] = UnitHash(seed, number + 1);
  }
  BlockPlaces places;
  const std::uint32_t found = served.surface->Draw(this->Kernels, shares, places);
  this->SetChunk(served, c, places, found);
  ++served.drawn;
  if (chunk.alive == 0)
  {
    this->Points.GiveBack(c);
    return 0;
  }
  chunk.next = served.newest;
  served.newest = c;
  if (served.fresh++ == 0)
    served.hot.until = 0.0; // the points tell more than the block's ball
  served.settled = false;
  return chunk.alive;
}

void BlockPoints::SetIsovalue(ServedBlock& served, double isovalue, bool insideAbove) noexcept
{
  served.surface->SetIsovalue(isovalue, insideAbove ? -1.0 : 1.0);
  served.fresh = served.replaced = 0;
  served.settled = false;
  for (std::int32_t c = served.newest; c != PointRing::None; c = this->Points[c].next)
    this->Points[c].moved = false;
}

bool BlockPoints::MoveChunk(const ServedBlock& served, std::int32_t c) noexcept
{
  PointRing::Chunk& chunk = this->Points[c];
  const glm::dvec3 first = served.block * MinMaxBlocks::Side;
  const glm::dvec3 most = glm::min(glm::dvec3(MinMaxBlocks::Side), glm::dvec3(this->Cells) - first);
  chunk.moved = chunk.replaced = true;
  BlockPlaces places;
  std::uint32_t alive = 0;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    if (!this->Points.Alive(c, n))
      continue;
    alive |= 1U << n;
    const glm::dvec3 index =
      this->ToIndex * (glm::dvec3(this->Points.Position(c, n)) - this->First) - first;
    for (int axis = 0; axis < 3; ++axis)
      places.index[axis][n] = static_cast<float>(std::clamp(index[axis], 0.0, most[axis]));
  }
  const std::uint32_t found = this->Kernels.project(served.surface->Samples(), places);
  this->SetChunk(served, c, places, found & alive);
  return chunk.alive > 0;
}

std::uint32_t BlockPoints::Move(ServedBlock& served, int most, int& left) noexcept
{
  std::uint32_t count = 0;
  std::int32_t* link = &served.newest;
  while (*link != PointRing::None && most > 0)
  {
    const std::int32_t c = *link;
    PointRing::Chunk& chunk = this->Points[c];
    const bool before = chunk.moved;
    const bool moved = before || (left > 0 && this->MoveChunk(served, c));
    left -= before ? 0 : PointRing::ChunkPoints;
    most -= moved ? 1 : 0;
    served.replaced += moved && !before && !chunk.leaving ? 1 : 0;
    count += moved && !before ? chunk.alive : 0;
    if (moved)
      link = &chunk.next;
    else
    {
      *link = chunk.next;
      this->Points.GiveBack(c);
    }
  }
  return count;
}

void BlockPoints::Retire(ServedBlock& served, int target) noexcept
{
  const bool enough =
    served.replaced > 0 && served.fresh >= std::min(target, served.replaced) && served.fresh > 0;
  const bool tooMany = served.fresh > target + 1 + target / 8;
  if (!enough && !tooMany)
    return;
  served.settled = false;
  std::int32_t oldest = PointRing::None;
  for (std::int32_t c = served.newest; c != PointRing::None; c = this->Points[c].next)
  {
    PointRing::Chunk& chunk = this->Points[c];
    if (chunk.leaving)
      continue;
    if (chunk.replaced && enough)
      chunk.leaving = true;
    else if (!chunk.replaced)
      oldest = c;
  }
  served.replaced = enough ? 0 : served.replaced;
  if (tooMany && oldest != PointRing::None)
  {
    this->Points[oldest].leaving = true;
    --served.fresh;
  }
}

void BlockPoints::Blend(ServedBlock& served) noexcept
{
  if (served.surface->HasCells())
  {
    const double off = served.area - served.shown;
    served.shown += std::clamp(off, -served.step, served.step);
  }
  const float step = 1.0F / static_cast<float>(this->BlendTicks);
  served.settled = served.shown == served.area;
  served.points = 0;
  double shares = 0.0;
  std::int32_t* link = &served.newest;
  while (*link != PointRing::None)
  {
    const std::int32_t c = *link;
    PointRing::Chunk& chunk = this->Points[c];
    chunk.fade = std::min(chunk.fade + (chunk.leaving ? -step : step), 1.0F);
    if (chunk.fade > 0.5F * step)
    {
      shares += chunk.fade * chunk.alive;
      served.points += chunk.alive;
      served.settled = served.settled && chunk.fade == 1.0F;
      link = &chunk.next;
      continue;
    }
    *link = chunk.next;
    this->Points.GiveBack(c);
  }
  for (std::int32_t c = served.newest; c != PointRing::None; c = this->Points[c].next)
    this->Points.SetArea(c, static_cast<float>(served.shown * this->Points[c].fade / shares));
}

void BlockPoints::GiveBack(ServedBlock& served) noexcept
{
  for (std::int32_t c = served.newest; c != PointRing::None;)
  {
    const std::int32_t next = this->Points[c].next;
    this->Points.GiveBack(c);
    c = next;
  }
  served.newest = PointRing::None;
  served.fresh = served.replaced = 0;
  served.drawn = served.points = 0;
  served.area = served.shown = served.step = 0.0;
  served.used = false;
}

} // namespace hasp
