#ifndef TransplantBuilder_h
#define TransplantBuilder_h

#include "Planning/TransplantRecipe.h" // for TransplantRecipe
#include "TransplantSegments.h"        // for PlacedSegment

#include <optional> // for the paddle
#include <string>   // for warnings
#include <vector>   // for segments

/// A fibula transplant from its recipe, free of VTK but for the export macro.
namespace hasp
{

/// A joint as it came out.
struct MadeJoint
{
  TransplantJoint joint;
  /// Between two segments: of the wedge of donor bone that falls out between their cuts. At the
  /// jaw: of the donor's cut from a square one. Radians.
  double wedgeRadians = 0.0;
  double bendRadians = 0.0; ///< between the axes of two segments; at the jaw 0
  JointFit fit;
  double gapMm = 0.0, overlapMm = 0.0; ///< in the mean over the face that both bones share
};

/// Of segments as they were placed.
///
/// before, after   the jaw at the first joint and at the last, in the defect; empty if it is not
///                 known: then all of the segment's face is a step
/// Throws as MeasureJoint. Any thread. O(triangles).
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<MadeJoint> JointsBetween(const Transplant& plan,
  const std::vector<PlacedSegment>& segments, const TriangleMesh& before,
  const TriangleMesh& after);

/// What a surgeon must know of joints: "joints[1]: a gap of 0.7 mm, at most 0.5 mm are asked for",
/// or that its bones do not meet. O(joints).
std::vector<std::string> JointWarnings(
  const std::vector<MadeJoint>& joints, double mostGapMm, double mostOverlapMm);

struct MadeTransplant
{
  Transplant plan;                     ///< the joints, with the donor's axis as it was found
  CutBone recipient;                   ///< the jaw after the resection
  std::vector<PlacedSegment> segments; ///< in the defect
  std::vector<TriangleMesh> onDonor;   ///< the same, where they lie in the donor's scan
  std::vector<MadeJoint> joints;       ///< one more than segments; the first and last are the jaw's
  std::vector<Osteotomy> donorCuts;    ///< DonorCuts
  std::vector<PlacedVessel> vessel;    ///< in the defect
  std::optional<PlacedPaddle> paddle;  ///< likewise
  std::vector<std::string> warnings;   ///< what a surgeon must know, in words and our own keys
};

/// Everything that a recipe asks for: the jaw is cut (CutFragments), the path laid between its
/// stumps (PlanTransplant), the donor's segments are cut and put there (TransplantSegments), the
/// joints measured (MeasureJoint), vessel and skin carried along. From values alone: when the plan
/// moves, make it again.
///
/// recipient, donor   may be views of one volume
///
/// What is made but not as it should be is a warning: a cut that does not part the jaw, a resection
/// that takes nothing, a joint whose gap or overlap is more than asked for or whose bones do not
/// meet, skin whose perforator lies on no segment.
/// Throws as these functions and FindDonorAxis do, in their words; Cancelled. Any thread; all
/// cores, the same result with any number of them. The phantom's jaw and two segments at 0.8 mm, of
/// a CT of 1 mm: 7 s of CPU time.
VTKHASPFILTERSSURGICALGUIDE_EXPORT MadeTransplant MakeTransplant(const BoneImage& recipient,
  const BoneImage& donor, const TransplantRecipe& recipe, const ProgressFunction& progress = {});

} // namespace hasp

#endif
