#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hasp
{

/// One place, said in two frames. mm.
struct PointPair
{
  glm::dvec3 from{ 0.0 };
  glm::dvec3 to{ 0.0 };
};

/// What errors of a fit are to call things.
struct RigidFitWords
{
  const char* what;  ///< "tracker calibration": each message begins with it
  const char* from;  ///< "for the tracker"
  const char* to;    ///< "in the room"
  const char* whose; ///< "the tracker": who may have a left-handed frame
};

struct RigidFit
{
  glm::dquat turn{ 1, 0, 0, 0 }; ///< unit; from `from` to `to`
  glm::dvec3 shift{ 0.0 };
  std::vector<double> residualsMm; ///< of each pair
  double rmsMm = 0.0;
  double spreadRatio = 1.0; ///< how wide the points lie in `to` / in `from`
};

/// The rotation and translation with the least sum of squared residuals (Kabsch 1976, Umeyama 1991
/// without scale), by Eigen's SVD. Throws as FitTrackerToRoom says. Any thread; O(N).
RigidFit FitRigid(std::span<const PointPair> pairs, const RigidFitWords& words);

} // namespace hasp
