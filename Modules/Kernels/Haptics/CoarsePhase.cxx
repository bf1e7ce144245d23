#include "Haptics/CoarsePhase.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{

/// Distance in mm at an index position within [0, last].
double ReadDistance(const DistanceMapView<std::int16_t>& view, const glm::dvec3& index) noexcept
{
  const glm::ivec3 cell = glm::min(glm::ivec3(index), glm::ivec3(view.last) - 1);
  const glm::dvec3 t = index - glm::dvec3(cell);
  const glm::ivec3 block = cell / view.Side, in = cell - block * view.Side;
  const int b = (block.z * view.blocks.y + block.y) * view.blocks.x + block.x;
  const std::int16_t* p =
    view.samples + view.firstSample[b] + (in.z * view.Row + in.y) * view.Row + in.x;
  const auto along = [&](int offset) { return p[offset] + t.x * (p[offset + 1] - p[offset]); };
  const auto across = [&](int offset)
  {
    const double low = along(offset);
    return low + t.y * (along(offset + view.Row) - low);
  };
  const double low = across(0);
  const double mm = (low + t.z * (across(view.Slice) - low)) * view.mmPerStep;
  return std::max<double>(mm, view.unclamped[b].min); // farther than the range, say
}

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
    Map(std::move(map)),
    View(this->Map->View()),
    Spacing(this->Map->Geometry().spacing)
{
  this->PerSlope = 1.0 / std::max<double>(this->View.steepest, 1e-6); // 0: no surface at all
  // The kernels place points with floats: a hundredth of a voxel holds for grids of 10,000 samples.
  // And a distance is rounded to half a step.
  this->MarginMm = 0.01 * this->Map->SmallestSpacing() + this->View.mmPerStep;
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
  this->Travelled = 0.0;
  std::fill(this->States.begin(), this->States.end(), State());
  for (Level& level : this->Levels)
    level.allFarUntil = 0.0;
}

void CoarsePhase::Begin(const RigidPose& shellInMap, double reachMm) noexcept
{
  // A turn by an angle moves a point at radius r by 2 r sin(angle / 2).
  const glm::dquat turn = shellInMap.orientation * glm::conjugate(this->Pose.orientation);
  const double moved =
    glm::length(shellInMap.position - this->Pose.position) +
    2.0 * this->Shell->Radius() * glm::length(glm::dvec3(turn.x, turn.y, turn.z));
  // Another reach is as if all had come nearer, or gone farther.
  this->Travelled += moved + std::abs(reachMm - this->ReachMm) * this->PerSlope;
  if (!(this->Travelled < 1e12)) // not finite; or digits get short
    this->WakeAll();
  this->Pose = shellInMap;
  this->ReachMm = reachMm;
  const glm::dmat3 toIndex(this->View.toIndex);
  this->ShellToIndex = toIndex * glm::mat3_cast(shellInMap.orientation);
  this->IndexOfShell = toIndex * shellInMap.position + glm::dvec3(this->View.indexOfOrigin);
  this->Seen = {};
}

double CoarsePhase::Slack(const PointCluster& cluster) const noexcept
{
  const glm::dvec3 index = this->ShellToIndex * glm::dvec3(cluster.center) + this->IndexOfShell;
  if (!std::isfinite(index.x + index.y + index.z))
    return 0.0;
  // From the grid's nearest point the way to any other is at least as long by Pythagoras, for a box
  // is convex; outside of the grid there is nothing to touch.
  const glm::dvec3 nearest = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(this->View.last));
  const double gap = glm::length((index - nearest) * this->Spacing);
  const double above = ReadDistance(this->View, nearest) - this->ReachMm - this->MarginMm;
  const double way = std::max(above, 0.0) * this->PerSlope;
  return std::sqrt(way * way + gap * gap) - cluster.radius - this->MarginMm;
}

std::span<const ContactPoints> CoarsePhase::Near(int level) noexcept
{
  Level& its = this->Levels[level];
  const std::span<const PointCluster> clusters = this->Shell->Clusters(level);
  if (this->Travelled < its.allFarUntil)
  {
    this->Seen.far += static_cast<std::uint32_t>(clusters.size());
    return {};
  }
  const ContactPoints all = this->Shell->Level(level);
  ContactPoints* const runs = &this->Runs[its.first];
  State* const states = &this->States[its.first];
  std::size_t count = 0, lastNear = clusters.size();
  std::uint32_t near = 0;
  double allFarUntil = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    if (!(this->Travelled < states[c].until))
    {
      const double slack = this->Slack(clusters[c]);
      states[c] = { this->Travelled + std::abs(slack), !(slack > 0.0) };
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
  its.allFarUntil = allFarUntil;
  return { runs, count };
}

std::size_t CoarsePhase::Bytes() const noexcept
{
  return this->States.size() * sizeof(State) + this->Runs.size() * sizeof(ContactPoints) +
         this->Levels.size() * sizeof(Level);
}

} // namespace hasp
