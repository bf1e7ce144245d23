#include "Haptics/DynamicPointShell.h"
#include "Haptics/BlockSurface.h"
#include "Haptics/Hash.h"
#include "Haptics/NearBlocks.h"
#include "Haptics/PointRing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{

/// What it takes to measure a block, in points that could be drawn instead.
constexpr int BlockCost = 40;
constexpr std::uint32_t PointsPerBlock = 32; ///< of the ring's room, for each block it may serve

void Check(
  const ShellVolume& volume, const glm::dvec3& origin, const DynamicPointShellSettings& settings)
{
  const auto refuse = [](const std::string& what)
  { throw std::invalid_argument("DynamicPointShell: " + what); };
  const GridGeometry& g = GeometryOf(volume.grid);
  g.Validate();
  const glm::ivec3 cells = g.Cells();
  if (std::min({ cells.x, cells.y, cells.z }) < 1)
    refuse("the volume must have at least 2 samples on each axis");
  if (!volume.blocks ||
      volume.blocks->Blocks() != (cells + MinMaxBlocks::Side - 1) / MinMaxBlocks::Side)
    refuse("the blocks are not of this volume");
  if (!std::isfinite(origin.x + origin.y + origin.z))
    refuse("the body's origin must be finite");
  if (settings.points < 512 || settings.points > 1 << 20)
    refuse("room for " + std::to_string(settings.points) + " points; must be in [512, 1048576]");
  if (settings.pointsPerTick < 64 || settings.pointsPerTick > settings.points)
    refuse(std::to_string(settings.pointsPerTick) + " points a tick; must be in [64, " +
           std::to_string(settings.points) + "]");
  if (!(settings.spacingMm >= 0.0 && std::isfinite(settings.spacingMm)))
    refuse("a spacing of " + std::to_string(settings.spacingMm) + " mm; must be >= 0");
  if (!(settings.marginMm >= 0.0 && std::isfinite(settings.marginMm)))
    refuse("a margin of " + std::to_string(settings.marginMm) + " mm; must be >= 0");
  if (settings.blendTicks < 5 || settings.blendTicks > 100)
    refuse(std::to_string(settings.blendTicks) + " ticks of blending; must be in [5, 100]");
}

} // namespace

struct DynamicPointShell::Internals
{
  /// A block that has points, or is about to.
  struct Served
  {
    BlockSurface* surface = nullptr; ///< apart, for it is large
    double area = 0.0;               ///< of the surface, once it is measured
    glm::ivec3 block{ 0 };
    bool used = false, near = false;
    std::int32_t newest = PointRing::None; ///< of its chunks
    int fresh = 0, replaced = 0;           ///< chunks that are not leaving
    std::uint32_t drawn = 0;               ///< chunks so far
    double shown = 0.0;                    ///< area that its points have together now, mm^2
    double step = 0.0;                     ///< that it comes nearer to the surface's each tick
    bool settled = false;                  ///< nothing fades
    std::uint32_t points = 0;
    MapClearance::State hot; ///< may it touch, and not only soon?
  };
  struct Waiting
  {
    double mm; ///< of the block's middle from the other body
    glm::ivec3 block;
  };

  Internals(ShellVolume v, std::shared_ptr<const DistanceMap> map, const glm::dvec3& o,
    const DynamicPointShellSettings& s);

  bool Holds(const MinMaxBlocks::Range& range) const noexcept;
  void MoveToIsovalue() noexcept;
  int MoveChunks(Served& served, int most, int left) noexcept;
  bool MoveChunk(Served& served, std::int32_t chunk) noexcept;
  void FindNear() noexcept;
  void SeeNear(Served& served) noexcept;
  void ServeBlocks() noexcept;
  void Measure(Served& served) noexcept;
  void DrawPoints() noexcept;
  bool DrawChunk(Served& served) noexcept;
  int TargetOf(const Served& served) const noexcept;
  void Retire(Served& served) noexcept;
  void Blend(Served& served) noexcept;
  void GiveUp(Served& served) noexcept;

  ShellVolume volume;
  GridGeometry geometry;
  glm::dvec3 origin;
  DynamicPointShellSettings settings;
  double rangeMm, wantedIsovalue;
  std::shared_ptr<const DistanceMap> map;
  NearBlocks nearBlocks;
  MapClearance clearance;
  PointRing ring;
  std::vector<BlockSurface> surfaces;
  std::vector<Served> all;
  std::vector<std::int32_t> servedAt; ///< by block; None if not served
  std::vector<Waiting> waiting;
  double chunksPerMm2 = 0.0;
  double voxel = 1.0;                  ///< the smallest spacing, mm
  double reachMm = 0.0, aheadMm = 0.0; ///< and the margin that is added to it
  int budget = 0;
  std::size_t turn = 0; ///< whose turn it is to be drawn on first
  Facts facts;
};

DynamicPointShell::Internals::Internals(ShellVolume v, std::shared_ptr<const DistanceMap> m,
  const glm::dvec3& o, const DynamicPointShellSettings& s)
  : volume(std::move(v)),
    geometry(GeometryOf(this->volume.grid)),
    origin(o),
    settings(s),
    rangeMm(m->RangeMm()),
    wantedIsovalue(this->volume.isovalue),
    map(std::move(m)),
    nearBlocks(this->volume.blocks, this->geometry, o),
    clearance(this->map, this->nearBlocks.Radius()),
    ring(static_cast<std::uint32_t>(s.points)),
    surfaces(this->ring.Chunks() * PointRing::ChunkPoints / PointsPerBlock),
    all(this->surfaces.size()),
    servedAt(this->volume.blocks->Count(), PointRing::None)
{
  const glm::dvec3 spacing = this->geometry.spacing;
  this->voxel = std::min({ spacing.x, spacing.y, spacing.z });
  if (this->settings.spacingMm == 0.0)
    this->settings.spacingMm = 0.4 * this->voxel;
  if (this->settings.marginMm == 0.0)
    this->settings.marginMm = 4.0 * this->voxel;
  for (std::size_t n = 0; n < this->all.size(); ++n)
    this->all[n].surface = &this->surfaces[n];
  this->waiting.reserve(4 * this->all.size());
}

/// Could a block whose samples have this range hold a piece of the surface?
bool DynamicPointShell::Internals::Holds(const MinMaxBlocks::Range& range) const noexcept
{
  const double iso = this->volume.isovalue;
  return this->volume.insideAbove ? range.min < iso && iso <= range.max
                                  : range.min <= iso && iso < range.max;
}

void DynamicPointShell::Internals::GiveUp(Served& served) noexcept
{
  for (std::int32_t c = served.newest; c != PointRing::None;)
  {
    const std::int32_t next = this->ring[c].next;
    this->ring.GiveBack(c);
    c = next;
  }
  this->servedAt[this->nearBlocks.IndexOf(served.block)] = PointRing::None;
  served.newest = PointRing::None;
  served.fresh = served.replaced = 0;
  served.drawn = 0;
  served.area = served.shown = served.step = 0.0;
  served.used = false;
}

bool DynamicPointShell::Internals::MoveChunk(Served& served, std::int32_t c) noexcept
{
  PointRing::Chunk& chunk = this->ring[c];
  const glm::dvec3 first = served.block * MinMaxBlocks::Side;
  const glm::dvec3 most =
    glm::min(glm::dvec3(MinMaxBlocks::Side), glm::dvec3(this->geometry.Cells()) - first);
  chunk.alive = 0;
  chunk.moved = chunk.replaced = true;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
  {
    if (!this->ring.Alive(c, n))
      continue;
    const glm::dvec3 world = this->origin + glm::dvec3(this->ring.Position(c, n));
    BlockSurface::Place place{
      glm::clamp(this->geometry.WorldToIndex(world) - first, glm::dvec3(0.0), most), {}
    };
    if (served.surface->Project(place))
    {
      this->ring.SetPoint(c, n, this->geometry.IndexToWorld(first + place.index) - this->origin,
        this->geometry.direction * place.normal);
      ++chunk.alive;
    }
    else
      this->ring.Kill(c, n);
  }
  this->facts.projected += chunk.alive;
  return chunk.alive > 0;
}

/// Each block's newest chunk first, where it may touch before elsewhere; then the others as far as
/// it goes.
void DynamicPointShell::Internals::MoveToIsovalue() noexcept
{
  this->volume.isovalue = this->wantedIsovalue;
  int left = 2 * this->settings.pointsPerTick;
  for (Served& served : this->all)
  {
    if (!served.used)
      continue;
    const std::size_t block = this->nearBlocks.IndexOf(served.block);
    if (!this->Holds(this->volume.blocks->Data()[block]))
    {
      this->GiveUp(served);
      continue;
    }
    served.surface->SetIsovalue(this->volume.isovalue, this->volume.insideAbove ? -1.0 : 1.0);
    served.fresh = served.replaced = 0;
    served.settled = false;
    for (std::int32_t c = served.newest; c != PointRing::None; c = this->ring[c].next)
      this->ring[c].moved = false;
  }
  for (const bool hot : { true, false })
    for (Served& served : this->all)
      if (served.used && served.hot.near == hot)
        left = this->MoveChunks(served, 1, left);
  for (Served& served : this->all)
    if (served.used)
      left = this->MoveChunks(served, static_cast<int>(this->ring.Chunks()), left);
}

/// Moves chunks that have not been moved yet, the newest first, until `most` are: those that cannot
/// be moved go, and the rest with them if `most` is all. Returns the points that may still be
/// moved.
int DynamicPointShell::Internals::MoveChunks(Served& served, int most, int left) noexcept
{
  std::int32_t* link = &served.newest;
  while (*link != PointRing::None && most > 0)
  {
    const std::int32_t c = *link;
    const bool before = this->ring[c].moved;
    const bool moved = before || (left > 0 && this->MoveChunk(served, c));
    left -= before ? 0 : PointRing::ChunkPoints;
    most -= moved ? 1 : 0;
    served.replaced += moved && !before && !this->ring[c].leaving ? 1 : 0;
    if (moved)
      link = &this->ring[c].next;
    else
    {
      *link = this->ring[c].next;
      this->ring.GiveBack(c);
    }
  }
  return left;
}

void DynamicPointShell::Internals::FindNear() noexcept
{
  for (Served& served : this->all)
    served.near = false;
  this->waiting.clear();
  this->facts.nearBlocks = 0;
  this->nearBlocks.ForEach(
    this->clearance, [this](const MinMaxBlocks::Range& range) { return this->Holds(range); },
    [this](const glm::ivec3& block)
    {
      ++this->facts.nearBlocks;
      const std::int32_t at = this->servedAt[this->nearBlocks.IndexOf(block)];
      if (at != PointRing::None)
        this->SeeNear(this->all[at]);
      else if (this->waiting.size() < this->waiting.capacity())
        this->waiting.push_back(
          { this->clearance.DistanceAt(this->nearBlocks.BallOf(block, 1).center), block });
    });
  for (Served& served : this->all)
    if (served.used && !served.near)
      this->GiveUp(served);
}

/// Points are kept ready in all near blocks, and many in those that may touch within a voxel's way:
/// as far as 16 points of the surface in the block can tell.
void DynamicPointShell::Internals::SeeNear(Served& served) noexcept
{
  served.near = true;
  if (this->clearance.Travelled() < served.hot.until)
    return;
  const std::int32_t c = served.newest;
  if (c == PointRing::None)
  {
    const NearBlocks::Ball ball = this->nearBlocks.BallOf(served.block, 1);
    served.hot = this->clearance.Look(ball.center, ball.radius + this->voxel, this->aheadMm);
    return;
  }
  double least = this->rangeMm;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
    if (this->ring.Alive(c, n))
      least = std::min(least, this->clearance.DistanceAt(this->ring.Position(c, n)));
  // Each point of the surface is within one and a half spacings of one of the 16.
  const double cover = 1.5 * std::sqrt(served.area / PointRing::ChunkPoints);
  const double slack = this->clearance.WayFor(least - this->reachMm) - cover - this->voxel;
  served.hot = { this->clearance.Travelled() + std::abs(slack), !(slack > 0.0) };
}

void DynamicPointShell::Internals::Measure(Served& served) noexcept
{
  served.settled = false;
  served.surface->FindCells();
  served.area = served.surface->Area();
  served.step = std::abs(served.area - served.shown) / this->settings.blendTicks;
  this->budget -= BlockCost;
}

/// Measures blocks that have another surface now, then new ones, the nearest first.
void DynamicPointShell::Internals::ServeBlocks() noexcept
{
  for (const bool hot : { true, false })
    for (Served& served : this->all)
      if (served.used && served.hot.near == hot && !served.surface->HasCells() &&
          this->budget >= BlockCost)
      {
        this->Measure(served);
        if (served.newest == PointRing::None)
          this->DrawChunk(served);
      }
  const auto count =
    std::min<std::size_t>(this->waiting.size(), std::max(this->budget, 0) / BlockCost);
  std::partial_sort(this->waiting.begin(),
    this->waiting.begin() + static_cast<std::ptrdiff_t>(count), this->waiting.end(),
    [](const Waiting& a, const Waiting& b) { return a.mm < b.mm; });
  std::size_t slot = 0;
  for (std::size_t n = 0; n < count && this->budget >= BlockCost; ++n)
  {
    while (slot < this->all.size() && this->all[slot].used)
      ++slot;
    if (slot == this->all.size())
      return;
    Served& served = this->all[slot];
    served.used = true;
    served.block = this->waiting[n].block;
    served.hot = {};
    this->SeeNear(served);
    this->servedAt[this->nearBlocks.IndexOf(served.block)] = static_cast<std::int32_t>(slot);
    served.surface->Read(this->volume.grid, served.block);
    served.surface->SetIsovalue(this->volume.isovalue, this->volume.insideAbove ? -1.0 : 1.0);
    this->Measure(served);
    this->DrawChunk(served);
  }
}

int DynamicPointShell::Internals::TargetOf(const Served& served) const noexcept
{
  if (!served.surface->HasCells() || !(served.area > 0.0))
    return 0;
  return served.hot.near ? std::max(1, static_cast<int>(served.area * this->chunksPerMm2)) : 1;
}

bool DynamicPointShell::Internals::DrawChunk(Served& served) noexcept
{
  const std::int32_t c = served.surface->Area() > 0.0 ? this->ring.Take() : PointRing::None;
  if (c == PointRing::None)
    return false;
  PointRing::Chunk& chunk = this->ring[c];
  const std::uint64_t block = this->nearBlocks.IndexOf(served.block);
  const std::uint64_t seed = HashOf(this->settings.seed, block);
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
    this->ring.SetPoint(c, n, this->geometry.IndexToWorld(first + place.index) - this->origin,
      this->geometry.direction * place.normal);
    ++chunk.alive;
  }
  this->facts.drawn += chunk.alive;
  this->budget -= PointRing::ChunkPoints;
  ++served.drawn;
  if (chunk.alive == 0)
  {
    this->ring.GiveBack(c);
    return false;
  }
  chunk.next = served.newest;
  served.newest = c;
  if (served.fresh++ == 0)
    served.hot.until = 0.0; // the points tell more than the block's ball
  served.settled = false;
  return true;
}

/// Blocks with few chunks first: all get one before one gets a second, all two before four.
void DynamicPointShell::Internals::DrawPoints() noexcept
{
  double area = 0.0;
  for (const Served& served : this->all)
    area += served.used && served.hot.near ? served.area : 0.0;
  const double densest =
    1.0 / (PointRing::ChunkPoints * this->settings.spacingMm * this->settings.spacingMm);
  this->chunksPerMm2 = area > 0.0 ? std::min(densest, 0.6 * this->ring.Chunks() / area) : 0.0;
  bool more = true;
  for (int level = 1; more && this->budget > 0; level *= 2)
  {
    more = false;
    for (std::size_t n = 0; n < this->all.size() && this->budget > 0; ++n)
    {
      Served& served = this->all[this->turn];
      if (served.used)
      {
        const int target = this->TargetOf(served);
        while (served.fresh < std::min(level, target) && this->budget > 0)
          if (!this->DrawChunk(served))
            break;
        more = more || served.fresh < target;
      }
      this->turn = (this->turn + 1) % this->all.size();
    }
    if (this->ring.Used() == this->ring.Chunks())
      more = false;
  }
}

/// Chunks that are too many leave, one a tick, the oldest first; those of another surface as soon
/// as there are as many new ones.
void DynamicPointShell::Internals::Retire(Served& served) noexcept
{
  const int target = this->TargetOf(served);
  const bool enough =
    served.replaced > 0 && served.fresh >= std::min(target, served.replaced) && served.fresh > 0;
  const bool tooMany = served.fresh > target + 1 + target / 8;
  if (!enough && !tooMany)
    return;
  served.settled = false;
  std::int32_t oldest = PointRing::None;
  for (std::int32_t c = served.newest; c != PointRing::None; c = this->ring[c].next)
  {
    PointRing::Chunk& chunk = this->ring[c];
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
    this->ring[oldest].leaving = true;
    --served.fresh;
  }
}

/// Fades chunks in and out, and shares the block's area among its points.
void DynamicPointShell::Internals::Blend(Served& served) noexcept
{
  if (served.surface->HasCells())
  {
    const double off = served.area - served.shown;
    served.shown += std::clamp(off, -served.step, served.step);
  }
  const float step = 1.0F / static_cast<float>(this->settings.blendTicks);
  served.settled = served.shown == served.area;
  served.points = 0;
  double shares = 0.0;
  std::int32_t* link = &served.newest;
  while (*link != PointRing::None)
  {
    const std::int32_t c = *link;
    PointRing::Chunk& chunk = this->ring[c];
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
    this->ring.GiveBack(c);
  }
  for (std::int32_t c = served.newest; c != PointRing::None; c = this->ring[c].next)
    this->ring.SetArea(c, static_cast<float>(served.shown * this->ring[c].fade / shares));
}

DynamicPointShell::DynamicPointShell(ShellVolume volume, std::shared_ptr<const DistanceMap> map,
  const glm::dvec3& origin, const DynamicPointShellSettings& settings)
{
  Check(volume, origin, settings);
  if (!map)
    throw std::invalid_argument("DynamicPointShell: there must be a distance map to touch");
  this->Inside = std::make_unique<Internals>(std::move(volume), std::move(map), origin, settings);
}

DynamicPointShell::~DynamicPointShell() = default;

void DynamicPointShell::SetIsovalue(double isovalue) noexcept
{
  this->Inside->wantedIsovalue = isovalue;
}

double DynamicPointShell::Isovalue() const noexcept
{
  return this->Inside->wantedIsovalue;
}

void DynamicPointShell::Update(const RigidPose& bodyInMap, double reachMm) noexcept
{
  Internals& in = *this->Inside;
  in.facts = { 0, 0, 0, in.facts.nearBlocks, 0, 0.0 };
  const bool none = std::isnan(in.wantedIsovalue) && std::isnan(in.volume.isovalue);
  if (in.wantedIsovalue != in.volume.isovalue && !none)
    in.MoveToIsovalue();
  in.reachMm = std::clamp(reachMm, 0.0, in.rangeMm);
  in.aheadMm = std::min(in.settings.marginMm, in.rangeMm - in.reachMm);
  const bool known = in.clearance.Begin(bodyInMap, in.reachMm + in.aheadMm);
  if (!known)
  {
    in.nearBlocks.Forget();
    for (Internals::Served& served : in.all)
      served.hot = {};
  }
  const double pose = glm::dot(bodyInMap.position, bodyInMap.position) +
                      glm::dot(bodyInMap.orientation, bodyInMap.orientation);
  if (std::isfinite(pose))
  {
    in.budget = in.settings.pointsPerTick;
    in.FindNear();
    in.ServeBlocks();
    in.DrawPoints();
    for (Internals::Served& served : in.all)
      if (served.used)
        in.Retire(served);
  }
  for (Internals::Served& served : in.all)
  {
    if (!served.used)
      continue;
    if (!served.settled)
      in.Blend(served);
    in.facts.points += served.points;
    in.facts.servedBlocks += served.points > 0 ? 1 : 0;
    in.facts.areaMm2 += served.points > 0 ? served.shown : 0.0;
  }
}

ContactPoints DynamicPointShell::Points() const noexcept
{
  return this->Inside->ring.Points();
}

const DynamicPointShell::Facts& DynamicPointShell::LastTick() const noexcept
{
  return this->Inside->facts;
}

void DynamicPointShell::ListResources(ResourceList& list) const
{
  const Internals& in = *this->Inside;
  list.push_back({ "dynamic point shell",
    in.ring.Bytes() + in.nearBlocks.Bytes() +
      in.all.size() * (sizeof(Internals::Served) + sizeof(BlockSurface)) +
      in.servedAt.size() * sizeof(std::int32_t) +
      in.waiting.capacity() * sizeof(Internals::Waiting),
    0.0, "a body to touch with, without preparation" });
}

} // namespace hasp
