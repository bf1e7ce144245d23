#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report haptics`: contact of point shells with distance maps, whole ticks, and a loop of
/// 1 kHz beside rendering; each against a rival, with what it is off by. RENDER thread.
void ReportHaptics(ReportContext& context);

} // namespace hasp
