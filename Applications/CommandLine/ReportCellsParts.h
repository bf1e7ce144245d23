#pragma once
#include "CellScene.h"

namespace hasp
{

struct ReportContext;

/// The parts of `hasp report cells`. Each measures on the scene it is given, checks what it
/// measured and puts rows into the report. RENDER thread.

/// For the exponents of growth.
struct CellSize
{
  double bytes, extractionS;
};
/// cells.extract, cells.bytes.*, cells.compact.*
CellSize ReportCellBytes(ReportContext& context, const CellScene& scene);
/// cells.edit: boxes of 1% of the volume
void ReportCellEdits(ReportContext& context, const CellScene& scene);
/// cells.depth.*, cells.missed.*: every renderer against a root in long double
void ReportCellDepth(ReportContext& context, const CellScene& scene, int pixels);
/// cells.frame.*: against a mesh, culling on and off; `large` names the row of the bar
void ReportCellFrames(ReportContext& context, const CellScene& scene, int pixels, bool large);
/// cells.rays.*: against Embree's triangles
void ReportCellRays(ReportContext& context, const CellScene& scene, int pixels);
/// cells.missed.random, cells.depth.max.random: rays from anywhere to anywhere
void ReportRandomRays(ReportContext& context, const CellScene& scene, std::int64_t rays);
/// cells.stream.gib: n^3 samples in a file, in a process of its own
void ReportCellStream(ReportContext& context, int n);

} // namespace hasp
