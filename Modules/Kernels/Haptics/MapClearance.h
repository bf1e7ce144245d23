#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/DistanceMap.h"

#include <memory>

namespace hasp
{

/// How far balls of a moving body are from a distance map's body, in terms of how far the moving
/// body may move before they are within reach: the reasoning that all coarse phases share.
///
/// HAPTIC, one thread at a time; takes no memory.
class MapClearance
{
public:
  /// What was found out about a ball, and until when it holds: as long as Travelled() < until.
  struct State
  {
    double until = 0.0;
    bool near = true; ///< a point of the ball may be within reach
  };

  /// radiusMm: of the ball around the moving body's origin that holds all of it.
  MapClearance(std::shared_ptr<const DistanceMap> map, double radiusMm);

  /// The moving body's axes in the map body's (mm), and the distance that matters, within the map's
  /// range. Returns false if all that was known is void: the pose is not finite, or was not.
  bool Begin(const RigidPose& bodyInMap, double reachMm) noexcept;
  /// How far no point of the body has moved more than, mm; since all that was known was void.
  double Travelled() const noexcept { return this->Way; }
  void Forget() noexcept { this->Way = 0.0; }
  /// How far no point of the body is moved more than on the way from Begin's pose to this one, mm.
  double WayTo(const RigidPose& bodyInMap) const noexcept;

  /// A ball in the moving body's axes, mm; the reach less `shorter`. 40 ns.
  State Look(const glm::dvec3& center, double radius, double shorter = 0.0) const noexcept
  {
    const double slack = this->Slack(center, radius, shorter);
    return { this->Way + (slack > 0.0 ? slack : -slack), !(slack > 0.0) };
  }
  /// How far the ball may be moved before one of its points is within reach; below 0, how far it
  /// must be before none is. 0 if the pose is not finite.
  double Slack(const glm::dvec3& center, double radius, double shorter = 0.0) const noexcept;
  /// The way on which the distance may fall by so much, mm.
  double WayFor(double mm) const noexcept { return mm * this->PerSlope; }
  /// Distance in mm at a point of the moving body; +range outside of the grid and for NaN.
  double DistanceAt(const glm::dvec3& point) const noexcept;

private:
  std::shared_ptr<const DistanceMap> Map;
  DistanceMapView<std::int16_t> View;
  glm::dvec3 Spacing{ 1.0 };
  double Radius, PerSlope = 1.0; ///< mm of way for each mm of distance
  double MarginMm = 0.0, ReachMm = 0.0, Way = 0.0;
  RigidPose Pose;
  glm::dmat3 ToIndex{ 1.0 };
  glm::dvec3 IndexOfOrigin{ 0.0 };
};

} // namespace hasp
