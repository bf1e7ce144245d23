#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report distance`: what distance transforms are off by and what they cost, against those of
/// ITK, OpenVDB and VTK; and contours of solids, against VTK's. RENDER thread.
void ReportDistance(ReportContext& context);

} // namespace hasp
