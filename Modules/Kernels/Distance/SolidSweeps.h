#pragma once
#include "Distance/ImplicitSolid.h"

#include <span>
#include <string_view>

namespace hasp
{

/// Shapes swept along lines, as solids. All throw std::invalid_argument, with the place in the
/// line (its number from 0, and mm), the value and the legal range, and never with a text itself.
/// Any thread; O(n log n) to make n segments, about O(log n) to ask.

/// All within radiusMm of a polyline, or of a closed polygon. One face a segment; one point is a
/// ball. At least one point. Exact outside; inside a bound where segments overlap.
SolidPointer MakeTube(std::span<const glm::dvec3> line, bool closed, double radiusMm);

/// A band on a surface, such as a plate on bone: what lies between fromMm and toMm of `surface`
/// (below it if negative) and, seen along the surface's normal, within widthMm / 2 of a path on it.
/// Its upper and lower side are offsets of the surface itself; its walls are upright on it in the
/// middle of each straight segment, its ends round.
///
/// path   at least two places, mm, on the surface: they and the middles between them at most
///        widthMm / 4 off. Where it bends away more, give more places.
/// normals   of each straight segment, any length: what its walls are upright along, where the
///        surface's own normals in its three places are too uneven; none: these
/// Thin bone: the band is on the side of the path alone. Below each straight segment it ends within
/// the solid, halfway between the lowest place of the surface under it and the highest of the
/// solid's other side, as columns along the normal find them, an eighth of the width apart across.
/// Throws where there is no such depth: the solid must be thicker than the surface under a segment
/// bends, and than 2 |fromMm| more if that is negative. The message says where.
/// Limits: the surface under the band must not bend away from its tangent by more than widthMm / 2.
/// Another solid within toMm + 0.75 widthMm above the path gets a band, too. What beside the
/// columns is thinner than in them may, and what is thinner than widthMm / 1000.
/// Cost: some 1,000 values of `surface` a segment.
/// Faces: those of MakeShell(surface, fromMm, toMm), then five a segment (MakeStadium).
SolidPointer MakeRibbon(SolidPointer surface, std::span<const glm::dvec3> path, double widthMm,
  double fromMm, double toMm, std::span<const glm::dvec3> normals = {});

/// Letters of single strokes with round ends, as a burr writes and a printer prints: to engrave
/// (MakeDifference) or to emboss (MakeUnion). The axes of the strokes lie in one plane.
///
/// text      of A to Z, 0 to 9, space and . - / + :   The 0 has a bar, the O has none.
/// origin    lower left corner of the first letter's axes, mm
/// right, up directions of writing and of the letters' height; need not be unit nor upright on
///           each other: up is turned so
/// heightMm  from the lowest axis to the highest. A letter is 2/3 of that wide, a place all of it.
/// strokeMm  diameter of the strokes, at most heightMm / 6, so that no two run together
/// One face a straight piece of a stroke. Throws for a text without strokes, too.
SolidPointer MakeText(std::string_view text, const glm::dvec3& origin, const glm::dvec3& right,
  const glm::dvec3& up, double heightMm, double strokeMm);

/// From the axis of the first letter to that of the last one's far side, mm; 0 without letters.
double TextWidth(std::size_t letters, double heightMm);

} // namespace hasp
