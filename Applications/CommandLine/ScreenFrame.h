#pragma once
#include "StereoRig.h"

#include <glm/geometric.hpp>

namespace hasp
{

/// The screen's frame: x right, y up, z towards the viewer, origin in its middle.
class ScreenFrame
{
public:
  explicit ScreenFrame(const StereoScreen& screen)
    : Center(screen.center),
      Right(glm::normalize(screen.right)),
      Up(glm::normalize(screen.up)),
      Normal(glm::cross(this->Right, this->Up))
  {
  }
  glm::dvec3 Of(const glm::dvec3& room) const
  {
    const glm::dvec3 from = room - this->Center;
    return { glm::dot(from, this->Right), glm::dot(from, this->Up), glm::dot(from, this->Normal) };
  }

private:
  glm::dvec3 Center, Right, Up, Normal;
};

} // namespace hasp
