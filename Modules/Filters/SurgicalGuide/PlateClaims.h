#ifndef PlateClaims_h
#define PlateClaims_h

#include "Evaluation/PartClaims.h"
#include "Grid/GridView.h"
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <span>   // for screws
#include <vector> // for screws

namespace hasp
{

struct PlateRecipe;

/// A screw as a plate was made for it: the array "ScrewAxes" of vtkHaspPlateFilter.
struct ScrewAxis
{
  glm::dvec3 outer; ///< where it comes through the plate's outer face, world mm
  glm::dvec3 axis;  ///< unit, out of the bone
};

/// Where the screws of a recipe come to lie on a scan, whose fragments are not moved; no plate is
/// made. Throws as vtkHaspPlateFilter reports, std::invalid_argument if the recipe moves fragments.
/// Any thread; all cores; half of a plate's time.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<ScrewAxis> FindScrewAxes(
  const AnyGridView& scan, const PlateRecipe& recipe);

/// What a plate of vtkHaspPlateFilter promises, for CertifyFit (Evaluation/FitCertificate.h) to
/// hold its file to: one piece; gap, thickness, walls; of each screw, in the recipe's order, the
/// bore. Heads' rooms and the bevel are not claimed: only their walls are measured, as all walls
/// are. Free of VTK.
///
/// The bone to measure against is the one that the plate lies on: a scan only if the recipe moves
/// no fragments. Of one that does, gap and thickness are not claimed, since bone where it was says
/// nothing of them: walls and bores are.
/// Limits, and where they come from:
///  - gap: 0.2 mm on `leastGapShare` of the inner wall, as of guides; over what is bridged
///    (bridgeMm) it has more
///  - thickness: less bevelMm and a spacing of the grid: where bone slopes under the plate, its
///    bevel looks away from the inner wall and is measured with it
///  - bores: 0.1 mm. One whose cone leaves it less than 0.5 mm is not claimed: no cylinder can be
///    fitted to that
///  - walls: 0.6 mm, as PartClaims; of a plate that is to be thinner, that less the spacing
/// Throws std::invalid_argument as ValidatePlateRecipe does, too, and if there is not one axis a
/// screw. Any thread.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PartClaims ClaimsOf(
  const PlateRecipe& recipe, std::span<const ScrewAxis> screws, double leastGapShare = 0.95);

} // namespace hasp

#endif
