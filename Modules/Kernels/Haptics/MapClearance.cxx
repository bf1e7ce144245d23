#include "Haptics/MapClearance.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{

struct Reading
{
  double mm;
  float least; ///< of the block it lies in, not clamped
};

/// At an index position within [0, last].
Reading Read(const DistanceMapView<std::int16_t>& view, const glm::dvec3& index) noexcept
{
  const glm::ivec3 cell = glm::min(glm::ivec3(index), glm::ivec3(view.last) - 1);
  const glm::dvec3 t = index - glm::dvec3(cell);
  const glm::ivec3 block = cell / view.Side, in = cell - block * view.Side;
  const int b = (block.z * view.blocks.y + block.y) * view.blocks.x + block.x;
  const int offset = (in.z * view.Row + in.y) * view.Row + in.x;
  const std::int16_t* p = view.samples + view.firstSample[b] + offset;
  const auto along = [&](int offset) { return p[offset] + t.x * (p[offset + 1] - p[offset]); };
  const auto across = [&](int offset)
  {
    const double low = along(offset);
    return low + t.y * (along(offset + view.Row) - low);
  };
  const double low = across(0);
  return { (low + t.z * (across(view.Slice) - low)) * view.mmPerStep, view.unclamped[b].min };
}

} // namespace

MapClearance::MapClearance(std::shared_ptr<const DistanceMap> map, double radiusMm)
  : Map(std::move(map)),
    View(this->Map->View()),
    Spacing(this->Map->Geometry().spacing),
    Radius(radiusMm)
{
  this->PerSlope = 1.0 / std::max<double>(this->View.steepest, 1e-6); // 0: no surface at all
  // The kernels place points with floats: a hundredth of a voxel holds for grids of 10,000 samples.
  // And a distance is rounded to half a step.
  this->MarginMm = 0.01 * this->Map->SmallestSpacing() + this->View.mmPerStep;
}

double MapClearance::WayTo(const RigidPose& bodyInMap) const noexcept
{
  // A turn by an angle moves a point at radius r by 2 r sin(angle / 2).
  const glm::dquat turn = bodyInMap.orientation * glm::conjugate(this->Pose.orientation);
  return glm::length(bodyInMap.position - this->Pose.position) +
         2.0 * this->Radius * glm::length(glm::dvec3(turn.x, turn.y, turn.z));
}

bool MapClearance::Begin(const RigidPose& bodyInMap, double reachMm) noexcept
{
  // Another reach is as if all had come nearer, or gone farther.
  this->Way += this->WayTo(bodyInMap) + std::abs(reachMm - this->ReachMm) * this->PerSlope;
  const bool holds = this->Way < 1e12; // false for NaN; and beyond digits get short
  if (!holds)
    this->Forget();
  this->Pose = bodyInMap;
  this->ReachMm = reachMm;
  const glm::dmat3 toIndex(this->View.toIndex);
  this->ToIndex = toIndex * glm::mat3_cast(bodyInMap.orientation);
  this->IndexOfOrigin = toIndex * bodyInMap.position + glm::dvec3(this->View.indexOfOrigin);
  return holds;
}

double MapClearance::Slack(const glm::dvec3& center, double radius, double shorter) const noexcept
{
  const glm::dvec3 index = this->ToIndex * center + this->IndexOfOrigin;
  if (!std::isfinite(index.x + index.y + index.z))
    return 0.0;
  // From the grid's nearest point the way to any other is at least as long by Pythagoras, for a box
  // is convex; outside of the grid there is nothing to touch.
  const glm::dvec3 nearest = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(this->View.last));
  const double gap = glm::length((index - nearest) * this->Spacing);
  const Reading read = Read(this->View, nearest);
  const double above =
    std::max<double>(read.mm, read.least) - (this->ReachMm - shorter) - this->MarginMm;
  const double way = std::max(above, 0.0) * this->PerSlope;
  return std::sqrt(way * way + gap * gap) - radius - this->MarginMm;
}

double MapClearance::DistanceAt(const glm::dvec3& point) const noexcept
{
  const glm::dvec3 index = this->ToIndex * point + this->IndexOfOrigin;
  const bool inside = glm::all(glm::greaterThanEqual(index, glm::dvec3(0.0))) &&
                      glm::all(glm::lessThanEqual(index, glm::dvec3(this->View.last)));
  return inside ? Read(this->View, index).mm : this->View.rangeMm;
}

} // namespace hasp
