#include "TrackedViewer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <stdexcept>

namespace hasp
{

StereoHead HeadOf(const HeadPose& pose, double eyeSeparationMm)
{
  StereoHead head;
  head.position = pose.position;
  head.right = pose.orientation * glm::dvec3(1, 0, 0);
  head.up = pose.orientation * glm::dvec3(0, 1, 0);
  head.eyeSeparationMm = eyeSeparationMm;
  return head;
}

bool Differ(const HeadPose& a, const HeadPose& b)
{
  constexpr double mm = 0.1, degrees = 0.02;
  const double halfTurn = std::abs(glm::dot(a.orientation, b.orientation)); // cosine
  return glm::distance(a.position, b.position) > mm ||
         halfTurn < std::cos(0.5 * glm::radians(degrees));
}

bool Sees(const StereoHead& head, const StereoWindow& window)
{
  constexpr double widest = 179.0; // degrees, of vtkCamera
  try
  {
    const auto views = ViewsOfEyes(window, head, glm::dmat4(1.0));
    return views[0].viewAngleDegrees <= widest && views[1].viewAngleDegrees <= widest;
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
}

} // namespace hasp
