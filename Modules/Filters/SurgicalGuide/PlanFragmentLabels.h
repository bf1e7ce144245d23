#ifndef PlanFragmentLabels_h
#define PlanFragmentLabels_h

#include "Grid/Progress.h"                     // for ProgressFunction
#include "PlanRebuild.h"                       // for PlanImages
#include "Planning/Plan.h"                     // for Plan
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <cstdint> // for numbers
#include <span>    // for fragments
#include <string>  // for faults
#include <vector>  // for numbers

/// Which samples of a scan a plan's fragments are; free of VTK but for the export macro.
namespace hasp
{

struct PlanFragmentVoxels
{
  /// One a sample of the scan, x fastest: n + 1 where fragments[n] is, 0 where none of them is.
  /// Where two have the same bone it is the later one's.
  std::vector<std::uint16_t> numbers;
  /// One a fragment: why it has no samples, "fragment 7: it is one piece with fragment 5 …"; empty:
  /// it has been found, though a label may have no bone.
  std::vector<std::string> faults;
};

/// The samples of fragments of one scan, whatever these are: labels, components, and pieces that
/// cuts leave (as PlanRebuild finds them). Bone within a blade is a piece's where it lies in the
/// piece's mesh, as what is beyond the cut's reach; else a saw has turned it to dust, and it is
/// nobody's. One that cannot be found is a fault and does not keep the others from being found.
///
/// plan       a valid one
/// images     the scan, and the segmentations of the fragments that are labels, or pieces of such
/// fragments  each once, at most 65,535
/// Throws std::invalid_argument (no such fragment, one that is a surface, fragments of two scans, a
/// scan that is not among the images), Cancelled. Any thread; all cores, the same numbers with any
/// number of them. Labels cost a pass over the scan, all together; each bone of a seed two; each
/// bone that is cut in pieces what CutFragments costs. Memory: 2 bytes a sample, and as long as
/// a bone is worked on 3 to 5 more.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PlanFragmentVoxels PlanFragmentLabels(const Plan& plan,
  const PlanImages& images, std::span<const PlanId> fragments,
  const ProgressFunction& progress = {});

/// The fragment that a piece was cut out of first: itself if it is no piece. nullptr: there is no
/// such fragment.
VTKHASPFILTERSSURGICALGUIDE_EXPORT const PlanFragment* WholeOf(const Plan& plan, PlanId fragment);
/// The cuts that have made a piece: all through the fragments that it is a piece of, those that
/// were cut last first, each once. None of a fragment that is no piece.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<PlanId> CutsOfPiece(
  const Plan& plan, PlanId fragment);
/// The scan that a fragment is of; 0: a surface's, or there is no such fragment.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PlanId VolumeOfFragment(const Plan& plan, PlanId fragment);
/// Bone is value >= isovalue in it. 0 of a surface's, or if there is none.
VTKHASPFILTERSSURGICALGUIDE_EXPORT double IsovalueOfFragment(const Plan& plan, PlanId fragment);
/// A grid for meshes of a scan's fragments (LabelSource::spacingMm) as fine as the scan, as far as
/// plans allow it.
VTKHASPFILTERSSURGICALGUIDE_EXPORT double FragmentSpacing(const glm::dvec3& voxelMm);

} // namespace hasp

#endif
