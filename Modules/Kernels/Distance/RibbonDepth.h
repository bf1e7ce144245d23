#pragma once
#include "Distance/ImplicitSolid.h"

namespace hasp
{

/// How far a surface may bend away below or above a band, of its width: half of it, and a quarter
/// that places of the path may be off.
inline constexpr double RibbonBendPerWidth = 0.75;

/// A band to be laid on a surface, mm.
struct RibbonBand
{
  double width;
  double below; ///< how far its lower side is below the surface, 0 or negative
  double reach; ///< how far above and below the tangent plane it may be
};

/// A straight piece of a band's path with its axes: unit, upright on each other.
struct RibbonSegment
{
  /// `where` begins the messages. Throws std::invalid_argument if the normal is along a b.
  RibbonSegment(
    const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal, const char* where);

  glm::dvec3 a, b, along, side, normal;
};

/// How far a segment's stadium may reach below its tangent plane, mm, so that it holds the band's
/// lower side, but not the solid's other side, where the shell has a second wall: the middle
/// between both, at most band.reach. Both are looked for in columns along the normal: across the
/// path and beyond its ends, an eighth of the width apart, from places on the segment at most half
/// a width apart (but no more than 100).
///
/// isFirst, isLast   of the path: only there must the band reach beyond the segment's end
/// Throws std::invalid_argument if there is no such depth. O(1) places are asked: some 500 to 2,000
/// a segment that is no longer than the band is wide. Bone thinner than width / 1000 is not seen.
double RibbonDepth(const ImplicitSolid& surface, const RibbonSegment& segment,
  const RibbonBand& band, bool isFirst, bool isLast, const char* where);

} // namespace hasp
