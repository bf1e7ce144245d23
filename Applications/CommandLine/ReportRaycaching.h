#pragma once

namespace hasp
{

struct ReportContext;

/// raycaching.*: cost and error of the cache and of what Automatic chooses, against direct ray
/// casts, VTK's volume mapper, and a mesh that is extracted anew. RENDER thread.
void ReportRaycaching(ReportContext& context);

} // namespace hasp
