#ifndef MitreGuide_h
#define MitreGuide_h

#include "Grid/GridView.h"                     // for AnyGridView
#include "Planning/GuideRecipe.h"              // for GuideRecipe
#include "Planning/TransplantRecipe.h"         // for MitreGuideChoices
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <string> // for warnings
#include <vector> // for warnings

/// The guide that leads the saw on the donor, free of VTK but for the export macro.
namespace hasp
{

struct MitreGuide
{
  GuideRecipe recipe;                ///< ready for vtkHaspGuideFilter, on the donor's scan
  std::vector<std::string> warnings; ///< pins that were left out, and why
};

/// A guide that lies along the donor's lateral side, `choices.beyondMm` beyond its outer cuts, with
/// a slot for each of DonorCuts: two a segment, in the order of the segments, the
/// kerf outside of the segment. It lifts off along the lateral direction, upright on the line
/// between the outer cuts. Pins stand at both its ends, where bone stays, and in the middle of each
/// segment, so that nothing is loose when it is sawn off; a pin that a slot's box comes near is
/// left out.
///
/// plan       with the donor's axis: MadeTransplant's, or PlanTransplant's
/// donor      the scan that the axis is of
/// isovalue   of the donor's bone
/// Throws std::runtime_error: no bone on the lateral side where the guide should lie; slots that
/// come nearer to each other than two steps of the grid, which is the least wall it can show
/// ("slots[1] and slots[2] …; raise donor.betweenMm by 1.2 mm"); and what ValidateGuideRecipe
/// refuses; and as LayOutSegments does. Any thread; microseconds.
VTKHASPFILTERSSURGICALGUIDE_EXPORT MitreGuide MakeMitreGuideRecipe(const Transplant& plan,
  const AnyGridView& donor, double isovalue, const MitreGuideChoices& choices);

} // namespace hasp

#endif
