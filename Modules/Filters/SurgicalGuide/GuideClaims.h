#ifndef GuideClaims_h
#define GuideClaims_h

#include "Evaluation/PartClaims.h"
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

namespace hasp
{

struct GuideRecipe;

/// What a guide of vtkHaspGuideFilter promises, for CertifyFit (Evaluation/FitCertificate.h) to
/// hold its file to. Free of VTK.
///
/// Limits, and where they come from; h is the recipe's spacingMm:
///  - gap: 0.2 mm on `leastGapShare` of the inner wall: 0.2 to 0.5 mm are usual for a gap, so that
///  a
///    guide within it still has a usual one; where undercuts are blocked out it has more
///  - thickness: what a wall must be. The region around the landmarks, a tube, trims the shell
///  where
///    bone bends away under it, so that no more is promised there
///  - slots: 0.1 mm: less than half of the least clearance a side that a saw has (0.25, BRP's for
///    resin). Planes of sampled distances are exact
///  - holes: 0.1 mm, and h^2 / diameter: what a circle loses between samples, h sqrt(2) apart
///  across
///  - walls: 0.6 mm, as PartClaims; of a shell that is to be thinner, that less h,
///    since ContourTetrahedra bevels edges within a cell
/// Throws std::invalid_argument as ValidateGuideRecipe does. Any thread.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PartClaims ClaimsOf(
  const GuideRecipe& recipe, double leastGapShare = 0.95);

} // namespace hasp

#endif
