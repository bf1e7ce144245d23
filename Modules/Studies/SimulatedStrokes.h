#pragma once
#include "Planning/SegmentationRecipe.h"
#include "Studies/CoarseTruth.h"

#include <functional>
#include <vector>

/// Strokes as a user draws them, and a user who corrects. What is known to the one who draws is in
/// the types: the bone that everybody sees, and coarse hints (CoarseTruth.h); no truth.
namespace hasp
{

struct StrokeLimits
{
  int strokes = 10;       ///< in all, >= 1
  double radiusMm = 3.0;  ///< of the brush, at most; (0, 50]
  double lengthMm = 30.0; ///< of the line, at most; >= 0
};

/// A stroke on the bone's surface: it begins at the surface voxel (a face of it has no bone behind
/// it) nearest to hint.near, and goes both ways, half of lengthMm each at most, in steps of about a
/// millimetre to the nearest surface voxel: along hint.way, whose cells are of one fragment, or,
/// where there is none, along hint.along and no further than half of reachMm less the radius. Its
/// radius is a third of hint.reachMm, so that it is on one fragment if the hint is as good as it
/// says. All its points are voxel centres of the bone.
///
/// bone   not 0 where there is bone
/// Throws std::invalid_argument on bad limits, std::runtime_error if there is no bone within 30 mm
/// of the hint. Microseconds.
BrushStroke DrawStroke(
  GridView<const Label> bone, const CoarseHint& hint, const StrokeLimits& limits = {});

/// Labels made of strokes: a random walk, or whatever is on trial. One value a voxel.
using SplitByStrokes = std::function<std::vector<Label>(const std::vector<BrushStroke>&)>;

struct SimulatedUser
{
  std::vector<BrushStroke> strokes; ///< as they were drawn: one a fragment, then corrections
  std::vector<Label> labels;        ///< of the last split
  int splits = 0;
  bool content = false; ///< no error was seen at the end; else strokes ran out
};

/// A user at work: one stroke for each fragment where it is about, a split; then, as long as there
/// are strokes left and an error of some millimetres is seen (CoarseTruth::LargestError), one
/// stroke more there and another split. Throws as DrawStroke, and std::invalid_argument if there
/// are fewer strokes than fragments or a split gives another number of labels than voxels.
SimulatedUser SimulateUser(GridView<const Label> bone, const CoarseTruth& known,
  const StrokeLimits& limits, const SplitByStrokes& split);

/// Of the line, mm.
double LengthOf(const BrushStroke& stroke);

} // namespace hasp
