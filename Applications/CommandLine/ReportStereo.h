#pragma once

namespace hasp
{

struct ReportContext;

/// Random balls drawn by the eye rig and by VTK's stereo, in turn: how far their middles lie from
/// where geometry puts them, and what a pair of eyes costs. Rows: stereo.place.max and
/// stereo.pair.time, each for balls as meshes and as volumes (VTK GPU ray caster).
/// Counting whole pixels and the perspective of a ball limit the first to about 0.2 pixel: what VTK
/// itself reaches on meshes.
void ReportStereo(ReportContext& context);

} // namespace hasp
