#ifndef TransplantSegments_h
#define TransplantSegments_h

#include "FragmentCutter.h"      // for BoneImage
#include "Planning/Transplant.h" // for Transplant

#include <memory> // for internals
#include <span>   // for joints

/// A transplant's bone in its defect, free of VTK but for the export macro.
namespace hasp
{

struct SegmentSettings
{
  double isovalue = 226.0;       ///< bone is value >= isovalue
  double spacingMm = 0.5;        ///< of the meshes' grid, [0.1, 2]
  double ignoreBelowMm3 = 100.0; ///< islands of "bone" smaller than this do not count, [0, 1e6]
};

/// A segment as it lies in the defect.
struct PlacedSegment
{
  DonorSegment cut;  ///< where it comes from
  TriangleMesh mesh; ///< world mm of the defect; closed 2-manifold that does not meet itself
  double volumeMm3 = 0.0;
};

/// Cuts a donor bone into segments and puts them into the defect; made once for a donor, asked
/// again whenever the plan moves. Segments whose planes and places are still the same are not cut
/// again (LastCut tells how many were).
///
/// The donor is the island of bone nearest to the middle of its axis. Its distance is sampled once
/// (BoneSolid.h); a segment is that solid, moved with its grid, between the planes of its two
/// joints, contoured in the defect's own coordinates, so that what SharpContour proves is true of
/// the mesh as it is.
/// One thread at a time; uses all cores.
class VTKHASPFILTERSSURGICALGUIDE_EXPORT TransplantSegments
{
public:
  /// Throws std::invalid_argument (settings, volume; no bone within donor.radiusMm of the middle of
  /// the axis); Cancelled.
  TransplantSegments(const BoneImage& image, const DonorBone& donor,
    const SegmentSettings& settings = {}, const ProgressFunction& progress = {});
  ~TransplantSegments();

  /// Throws as LayOutSegments, and std::runtime_error for a segment without bone, in several
  /// pieces, or of bone more than three radii from its axis ("segments[1] …"). After an error
  /// nothing has changed.
  const std::vector<PlacedSegment>& Place(const Transplant& transplant);

  std::size_t LastCut() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

/// How two bones meet at a joint, by columns along its normal, 0.25 mm apart: where the bone before
/// ends, and where that after it begins, both within 3 mm of the joint's plane, at
/// faces that look along the normal within 25 degrees: the bones' sides do not count.
struct JointFit
{
  double contactMm2 = 0.0;                   ///< they meet, within 0.1 mm
  double gapMm2 = 0.0, gapMm3 = 0.0;         ///< they are apart
  double overlapMm2 = 0.0, overlapMm3 = 0.0; ///< they are in each other
  double stepMm2 = 0.0;                      ///< only one of them is there
};

/// before, after   closed meshes, such as PlacedSegment's, or the jaw's fragments. Only what is
///                 within `reachMm` of the joint across its normal counts, (0, 100]
/// Throws std::invalid_argument on a reach out of range. Any thread. O(triangles).
VTKHASPFILTERSSURGICALGUIDE_EXPORT JointFit MeasureJoint(const TransplantJoint& joint,
  const TriangleMesh& before, const TriangleMesh& after, double reachMm);

} // namespace hasp

#endif
