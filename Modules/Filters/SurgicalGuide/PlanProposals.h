#ifndef PlanProposals_h
#define PlanProposals_h

#include "Grid/Progress.h"                     // for ProgressFunction
#include "PlanRebuild.h"                       // for PlanImages, PlanCutMeasure
#include "Planning/Plan.h"                     // for Plan
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <array>  // for tips
#include <vector> // for pieces

/// What need not be touched by hand because the scan says it; free of VTK but for the export macro.
namespace hasp
{

/// A piece that cuts leave, and the place that stands for it.
struct ProposedPiece
{
  glm::dvec3 seed{ 0.0 }; ///< on it, as far from the planes of the cuts as it goes: it stays the
                          ///< same piece's when they move
  double volumeMm3 = 0.0;
  bool crumb = false;  ///< smaller than 20 mm3
  PlanId fragment = 0; ///< the piece of the plan that it is already; 0: none
};

struct ProposedPieces
{
  std::vector<ProposedPiece> pieces; ///< the largest first
  std::vector<PlanCutMeasure> cuts;  ///< all that went through the bone: whether each parts it
};

/// The pieces of a fragment of a scan, as PlanRebuild finds them.
///
/// divided   may be a piece itself: then those of its pieces alone
/// images    the scan, and the segmentation of a fragment that is a label or a piece of one
/// Throws std::invalid_argument and std::runtime_error as PlanRebuild::Make of a piece, in its
/// words, and std::invalid_argument if no cut goes through the fragment; Cancelled. Any thread; all
/// cores. Costs what CutFragments costs.
VTKHASPFILTERSSURGICALGUIDE_EXPORT ProposedPieces ProposePieces(const Plan& plan,
  const PlanImages& images, PlanId divided, const ProgressFunction& progress = {});

/// The middle line of a donor bone between its tips: what FindDonorAxis of DonorAxis.h finds in the
/// fragment, in its scan.
///
/// tips       touched on the bone, mm; 30 mm apart at least
/// radiusMm   of the bone, (0, 50]
/// Throws as FindDonorAxis, its messages behind "fragment 9: ", and as ProposePieces; Cancelled.
/// Any thread; O(samples).
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<glm::dvec3> ProposeDonorAxis(const Plan& plan,
  const PlanImages& images, PlanId donor, const std::array<glm::dvec3, 2>& tips, double radiusMm,
  const ProgressFunction& progress = {});

} // namespace hasp

#endif
