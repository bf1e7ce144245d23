#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/mat3x3.hpp>

namespace hasp
{

/// Shapes as solids: exact signed distances, mm, inside and outside. Edges and corners of a shape
/// are faces, too: nothing of them is on its own surface, but an offset outwards is round there.
/// All throw std::invalid_argument, with the value and the legal range, if a number is not finite
/// or a size not above 0. Directions need not be unit; 0 is refused. Any thread; O(1) in all.

/// The half space behind a plane; `normal` points out. One face.
SolidPointer MakePlane(const glm::dvec3& point, const glm::dvec3& normal);

/// What lies within widthMm / 2 of a plane. Faces: 0 towards the normal, 1 the other side.
SolidPointer MakeSlab(const glm::dvec3& point, const glm::dvec3& normal, double widthMm);

/// `axes`: its unit directions as columns, orthogonal within 1e-4; `half`: half its sides, mm.
/// Six plane faces, twelve edges, eight corners: 26 faces.
SolidPointer MakeBox(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half);

/// A box of these outer measures with edges of `radiusMm`, below the smallest of `half`. 26 faces.
SolidPointer MakeRoundedBox(
  const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half, double radiusMm);

/// From the middle of one end to that of the other. Faces: the side, the ends at b and at a, their
/// rims.
SolidPointer MakeCylinder(const glm::dvec3& a, const glm::dvec3& b, double radiusMm);

/// A plate with round ends: all within radiusMm of the segment a b, seen along `normal`, and within
/// heightMm / 2 of it along the normal, which is turned upright on a b if it is not. a and b may be
/// the same: a cylinder. Faces as of a cylinder.
SolidPointer MakeStadium(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal,
  double radiusMm, double heightMm);

/// All within radiusMm of a segment; a ball if both ends are the same. One face.
SolidPointer MakeCapsule(const glm::dvec3& a, const glm::dvec3& b, double radiusMm);

/// All that is seen from the tip within angleDeg / 2 of a direction; without an end. angleDeg in
/// [1, 179]. Faces: the side, the tip.
SolidPointer MakeCone(const glm::dvec3& tip, const glm::dvec3& direction, double angleDeg);

} // namespace hasp
