#include "Haptics/CoarsePhase.h"

#include <algorithm>
#include <limits>

namespace hasp
{

namespace
{

ContactPoints Part(const ContactPoints& all, const PointCluster& cluster) noexcept
{
  const std::uint32_t n = cluster.first;
  return { all.x + n, all.y + n, all.z + n, all.nx + n, all.ny + n, all.nz + n,
    all.areas == nullptr ? nullptr : all.areas + n, all.area, cluster.count };
}

} // namespace

CoarsePhase::CoarsePhase(
  std::shared_ptr<const PointShell> shell, std::shared_ptr<const DistanceMap> map)
  : Shell(std::move(shell)),
    Clearance(std::move(map), this->Shell->Radius())
{
  std::uint32_t clusters = 0;
  for (int level = 0; level < this->Shell->Levels(); ++level)
  {
    this->Levels.push_back({ clusters, 0.0 });
    clusters += static_cast<std::uint32_t>(this->Shell->Clusters(level).size());
  }
  this->States.resize(clusters);
  this->Runs.resize(clusters);
}

void CoarsePhase::WakeAll() noexcept
{
  this->Clearance.Forget();
  std::fill(this->States.begin(), this->States.end(), MapClearance::State());
  for (Level& level : this->Levels)
    level.allFarUntil = 0.0;
}

void CoarsePhase::Begin(const RigidPose& shellInMap, double reachMm) noexcept
{
  if (!this->Clearance.Begin(shellInMap, reachMm))
    this->WakeAll();
  this->Seen = {};
}

std::span<const ContactPoints> CoarsePhase::Near(int level) noexcept
{
  Level& its = this->Levels[level];
  const std::span<const PointCluster> clusters = this->Shell->Clusters(level);
  const double travelled = this->Clearance.Travelled();
  if (travelled < its.allFarUntil)
  {
    this->Seen.far += static_cast<std::uint32_t>(clusters.size());
    this->Seen.clearanceMm = std::min(this->Seen.clearanceMm, its.allFarUntil - travelled);
    return {};
  }
  const ContactPoints all = this->Shell->Level(level);
  ContactPoints* const runs = &this->Runs[its.first];
  MapClearance::State* const states = &this->States[its.first];
  std::size_t count = 0, lastNear = clusters.size();
  std::uint32_t near = 0;
  double allFarUntil = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    if (!(travelled < states[c].until))
    {
      states[c] = this->Clearance.Look(clusters[c].center, clusters[c].radius);
      ++this->Seen.looked;
    }
    allFarUntil = std::min(allFarUntil, states[c].near ? 0.0 : states[c].until);
    if (!states[c].near)
      continue;
    ++near;
    if (lastNear + 1 == c)
      runs[count - 1].count += clusters[c].count;
    else
      runs[count++] = Part(all, clusters[c]);
    lastNear = c;
  }
  this->Seen.near += near;
  this->Seen.far += static_cast<std::uint32_t>(clusters.size()) - near;
  this->Seen.clearanceMm = std::min(this->Seen.clearanceMm, std::max(allFarUntil - travelled, 0.0));
  its.allFarUntil = allFarUntil;
  return { runs, count };
}

std::size_t CoarsePhase::Bytes() const noexcept
{
  return this->States.size() * sizeof(MapClearance::State) +
         this->Runs.size() * sizeof(ContactPoints) + this->Levels.size() * sizeof(Level);
}

} // namespace hasp
