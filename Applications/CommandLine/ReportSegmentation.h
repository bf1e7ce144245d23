#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report segmentation`: how far fragments that few strokes part agree with the truth, on
/// broken phantoms, a real skull with planted cuts and simulated cone beam; and what one more
/// stroke costs. RENDER thread.
void ReportSegmentation(ReportContext& context);

} // namespace hasp
