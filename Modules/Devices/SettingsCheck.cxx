#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <sstream>
#include <stdexcept>

namespace hasp
{

void CheckRange(const char* what, const char* name, double value, double least, double most)
{
  if (value >= least && value <= most)
    return;
  std::ostringstream text;
  text << what << ": " << name << " is " << value << ", must be in [" << least << ", " << most
       << "]";
  throw std::invalid_argument(text.str());
}

void CheckVector(const char* what, const char* name, const glm::dvec3& value, double most)
{
  for (int axis = 0; axis < 3; ++axis)
    CheckRange(what, name, value[axis], -most, most);
}

void CheckPose(const char* what, const RigidPose& pose)
{
  CheckVector(what, "a position in mm", pose.position, 10'000.0);
  CheckRange(what, "a quaternion's length", glm::length(pose.orientation), 1.0 - 1e-6, 1.0 + 1e-6);
}

} // namespace hasp
