#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report reduction`: how far fragments end from the truth when they are put together by
/// their broken faces, how far off they may begin, and whether stated intervals hold, against
/// contact alone and iterative closest points. RENDER thread.
void ReportReduction(ReportContext& context);

} // namespace hasp
