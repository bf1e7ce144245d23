#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <span>

namespace hasp
{

/// Solids without ends along a direction, to intersect with others. Both throw
/// std::invalid_argument, with the value and the legal range. Any thread.

/// All within roundMm of a polygon, seen along the third of `axes`, which are unit directions as
/// columns, orthogonal within 1e-4.
///
/// corners   at least three, mm along the first two axes; which is inside where the polygon crosses
///           itself tells the even-odd rule
/// roundMm   above 0; corners that stick out are round
/// One face a side. Exact outside, a bound inside. Limit: where the offsets
/// of two sides meet at a corner that goes in, their crease is found as long as it is outside the
/// polygon itself. O(corners) to ask.
SolidPointer MakePrism(std::span<const glm::dvec2> corners, const glm::dmat3& axes, double roundMm);

/// What a part's section through `point`, upright on `direction`, sweeps along it: letters of
/// MakeText as pillars, whose strokes lie in that plane. Faces and steepness are those of the part;
/// its value is a distance if that of the part is one in the plane, and along it where it is.
SolidPointer MakeExtrusion(SolidPointer part, const glm::dvec3& point, const glm::dvec3& direction);

} // namespace hasp
