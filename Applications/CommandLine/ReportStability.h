#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report stability`: what is predicted of stiff and extreme cases against what comes. RENDER
/// thread.
void ReportStability(ReportContext& context);

} // namespace hasp
