#pragma once
#include "Distance/ImplicitSolid.h"

#include <vector>

namespace hasp
{

/// Solids made of solids. Parts are shared, not copied, and may be in many trees. Surfaces are
/// exact where those of the parts are; elsewhere the value is a bound of the distance. All of them
/// keep the promises of ImplicitSolid: as steep as their steepest part at most, gradients out of
/// the new solid, and the faces of their parts, those of the first part first. Of faces that tie
/// within SolidTieMm the lowest number is named.
///
/// Films: where parts that touch leave a gap, or tools that touch leave a wall, without a thickness
/// of its own (below 2e-5 mm), the value would be 0 there, or rounding. It is -1e-5 mm in such a
/// gap and 1e-5 mm in such a wall, so that it is gone whatever grid asks; in nothing else does a
/// union, an intersection or a difference depart from min and max. Shapes that touch in a line or a
/// point alone are not joined.
///
/// Lazy: a part is not asked where its bounds say that it cannot matter; values are the same, to
/// the last bit, as if it were. Parts of a union lie in a tree of boxes: O(log n) of n parts apart.
///
/// Throw std::invalid_argument if a part is null, a number is not finite, or there are more than
/// 2^32 - 1 faces. Any thread. Limit: one stack frame of some hundred bytes a level of the tree.

/// min. At least one part.
SolidPointer MakeUnion(std::vector<SolidPointer> parts);
/// max. At least one part.
SolidPointer MakeIntersection(std::vector<SolidPointer> parts);
/// max(body, -tool): the faces of the tool look the other way.
SolidPointer MakeDifference(SolidPointer body, SolidPointer tool);

/// value - mm: larger where mm > 0, smaller where mm < 0, and nothing at all beyond the part.
/// Exactly the places within mm of the part where its value is a distance: of shapes, and unions of
/// them outside. Limit: inside a union it is a bound, so that what is joined by less than 2 |mm|
/// comes apart, and elsewhere edges stay sharp where they would get round.
SolidPointer MakeOffset(SolidPointer part, double mm);

/// The wall between two offsets of a part, fromMm < toMm: max(value - toMm, fromMm - value). With
/// n faces of the part, n outer ones, then n inner ones.
SolidPointer MakeShell(SolidPointer part, double fromMm, double toMm);

/// An intersection whose edges are cut off, where upright bevelMm along either surface:
/// max(a, b, (a + b + bevelMm) / 2). Faces: those of a (n), of b (m), then n m bevels, m
/// consecutive ones for a face of a. Films stay.
SolidPointer MakeBevelledIntersection(SolidPointer a, SolidPointer b, double bevelMm);

/// A union with its creases filled by a fillet, polynomial, within radiusMm of both surfaces:
/// min(a, b) - h^2 r / 4 with h = max(0, 1 - |a - b| / r). It adds at most r / 4. Faces: those of a
/// (n), of b (m), then n m fillets, one for each pair, m consecutive ones for a face of a.
SolidPointer MakeSmoothUnion(SolidPointer a, SolidPointer b, double radiusMm);

/// An intersection whose edges are rounded, from radiusMm before them on either surface:
/// max(a, b) + h^2 r / 4, which takes away at most r / 4. Faces as of a smooth union.
SolidPointer MakeSmoothIntersection(SolidPointer a, SolidPointer b, double radiusMm);

} // namespace hasp
