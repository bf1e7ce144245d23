#ifndef GuideClaims_h
#define GuideClaims_h

#include "Evaluation/PartClaims.h"
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <optional> // for the axis

namespace hasp
{

struct GuideRecipe;

/// What a guide of vtkHaspGuideFilter promises, for CertifyFit (Evaluation/FitCertificate.h) to
/// hold its file to. Free of VTK. Flanges, labels and the outer ends of boxes and sleeves are not
/// claimed: only their walls are measured, as all walls are.
///
/// insertionAxis  that the guide was made with (vtkHaspGuideFilter::GetInsertionAxis); none: the
///                recipe's withdrawal, refused if the recipe asks for a search
/// Limits, and where they come from:
///  - gap: 0.2 mm on `leastGapShare` of the inner wall: 0.2 to 0.5 mm are usual for a gap, so that
///    a guide within it still has a usual one; where undercuts are blocked out it has more
///  - thickness: 0.2 mm as the gap, or half the recipe's spacing if that is more, since edges of
///    what is cut are true to that; a quarter of edgeRadiusMm, which a round edge takes off before
///    it; the depth of engraved letters
///  - slots and holes: 0.1 mm: less than half of the least clearance a side that a saw has (0.25,
///    BRP's for resin)
///  - walls: 0.6 mm, as PartClaims; of a shell that is to be thinner, that less the recipe's
///    spacing, since what is thinner than a cell may be missing from a contour
/// Throws std::invalid_argument as ValidateGuideRecipe does. Any thread.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PartClaims ClaimsOf(const GuideRecipe& recipe,
  double leastGapShare = 0.95, const std::optional<glm::dvec3>& insertionAxis = std::nullopt);

} // namespace hasp

#endif
