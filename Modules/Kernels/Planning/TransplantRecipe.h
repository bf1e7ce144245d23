#pragma once
#include "Planning/CutRecipe.h"
#include "Planning/Transplant.h"

#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// The guide that leads the saw on the donor: what of a GuideRecipe is not told by the segments.
/// Ranges are those of GuideRecipe's keys. Defaults are SlicerBoneReconstructionPlanner's, but for
/// the width.
struct MitreGuideChoices
{
  double gapMm = 0.3;            ///< bone to inner wall
  double thicknessMm = 4.0;      ///< inner to outer wall
  double widthMm = 14.0;         ///< of the body along the bone
  double clearanceMm = 0.25;     ///< slots are wider by this on either side
  double wallMm = 3.0;           ///< of the slots' boxes
  double slotLengthMm = 20.0;    ///< across the bone
  double guidingHeightMm = 15.0; ///< of the boxes above the bone
  double beyondMm = 15.0;        ///< of the body beyond the outer cuts, [5, 100]; pins stand there
  double pinDiameterMm = 3.0;    ///< as printed; 0: no pins
  double spacingMm = 0.4;        ///< of the working grid

  bool operator==(const MitreGuideChoices&) const noexcept = default;
};

/// What a fibula transplant is made from, besides the CTs of its recipient and its donor, which may
/// be one. World of all that lies in the jaw = patient LPS of the recipient's scan, mm; of all that
/// lies on the donor likewise of its own. A plain value.
struct TransplantRecipe
{
  /// The osteotomies of the jaw. The first ends the stump that the new jaw begins at, the last that
  /// where it ends; their saws' dust is taken from the defect's side of those two faces. Its
  /// isovalue finds the jaw, and its spacingMm and ignoreBelowMm3 hold for the donor, too. The bone
  /// is the island that each blade lies in: it needs no seed.
  CutRecipe resection;
  /// The middle line of the new jaw, in order, 2 to 6 places. Its first and last leg are cut or
  /// lengthened to the stumps' faces: where cuts move, the line's ends go with them. Corners are
  /// mitred.
  std::vector<glm::dvec3> path;
  std::vector<glm::dvec3> outward; ///< unit; where the donor's lateral side looks: one direction
                                   ///< for all segments, or one for each
  double rollDeg =
    0.0; ///< all segments are turned by so much about the path's direction, [-180, 180]
  /// Shorter segments are refused: they lose their vessels. (0, 200]. 20 is what planners take; our
  /// sources have no number.
  double leastSegmentMm = 20.0;

  double donorIsovalue = 226.0; ///< donor bone is value >= donorIsovalue
  DonorBone donor; ///< keepMm: 75 is SlicerBoneReconstructionPlanner's, from ankle and knee
  /// donor.axis is the two tips of the bone, and its middle line is found in the CT (DonorAxis.h).
  bool findAxis = false;
  bool fromLastTip = false;   ///< as Transplant's, and so all below
  double startOffsetMm = 0.0; ///< [0, 500]
  double kerfMm = 1.0;        ///< (0, 5]
  double betweenMm = 1.5;     ///< [0, 100]; a guide needs more where corners are sharp, and says so
  std::vector<glm::dvec3> vessel;
  std::optional<SkinPaddle> paddle; ///< its outline: 3 places or more

  /// Of a joint, in the mean over the face that its two bones share, [0, 10]; more is warned of.
  /// Ours: our sources have no number.
  double mostGapMm = 0.5, mostOverlapMm = 0.5;
  MitreGuideChoices guide;

  bool operator==(const TransplantRecipe&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range: "SUBJECT:
/// WHEREgapMm is 11, must be in [0, 10]".
void ValidateMitreGuideChoices(
  const MitreGuideChoices& choices, const std::string& subject, const std::string& where);

/// Throws std::invalid_argument unless every number is finite and in its range, ValidateCutRecipe
/// takes the resection, and there are two cuts at least. The message names the key as it stands in
/// the file, its value and the legal range.
void ValidateTransplantRecipe(const TransplantRecipe& recipe);

/// The joints of the recipe: the path between the stumps' faces, ready for LayOutSegments.
/// Throws as ValidateTransplantRecipe; and std::invalid_argument on a face more than 60 degrees off
/// a square cut, on a path that turns back, and on a segment shorter than leastSegmentMm
/// ("segments[1]'s length is 12, must be …"). O(places).
Transplant JointsOf(const TransplantRecipe& recipe);

/// The blades that part the segments from the donor: two a segment, its start's and its end's, in
/// the order of the segments, with the kerf outside of it. As wide and deep as four radii.
std::vector<Osteotomy> DonorCuts(
  const Transplant& transplant, const std::vector<DonorSegment>& segments);

} // namespace hasp
