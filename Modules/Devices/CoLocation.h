#pragma once
#include "Grid/RigidPose.h"

#include <span>
#include <vector>

namespace hasp
{

/// One place, said twice: where the device says its tip is, and where that is in the world (the
/// user held the tip to a drawn mark, or to a point of the display that was measured).
struct CoLocationPair
{
  glm::dvec3 deviceMm{ 0.0 };
  glm::dvec3 worldMm{ 0.0 };
};

struct CoLocationFit
{
  RigidPose deviceToWorld;         ///< for WorkspaceMapping::Place, with scale 1
  std::vector<double> residualsMm; ///< of each pair: how far the fit leaves the two apart
  double rmsMm = 0.0;
  double spreadRatio = 1.0; ///< how wide the points lie in the world / for the device; near 1
};

/// Where a device stands, from points that both know: rigid, with scale 1, so that the drawn tip
/// meets the device's own (mirror displays). The fit of FitTrackerToRoom, with its errors; what it
/// says of residuals holds here, too: four points or more, and not in a plane if possible.
///
/// Throws std::invalid_argument as there (few points, points on a line, a mirror image, numbers
/// that are none), and where spreadRatio is not in [0.9, 1.1]: other units, or a device that is not
/// homed. Throws std::runtime_error if this build has no Eigen. Any thread; O(N).
CoLocationFit FitCoLocation(std::span<const CoLocationPair> pairs);

} // namespace hasp
