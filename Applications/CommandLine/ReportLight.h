#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report light`: whether global light is right (furnaces, closed forms, reciprocity), error
/// against time of even points, of paths and of light that is kept, and rays a second against
/// triangles. Says what is absent in a build without Embree. RENDER thread.
void ReportLight(ReportContext& context);

} // namespace hasp
