#pragma once
#include "Reduction/FractureFit.h"

#include <string>

/// What Snap-to-fit is held against, on the same bodies and from the same starts. Any thread.
namespace hasp
{

struct IcpSettings
{
  double reachMm = 5.0;     ///< pairs are no farther apart at first, and 1 mm at the end
  double leastFacing = 0.0; ///< cosine between a normal and the other's turned round
  int steps = 60;
  std::size_t points = 8192;
};

/// Iterative closest points, point to plane (Chen and Medioni 1992; trimmed by distance and by
/// normals, as Open3D's and PCL's are used on fractures): each moved point that looks at a partner
/// goes with the nearest place there, all with the same weight, inside and outside alike; the reach
/// shrinks by a quarter every ten steps.
RigidPose FitByIcp(std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene,
  const IcpSettings& settings = {});
std::string IcpWords();

/// Contact alone, as with a hand that pushes: no attraction and no surfaces that go on, but a
/// constant push towards the partners' nearest faces, along the direction that these have at the
/// start, until it balances with contact or `steps` are over.
RigidPose FitByContact(
  std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene);
std::string ContactWords();

} // namespace hasp
