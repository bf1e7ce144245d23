#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report guides`: are parts sound whatever is asked for, do they fit, does their certificate
/// find what is wrong, and what does a guide cost, against the same by Booleans of meshes. RENDER
/// thread.
void ReportGuides(ReportContext& context);

/// guides.time and guides.gap.p95: the demo's guide on the demo's CT, and one on the phantom.
void TryGuideTimes(ReportContext& context);

} // namespace hasp
