#pragma once

namespace hasp
{
struct ReportContext;

/// Error against time of the ways to draw an isosurface: clustered cells, VTK's mesh, VTK's GPU
/// volume mapper, direct ray casting; on analytic volumes of two sizes with closed-form truth, and
/// on the real CT where it is installed, with the double-precision ray caster as reference.
void ReportIsosurface(ReportContext& context);

} // namespace hasp
