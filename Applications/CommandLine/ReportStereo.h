#pragma once

namespace hasp
{

struct ReportContext;

/// Random balls drawn by the eye rig and by VTK's stereo, in turn: how far their middles lie from
/// where geometry puts them, and what a pair of eyes costs. Rows: stereo.place.max and
/// stereo.pair.time, each for balls as meshes and as volumes (VTK GPU ray caster).
/// Counting whole pixels and the perspective of a ball limit the first to about 0.2 pixel: what VTK
/// itself reaches on meshes.
/// Then the parts below.
void ReportStereo(ReportContext& context);

/// stereo.disparity.max: a ball in a room, several heads, every layout, on a screen and (.hmd) in a
/// head-mounted display, against closed form; bar 0.5 pixel, aim 0.1. stereo.pair.time: what a pair
/// of eyes costs in each layout, against VTK's.
void ReportStereoLayouts(ReportContext& context);

/// stereo.silhouette: outlines of each mapper in each eye against those of a mesh; no worse than in
/// mono. With HASP_WITH_CELLS.
void ReportStereoSilhouettes(ReportContext& context);

} // namespace hasp
