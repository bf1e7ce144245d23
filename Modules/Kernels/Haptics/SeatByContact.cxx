#include "Haptics/SeatByContact.h"
#include "Haptics/MapClearance.h"
#include "Haptics/VirtualCoupling.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{

constexpr double Never = std::numeric_limits<double>::infinity();
constexpr double FoundMm = 1e-3; ///< of way: how well a touch is found
constexpr double MostMm = 1000.0;

void CheckMm(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument("seat: " + std::string(name) + " is " + std::to_string(value) +
                                " mm; must be in [" + std::to_string(low) + ", " +
                                std::to_string(high) + "]");
}

void Check(const RigidPose& part, std::span<const HapticBody> bones, const SeatSettings& settings)
{
  if (const double length = glm::length(settings.withdrawal); !(std::abs(length - 1.0) <= 1e-3))
    throw std::invalid_argument("seat: the withdrawal direction is " + std::to_string(length) +
                                " long; must be 1 within 0.001");
  CheckMm("liftMm", settings.liftMm, 0.0, MostMm);
  CheckMm("pressMm", settings.pressMm, 0.0, MostMm);
  if (!std::isfinite(settings.touchMm))
    throw std::invalid_argument("seat: touchMm must be finite");
  if (!IsPose(part))
    throw std::invalid_argument("seat: the part has no pose");
  for (std::size_t n = 0; n < bones.size(); ++n)
  {
    const std::string name = "bones[" + std::to_string(n) + "]";
    if (!bones[n].map)
      throw std::invalid_argument("seat: " + name + " has no distance map; bake one first");
    if (!IsPose(bones[n].mapInWorld))
      throw std::invalid_argument("seat: " + name + " has no pose");
    if (const double range = bones[n].map->RangeMm(); !(std::abs(settings.touchMm) < range))
      throw std::invalid_argument("seat: touchMm is " + std::to_string(settings.touchMm) +
                                  " mm; must be within " + std::to_string(range) +
                                  ", as far as the map of " + name + " knows distances");
  }
}

RigidPose Unit(const RigidPose& pose)
{
  return { pose.position, glm::normalize(pose.orientation) };
}

/// The way of the part's points to one bone, in the part's axes: at `depth` mm beyond the planned
/// place a point p is at p + depth * Push.
class Way
{
public:
  Way(const HapticBody& bone, const RigidPose& part, double radius, const SeatSettings& settings)
    : Clearance(bone.map, radius),
      Push(glm::conjugate(part.orientation) * -glm::normalize(settings.withdrawal)),
      TouchMm(settings.touchMm),
      BeginMm(-settings.liftMm),
      LeastStepMm(bone.map->SmallestSpacing() / 8.0)
  {
    // Below 0 the reach would be in bone, of whose slopes nothing is known.
    this->Clearance.Begin(Unit(bone.mapInWorld).Inverse() * part, std::max(settings.touchMm, 0.0));
  }

  /// The depth up to which no point of a ball touches, if it is before `until`; else Never.
  double Nears(const PointCluster& ball, double until) const noexcept
  {
    double depth = this->BeginMm;
    while (depth <= until)
    {
      const double step =
        this->Clearance.Slack(glm::dvec3(ball.center) + depth * this->Push, ball.radius);
      if (!(step > this->LeastStepMm))
        return depth;
      depth += step;
    }
    return Never;
  }

  /// The depth at which a point touches first, from `from` to `until`; else Never.
  double Touches(const glm::dvec3& point, double from, double until) const noexcept
  {
    double before = from, depth = from;
    while (!this->TouchesAt(point, depth))
    {
      if (!(depth < until))
        return Never;
      before = depth;
      const double step = this->Clearance.Slack(point + depth * this->Push, 0.0);
      depth = std::min(depth + std::max(step, this->LeastStepMm), until);
    }
    while (depth - before > FoundMm)
    {
      const double middle = 0.5 * (before + depth);
      (this->TouchesAt(point, middle) ? depth : before) = middle;
    }
    return depth;
  }

private:
  bool TouchesAt(const glm::dvec3& point, double depth) const noexcept
  {
    return this->Clearance.DistanceAt(point + depth * this->Push) < this->TouchMm;
  }

  MapClearance Clearance;
  glm::dvec3 Push; ///< unit
  double TouchMm, BeginMm, LeastStepMm;
};

struct Touch
{
  double depth;
  glm::dvec3 point; ///< part's axes
  std::size_t bone;
};

/// The first touch, and those that are not too late after it.
class Touches
{
public:
  explicit Touches(double pressMm) : PressMm(pressMm) {}

  /// Later touches are of no matter.
  double Until() const noexcept
  {
    return std::min(this->PressMm, this->First.depth + Seat::TogetherMm);
  }
  void Add(const Touch& touch)
  {
    if (touch.depth < this->First.depth) // the first in order of those that are alike
      this->First = touch;
    this->Depths.push_back(touch.depth);
  }

  Seat Told(const RigidPose& part, const glm::dvec3& withdrawal) const
  {
    Seat seat;
    seat.touched = this->First.depth < Never;
    seat.depthMm = seat.touched ? this->First.depth : this->PressMm;
    if (!seat.touched)
      return seat;
    seat.seats = seat.depthMm >= 0.0;
    seat.partAt = part.Place(this->First.point);
    seat.boneAt = seat.partAt - seat.depthMm * withdrawal;
    seat.bone = this->First.bone;
    seat.points = static_cast<std::size_t>(std::count_if(this->Depths.begin(), this->Depths.end(),
      [&](double depth) { return depth <= this->First.depth + Seat::TogetherMm; }));
    return seat;
  }

private:
  double PressMm;
  Touch First{ Never, {}, 0 };
  std::vector<double> Depths;
};

/// Of a level's points those of one cluster.
void PushCluster(const Way& way, const ContactPoints& points, const PointCluster& cluster,
  std::size_t bone, Touches& touches)
{
  const double from = way.Nears(cluster, touches.Until());
  if (from == Never)
    return;
  for (std::uint32_t n = cluster.first; n < cluster.first + cluster.count; ++n)
  {
    if (points.x[n] == ContactPoints::FarAway) // fills the vector up
      break;
    const glm::dvec3 point(points.x[n], points.y[n], points.z[n]);
    if (const double depth = way.Touches(point, from, touches.Until()); depth < Never)
      touches.Add({ depth, point, bone });
  }
}

} // namespace

Seat SeatByContact(const PointShell& part, const RigidPose& partInWorld,
  std::span<const HapticBody> bones, const SeatSettings& settings, const ProgressFunction& progress)
{
  Check(partInWorld, bones, settings);
  const RigidPose pose = Unit(partInWorld);
  Touches touches(settings.pressMm);
  std::vector<Way> ways;
  for (const HapticBody& bone : bones)
    ways.emplace_back(bone, pose, part.Radius(), settings);
  // Coarse levels first: a few points all over the part soon say how far the others need to go.
  for (int level = 0; level < part.Levels(); ++level)
  {
    const ContactPoints points = part.Level(level);
    const std::span<const PointCluster> clusters = part.Clusters(level);
    for (std::size_t c = 0; c < clusters.size(); ++c)
    {
      if (c % 64 == 0)
        ReportProgress(progress,
          (level + static_cast<double>(c) / static_cast<double>(clusters.size())) / part.Levels());
      for (std::size_t b = 0; b < ways.size(); ++b)
        PushCluster(ways[b], points, clusters[c], b, touches);
    }
  }
  ReportProgress(progress, 1.0);
  return touches.Told(pose, glm::normalize(settings.withdrawal));
}

} // namespace hasp
