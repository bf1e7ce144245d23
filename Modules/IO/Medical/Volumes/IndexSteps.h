#pragma once
#include "Grid/GridGeometry.h"

#include <filesystem>

/// From what headers say of an index step along each axis to a geometry.
namespace hasp
{

/// Sets spacing and direction from the world vectors of an index step along each axis, mm. Throws
/// ThrowFileError with the angle if they are not at right angles, and whatever
/// GridGeometry::Validate finds. dims and origin are to be set before.
void SetIndexSteps(
  const std::filesystem::path& file, const glm::dmat3& steps, GridGeometry& geometry);

/// Largest difference of an angle between two steps from 90 degrees; NaN if one is zero or not
/// finite.
double SkewDegrees(const glm::dmat3& steps);

/// Below it directions count as at right angles: what GridGeometry::Validate lets pass.
constexpr double SkewLimitDegrees = 0.0057;

} // namespace hasp
