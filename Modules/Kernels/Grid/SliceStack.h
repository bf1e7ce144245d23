#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace hasp
{

/// Parallel slices of equal size, each with a place of its own: what a scanner gives before it is
/// known to be a regular volume.
///
/// dims       samples per row and per column, each >= 1
/// spacing    mm between samples of a row, between rows, > 0
/// row        unit world direction along which x counts
/// column     unit world direction along which y counts, at right angles to row
/// origins    world position of each slice's sample (0,0), mm, ascending along Normal()
///
/// Any thread; a value type.
struct SliceStack
{
  glm::ivec2 dims{ 0 };
  glm::dvec2 spacing{ 1.0 };
  glm::dvec3 row{ 1.0, 0.0, 0.0 };
  glm::dvec3 column{ 0.0, 1.0, 0.0 };
  std::vector<glm::dvec3> origins;

  /// row x column: stacks are right-handed whichever way their slices were taken.
  glm::dvec3 Normal() const;
};

/// Two neighbouring slices that are not the usual distance apart.
struct SliceGap
{
  int below = 0;   ///< index of the slice before the gap; the other is below + 1
  double mm = 0.0; ///< their distance along the normal, > 0
  int missing = 0; ///< slices that are missing in it, if it is a multiple of the usual distance;
                   ///< 0: it is uneven
};

/// How far a stack is from a regular volume.
struct StackMeasures
{
  std::vector<double> heights;   ///< of the slices over the first along the normal, mm
  std::vector<glm::dvec2> aside; ///< of the slices from the first along row and column, mm
  double usualGapMm = 0.0;       ///< median distance of neighbours; the lower of two medians
  std::vector<SliceGap> gaps;    ///< only those that are missing slices or uneven
  double gapDeviationMm = 0.0;   ///< largest |distance - mean distance|
  double tiltDegrees = 0.0;      ///< of the line of the first samples to the normal, >= 0; if they
                                 ///< are on none, of the one most are near
  double farthestAsideMm = 0.0;  ///< largest length of `aside`
  int farthestSlice = 0;         ///< the slice with it
  bool tilted = false;           ///< some slice is aside by more than a tenth of a sample
  bool straight = true;          ///< the first samples lie on one line, within the same tenth
  bool leaning = false;          ///< over the stack, that tilt is more than the same tenth
  int oddSlice = 0;              ///< if not straight: the slice farthest from the line ...
  double oddMm = 0.0;            ///< ... and how far it lies beside it
};

/// Measures a stack of at least two slices. A gap is usual within 1 % or 0.02 mm (positions are
/// written with few decimals), and is missing slices where it is within 0.05 of a whole multiple.
/// Throws std::invalid_argument unless dims >= 1, spacing and positions are finite, spacing > 0,
/// row and column are orthonormal within 1e-6, and each slice is higher than the one before it.
StackMeasures MeasureStack(const SliceStack& stack);

/// The distance from a regular place that is forgiven a slice, mm: 1 % of the usual gap, 0.02 mm at
/// least.
double ForgivenGapMm(double usualGapMm);

} // namespace hasp
