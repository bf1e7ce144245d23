#ifndef FragmentCutter_h
#define FragmentCutter_h

#include "Grid/GridView.h"                     // for AnyGridView
#include "Grid/Progress.h"                     // for ProgressFunction
#include "Grid/TriangleMesh.h"                 // for TriangleMesh
#include "Planning/CutRecipe.h"                // for CutRecipe
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <cstdint>  // for labels
#include <optional> // likewise
#include <vector>   // for fragments

/// Osteotomies, free of VTK but for the export macro: bone and blades in, fragments out.
namespace hasp
{

/// Where bone is: value >= the recipe's isovalue, and, with `labels` of the same geometry, labelled
/// `label`.
struct BoneImage
{
  AnyGridView grey;
  std::optional<AnyGridView> labels;
  int label = 1;
};

/// Bone that is still connected when all cuts are made.
struct BoneFragment
{
  int number = 0;    ///< from 1, the largest first
  TriangleMesh mesh; ///< world mm; closed 2-manifold that does not meet itself, with its hollows
  double volumeMm3 = 0.0;
  glm::dvec3 center{ 0.0 }; ///< of its volume
  bool crumb = false;       ///< smaller than crumbBelowMm3
  bool resected = false;    ///< one of the recipe's `resected` lies in it
};

/// What one cut did to the fragment that it belongs to, as it was when the cut's turn came.
struct CutMeasure
{
  double areaMm2 = 0.0;   ///< of bone, over the kerf in the mean
  double kerfMm3 = 0.0;   ///< bone that the saw turns to dust
  double leftMm2 = 0.0;   ///< bone within the blade that stays whole: far sides, other fragments
  bool parted = false;    ///< no way through bone is left from one side to the other
  double frontMm3 = 0.0;  ///< of the fragment, on the side that the normal points to; 0 ...
  double backMm3 = 0.0;   ///< ... and on the other side, if it was not parted
  std::vector<int> front; ///< fragments that have a face of this cut, looking against the normal
  std::vector<int> back;  ///< likewise, on the other side
};

struct CutBone
{
  std::vector<BoneFragment> fragments; ///< of the islands of bone that were cut, crumbs last
  std::vector<CutMeasure> cuts;        ///< as many as the recipe has
  double boneMm3 = 0.0;                ///< of these islands, before

  /// What is missing, or too much, when fragments and kerfs are added up, as a share of boneMm3.
  /// Measured: bone, fragments and each kerf are meshes of their own.
  double UnaccountedShare() const;
};

/// Cuts bone by blades.
///
/// A blade belongs to the island of bone, and there to the fragment, that its middle is in or
/// nearest to (within the blade), and cuts nothing else: other fragments and islands that it
/// reaches stay whole, and so does the far side of its own (BoneCut::reachMm). Cuts are made in the
/// order of the recipe, each in what those before it left. Islands that no blade belongs to are not
/// looked at and not in the result. A cut that does not part its fragment leaves a slot in it, and
/// says so.
///
/// Method: bone is the signed distance of its coverage (Coverage.h, CoverageDistance.h) on a grid
/// of spacingMm, cut by exact boxes (Csg.h) and contoured with its edges (SharpContour.h) on a grid
/// of CutSpacing. What a blade would meet of bone that it must leave is found in samples of a
/// quarter of the thinnest kerf; there its box ends half way to it. Fragments are the pieces of the
/// mesh; hollows go with the piece around them.
///
/// Volume: bone = fragments + kerfs within 0.1 % (TestFragmentCutter). Faces of cuts are plane
/// within 0.02 of the grid's spacing.
/// Limits: bridges of bone thinner than a step of the grid are not seen. Where two blades' kerfs
/// cross, the bone there is the first one's.
/// Throws std::invalid_argument (recipe, volume, labels of another geometry; a grid of over 2e8
/// points) and std::runtime_error, both naming the cut: "cuts[2] does not meet bone", "resected[0]
/// is 12 mm from all fragments, must be within 3 mm"; Cancelled. Any thread; all cores, the same
/// result with any number of them. About 1 us a sample of the islands' box, and 4 us a triangle;
/// 25 bytes a sample of the box, and one byte a sample of the volume.
VTKHASPFILTERSSURGICALGUIDE_EXPORT CutBone CutFragments(
  const BoneImage& bone, const CutRecipe& recipe, const ProgressFunction& progress = {});

/// The number of the fragment that holds the greater part of each voxel, 0 where none does; x
/// fastest, in any geometry. Lazy: nothing of it is made by CutFragments. Any thread; O(samples
/// and triangles).
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<std::uint16_t> LabelFragments(
  const std::vector<BoneFragment>& fragments, const GridGeometry& geometry);

} // namespace hasp

#endif
