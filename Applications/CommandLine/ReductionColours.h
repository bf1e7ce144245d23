#pragma once

namespace hasp
{

struct ReportContext;

/// Colours of distance that follow a fragment (vtkHaspSurfaceDistance), ball before ball, whose
/// distance is known in closed form: reduction.colours.ms, CPU time of an Update after nothing but
/// the pose has changed; .rms and .max, how far distances are off; .speed, how many times as fast
/// as vtkImplicitPolyDataDistance, a place. RENDER thread.
void TryColours(ReportContext& context);

} // namespace hasp
