#pragma once
#include "Planning/Osteotomy.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <optional>
#include <span>

/// How a hand puts a blade: through places that it touched, then shifted and turned. Pure; any
/// thread; World mm.
namespace hasp
{

/// Unit columns: along, across (the way of depthMm), normal. Right-handed.
glm::dmat3 BladeAxes(const Osteotomy& blade);

/// The blade through places on bone.
///
/// places   two: the plane holds both and the direction of view, so that the saw comes in as one
///          looks, and `along` leads from the first to the second. Three: the plane through them,
///          and `along` is along the longest side of their triangle.
/// view     of any length but 0; of three places it only says which way the normal looks
/// sizes    whose width, depth and kerf the blade has; it is wider and deeper where it must be to
///          reach BeyondPlacesMm beyond each place
/// Throws std::invalid_argument: another number of places, two of them nearer than 1 mm, a view
/// along the line between two, three on a line.
Osteotomy BladeThrough(
  std::span<const glm::dvec3> places, const glm::dvec3& view, const Osteotomy& sizes);
inline constexpr double BeyondPlacesMm = 5.0;

/// Shifted by so many mm along its own axes: along, across, normal.
Osteotomy ShiftedBlade(Osteotomy blade, const glm::dvec3& mm);

/// Turned about its middle. Directions stay unit and upright on each other after any number of
/// turns.
Osteotomy TurnedBlade(Osteotomy blade, const glm::dquat& turn);

/// The direction of a sum of directions; nothing where they cancel out: a sum shorter than a tenth
/// of their number.
std::optional<glm::dvec3> MeanDirection(std::span<const glm::dvec3> directions);

} // namespace hasp
