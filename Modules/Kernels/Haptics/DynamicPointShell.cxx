#include "Haptics/DynamicPointShell.h"
#include "Haptics/BlockPoints.h"
#include "Haptics/NearBlocks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
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
  struct Waiting
  {
    double mm; ///< of the block's middle from the other body
    glm::ivec3 block;
  };
  static bool Nearer(const Waiting& a, const Waiting& b) noexcept { return a.mm < b.mm; }

  Internals(ShellVolume v, std::shared_ptr<const DistanceMap> map, const glm::dvec3& o,
    const DynamicPointShellSettings& s);

  std::span<ServedBlock> Live() noexcept { return { this->all.data(), this->end }; }
  /// Could a block whose samples have this range hold a piece of the surface? Here and without a
  /// branch, for it is asked about thousands in a tick.
  auto Holds() const noexcept
  {
    const double iso = this->volume.isovalue; // inside may be "above or at", or "below or at"
    const double first =
      this->volume.insideAbove ? iso : std::nextafter(iso, std::numeric_limits<double>::infinity());
    return [first](const MinMaxBlocks::Range& range)
    { return static_cast<int>(range.min < first) & static_cast<int>(first <= range.max); };
  }
  void MoveToIsovalue() noexcept;
  void FindNear() noexcept;
  void Await(const glm::ivec3& block) noexcept;
  void SeeNear(ServedBlock& served) noexcept;
  MapClearance::State LookFor(const glm::ivec3& block) const noexcept;
  void ServeBlocks() noexcept;
  std::int32_t FreeSlot(const glm::ivec3& block) noexcept;
  void DrawPoints() noexcept;
  bool Draw(ServedBlock& served) noexcept;
  void Measure(ServedBlock& served) noexcept;
  int TargetOf(const ServedBlock& served) const noexcept;
  void GiveUp(ServedBlock& served) noexcept;

  ShellVolume volume;
  GridGeometry geometry;
  glm::dvec3 origin;
  DynamicPointShellSettings settings;
  double rangeMm, wantedIsovalue;
  std::shared_ptr<const DistanceMap> map;
  NearBlocks nearBlocks;
  MapClearance clearance;
  BlockPoints points;
  std::vector<BlockSurface> surfaces;
  std::vector<ServedBlock> all;
  std::size_t end = 0;                ///< one past the last of them that is used
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
    points(this->geometry, o, static_cast<std::uint32_t>(s.points), s.blendTicks, s.seed),
    surfaces(this->points.Ring().Chunks() * PointRing::ChunkPoints / PointsPerBlock),
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

/// Each block's newest chunk first, where it may touch before elsewhere; then the others as far as
/// it goes.
void DynamicPointShell::Internals::MoveToIsovalue() noexcept
{
  this->volume.isovalue = this->wantedIsovalue;
  int left = 2 * this->settings.pointsPerTick;
  const auto holds = this->Holds();
  for (ServedBlock& served : this->Live())
  {
    if (!served.used)
      continue;
    if (holds(this->volume.blocks->Data()[served.number]))
      this->points.SetIsovalue(served, this->volume.isovalue, this->volume.insideAbove);
    else
      this->GiveUp(served);
  }
  for (const bool hot : { true, false })
    for (ServedBlock& served : this->Live())
      if (served.used && served.hot.near == hot)
        this->facts.projected += this->points.Move(served, 1, left);
  for (ServedBlock& served : this->Live())
    if (served.used)
      this->facts.projected += this->points.Move(served, this->settings.points, left);
}

void DynamicPointShell::Internals::GiveUp(ServedBlock& served) noexcept
{
  this->servedAt[served.number] = PointRing::None;
  this->points.GiveBack(served);
  while (this->end > 0 && !this->all[this->end - 1].used)
    --this->end;
}

/// Onto the list of those that are near and not served. When it is full the farther half goes: no
/// tick serves as many.
void DynamicPointShell::Internals::Await(const glm::ivec3& block) noexcept
{
  if (this->waiting.size() == this->waiting.capacity())
  {
    const auto middle =
      this->waiting.begin() + static_cast<std::ptrdiff_t>(this->waiting.size() / 2);
    std::nth_element(this->waiting.begin(), middle, this->waiting.end(), Nearer);
    this->waiting.erase(middle, this->waiting.end());
  }
  this->waiting.push_back(
    { this->clearance.DistanceAt(this->nearBlocks.BallOf(block, 1).center), block });
}

void DynamicPointShell::Internals::FindNear() noexcept
{
  for (ServedBlock& served : this->Live())
    served.near = false;
  this->waiting.clear();
  this->facts.nearBlocks = 0;
  this->nearBlocks.ForEach(this->clearance, this->Holds(),
    [this](const glm::ivec3& block)
    {
      ++this->facts.nearBlocks;
      const std::int32_t at = this->servedAt[this->nearBlocks.IndexOf(block)];
      if (at != PointRing::None)
        this->SeeNear(this->all[at]);
      else
        this->Await(block);
    });
  for (ServedBlock& served : this->Live())
    if (served.used && !served.near)
      this->GiveUp(served);
}

/// May the block touch within a voxel's way? As far as its ball can tell.
MapClearance::State DynamicPointShell::Internals::LookFor(const glm::ivec3& block) const noexcept
{
  const NearBlocks::Ball ball = this->nearBlocks.BallOf(block, 1);
  return this->clearance.Look(ball.center, ball.radius + this->voxel, this->aheadMm);
}

/// Points are kept ready in all near blocks, and many in those that may touch within a voxel's way:
/// as far as 16 points of the surface in the block can tell.
void DynamicPointShell::Internals::SeeNear(ServedBlock& served) noexcept
{
  served.near = true;
  if (this->clearance.Travelled() < served.hot.until)
    return;
  const std::int32_t c = served.newest;
  if (c == PointRing::None)
  {
    served.hot = this->LookFor(served.block);
    return;
  }
  double least = this->rangeMm;
  for (std::uint32_t n = 0; n < PointRing::ChunkPoints; ++n)
    if (this->points.Ring().Alive(c, n))
      least = std::min(least, this->clearance.DistanceAt(this->points.Ring().Position(c, n)));
  // Each point of the surface is within one and a half spacings of one of the 16.
  const double cover = 1.5 * std::sqrt(served.area / PointRing::ChunkPoints);
  const double slack = this->clearance.WayFor(least - this->reachMm) - cover - this->voxel;
  served.hot = { this->clearance.Travelled() + std::abs(slack), !(slack > 0.0) };
}

void DynamicPointShell::Internals::Measure(ServedBlock& served) noexcept
{
  this->points.Measure(served);
  this->budget -= BlockCost;
}

bool DynamicPointShell::Internals::Draw(ServedBlock& served) noexcept
{
  const int drawn = this->points.Draw(served);
  this->facts.drawn += std::max(drawn, 0);
  this->budget -= drawn < 0 ? 0 : PointRing::ChunkPoints;
  return drawn > 0;
}

/// Measures blocks that have another surface now, then new ones, the nearest first.
void DynamicPointShell::Internals::ServeBlocks() noexcept
{
  for (const bool hot : { true, false })
    for (ServedBlock& served : this->Live())
      if (served.used && served.hot.near == hot && !served.surface->HasCells() &&
          this->budget >= BlockCost)
      {
        this->Measure(served);
        if (served.newest == PointRing::None)
          this->Draw(served);
      }
  const auto count =
    std::min<std::size_t>(this->waiting.size(), std::max(this->budget, 0) / BlockCost);
  std::partial_sort(this->waiting.begin(),
    this->waiting.begin() + static_cast<std::ptrdiff_t>(count), this->waiting.end(), Nearer);
  if (count > 0)
    BlockSurface::Prefetch(this->volume.grid, this->waiting[0].block);
  for (std::size_t n = 0; n < count && this->budget >= BlockCost; ++n)
  {
    if (n + 1 < count)
      BlockSurface::Prefetch(this->volume.grid, this->waiting[n + 1].block);
    const std::int32_t slot = this->FreeSlot(this->waiting[n].block);
    if (slot == PointRing::None)
      return;
    ServedBlock& served = this->all[slot];
    served.used = true;
    this->end = std::max(this->end, static_cast<std::size_t>(slot) + 1);
    served.block = this->waiting[n].block;
    served.number = this->nearBlocks.IndexOf(served.block);
    served.hot = {};
    this->SeeNear(served);
    this->servedAt[served.number] = slot;
    served.surface->Read(this->volume.grid, served.block);
    this->points.SetIsovalue(served, this->volume.isovalue, this->volume.insideAbove);
    this->Measure(served);
    this->Draw(served);
  }
}

/// One that is free, or is made free: by a block that will not touch soon, for one that may.
std::int32_t DynamicPointShell::Internals::FreeSlot(const glm::ivec3& block) noexcept
{
  std::int32_t cold = PointRing::None;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(this->all.size()); ++n)
    if (!this->all[n].used)
      return n;
    else if (!this->all[n].hot.near)
      cold = n;
  if (cold == PointRing::None || !this->LookFor(block).near)
    return PointRing::None;
  this->GiveUp(this->all[cold]);
  return cold;
}

int DynamicPointShell::Internals::TargetOf(const ServedBlock& served) const noexcept
{
  if (!served.surface->HasCells() || !(served.area > 0.0))
    return 0;
  return served.hot.near ? std::max(1, static_cast<int>(served.area * this->chunksPerMm2)) : 1;
}

/// Blocks with few chunks first: all get one before one gets a second, all two before four.
void DynamicPointShell::Internals::DrawPoints() noexcept
{
  double area = 0.0;
  for (const ServedBlock& served : this->Live())
    area += served.used && served.hot.near ? served.area : 0.0;
  const double densest =
    1.0 / (PointRing::ChunkPoints * this->settings.spacingMm * this->settings.spacingMm);
  this->chunksPerMm2 =
    area > 0.0 ? std::min(densest, 0.6 * this->points.Ring().Chunks() / area) : 0.0;
  bool more = true;
  for (int level = 1; more && this->budget > 0; level *= 2)
  {
    more = false;
    for (std::size_t n = 0; n<this->end&& this->budget> 0; ++n)
    {
      this->turn = (this->turn + 1) % this->end;
      ServedBlock& served = this->all[this->turn];
      if (served.used)
      {
        const int target = this->TargetOf(served);
        while (served.fresh < std::min(level, target) && this->budget > 0)
          if (!this->Draw(served))
            break;
        more = more || served.fresh < target;
      }
    }
    if (this->points.Ring().Used() == this->points.Ring().Chunks())
      more = false;
  }
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
  const double reachBefore = in.reachMm;
  in.reachMm = std::clamp(reachMm, 0.0, in.rangeMm);
  in.aheadMm = std::min(in.settings.marginMm, in.rangeMm - in.reachMm);
  const bool known = in.clearance.Begin(bodyInMap, in.reachMm + in.aheadMm);
  if (!known)
    in.nearBlocks.Forget();
  if (!known || in.reachMm != reachBefore) // the clearance knows of reach and margin together
    for (ServedBlock& served : in.Live())
      served.hot = {};
  const double pose = glm::dot(bodyInMap.position, bodyInMap.position) +
                      glm::dot(bodyInMap.orientation, bodyInMap.orientation);
  if (std::isfinite(pose))
  {
    in.budget = in.settings.pointsPerTick;
    in.FindNear();
    in.ServeBlocks();
    in.DrawPoints();
    for (ServedBlock& served : in.Live())
      if (served.used)
        in.points.Retire(served, in.TargetOf(served));
  }
  for (ServedBlock& served : in.Live())
  {
    if (!served.used)
      continue;
    if (!served.settled)
      in.points.Blend(served);
    in.facts.points += served.points;
    in.facts.servedBlocks += served.points > 0 ? 1 : 0;
    in.facts.areaMm2 += served.points > 0 ? served.shown : 0.0;
  }
}

double DynamicPointShell::ClearanceMm(const RigidPose& bodyInMap) const noexcept
{
  const MapClearance& clearance = this->Inside->clearance;
  const double free = this->Inside->nearBlocks.NoneUntil() - clearance.Travelled();
  const double left = free - clearance.WayTo(bodyInMap);
  return left > 0.0 ? left : 0.0; // not a number: 0
}

ContactPoints DynamicPointShell::Points() const noexcept
{
  return this->Inside->points.Ring().Points();
}

const DynamicPointShell::Facts& DynamicPointShell::LastTick() const noexcept
{
  return this->Inside->facts;
}

void DynamicPointShell::ListResources(ResourceList& list) const
{
  const Internals& in = *this->Inside;
  list.push_back({ "dynamic point shell",
    in.points.Ring().Bytes() + in.nearBlocks.Bytes() +
      in.all.size() * (sizeof(ServedBlock) + sizeof(BlockSurface)) +
      in.servedAt.size() * sizeof(std::int32_t) +
      in.waiting.capacity() * sizeof(Internals::Waiting),
    0.0, "a body to touch with, without preparation" });
}

} // namespace hasp
