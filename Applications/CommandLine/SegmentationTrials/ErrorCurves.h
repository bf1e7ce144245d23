#pragma once
#include "TrialScan.h"

namespace hasp
{

/// segmentation.error_time and segmentation.surface_time of one case, with the strokes that its
/// user drew: the random walker at several tolerances, from the mask on; watersheds; thresholds
/// with components, each of which stands for the fragment that fits best. Seconds, the median of
/// three runs, all on all cores as far as they can.
void DrawErrorCurves(ReportContext& context, const TrialScan& scan, const TrialBone& bone,
  const std::vector<BrushStroke>& strokes);

} // namespace hasp
