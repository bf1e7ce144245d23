#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// Grids that parts are made on.
namespace hasp
{

/// Right-handed axes with `z`, which is unit, as the third column.
glm::dmat3 AxesAlong(const glm::dvec3& z);

/// Call before memory is taken. Throws std::invalid_argument if a grid of this many steps has over
/// 2e8 points: "WHO: the working grid … REMEDY (now SPACING mm)".
void CheckPoints(const char* who, const glm::dvec3& count, double spacingMm, const char* remedy);

/// What to say of bone in a scan.
constexpr const char* GridRemedy =
  "choose a larger spacingMm or kerf, or a label of this bone alone";

/// Of a grid with these axes in a box along them. Throws as CheckPoints does.
GridGeometry GridIn(
  const char* who, const ImplicitSolid::Box& local, const glm::dmat3& axes, double spacingMm);

} // namespace hasp
