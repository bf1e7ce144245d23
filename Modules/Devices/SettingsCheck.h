#pragma once
#include "Grid/FinitePose.h"

namespace hasp
{

// What settings of devices are held against. Each throws std::invalid_argument that says whose
// setting it is (`what`), its name, its value and what is legal. Any thread.

void CheckRange(const char* what, const char* name, double value, double least, double most);

/// Each coordinate within +-most.
void CheckVector(const char* what, const char* name, const glm::dvec3& value, double most);

/// Within 10 m, and its quaternion unit within 1e-6.
void CheckPose(const char* what, const RigidPose& pose);

} // namespace hasp
