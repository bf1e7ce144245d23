#include "Haptics/BlockPoints.h"
#include "Haptics/Hash.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

BlockPoints::BlockPoints(const GridGeometry& geometry, const glm::dvec3& origin,
  std::uint32_t points, int blendTicks, std::uint32_t seed)
  : Geometry(geometry),
    Origin(origin),
    BlendTicks(blendTicks),
    Seed(seed),
    Points(points)
{
}

void BlockPoints::Measure(ServedBlock& served) const noexcept
{
  served.settled = false;
  served.surface->FindCells();
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
  const glm::dvec3 first = served.block * MinMaxBlocks::Side;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    const std::uint64_t number = 2 * (std::uint64_t(served.drawn) * PointRing::ChunkPoints + n) + 1;
    BlockSurface::Place place;
    if (!served.surface->Draw((n + shift - std::floor(shift)) / PointRing::ChunkPoints,
          UnitHash(seed, number), UnitHash(seed, number + 1), place))
      continue;
    this->Points.SetPoint(c, n, this->Geometry.IndexToWorld(first + place.index) - this->Origin,
      this->Geometry.direction * place.normal);
    ++chunk.alive;
  }
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
  const glm::dvec3 most =
    glm::min(glm::dvec3(MinMaxBlocks::Side), glm::dvec3(this->Geometry.Cells()) - first);
  chunk.alive = 0;
  chunk.moved = chunk.replaced = true;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    if (!this->Points.Alive(c, n))
      continue;
    const glm::dvec3 world = this->Origin + glm::dvec3(this->Points.Position(c, n));
    BlockSurface::Place place{
      glm::clamp(this->Geometry.WorldToIndex(world) - first, glm::dvec3(0.0), most), {}
    };
    if (served.surface->Project(place))
    {
      this->Points.SetPoint(c, n, this->Geometry.IndexToWorld(first + place.index) - this->Origin,
        this->Geometry.direction * place.normal);
      ++chunk.alive;
    }
    else
      this->Points.Kill(c, n);
  }
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
