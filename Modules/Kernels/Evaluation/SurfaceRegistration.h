#pragma once
#include "Evaluation/SurfaceDifference.h"
#include "Grid/Progress.h"
#include "Grid/RigidPose.h"

#include <cstddef>

namespace hasp
{

struct SurfaceRegistrationSettings
{
  double matchMm = 2.0;       ///< a place nearer than this to the other surface is matched, (0, 20]
  double leastShare = 0.7;    ///< of the part's area that must be matched, (0, 1]
  double mostMedianMm = 1.0;  ///< > 0
  std::size_t samples = 8000; ///< of the part, at most, [500, 100,000]
};

/// Where another scan of the same bone lies.
struct SurfaceRegistration
{
  RigidPose otherToScan;
  double medianMm = 0.0; ///< of all of the part's area, from the other surface
  double rmsMm = 0.0;    ///< of what is matched
  double share = 0.0;    ///< of the part's area that is matched
  bool fits = false;     ///< share and median hold what the settings ask for
  /// Another place, over 5 mm or 5 degrees away, fits as well within a tenth: the bone is too
  /// round, or too alike on all sides, to say where it is.
  bool ambiguous = false;
};

/// Lays one scan's bone on another's: same patient, another scan, whatever its origin, orientation
/// and resolution.
///
/// part    of the scan: what is rigid and in both, as the cranium
/// whole   the other scan's bone; there may be more of it, and some of the part may be missing
/// Method: point-to-plane steps onto the nearest triangle (Chen and Medioni 1992), of places whose
/// normal agrees, with weights that fall to none at three times the median's spread. From the
/// scanner's frame as it is, from the centroids one on the other, from the four ways to lay the
/// principal axes on each other and from the 24 turns of a cube; the three with the least truncated
/// squares are refined. A turn and a shift: never a mirror image, and never a scale.
/// Limits: a part that is less than leastShare of what the two scans share may end elsewhere, and
/// `fits` says so by its figures alone: a wrong place that matches as well cannot be told.
///
/// Throws std::invalid_argument on settings out of range; Cancelled. Any thread; all cores, the
/// same bits on any number of them. 5 s for two surfaces of 600,000
/// triangles, half a second for 2,000, on two busy cores.
SurfaceRegistration RegisterSurfaces(const MeasuredSurface& part, const MeasuredSurface& whole,
  const SurfaceRegistrationSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp
