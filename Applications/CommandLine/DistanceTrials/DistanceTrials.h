#pragma once
#include "RivalTransform.h"

#include <functional>
#include <string>
#include <vector>

namespace hasp
{

struct BooleanRival;
struct PlainContour;
struct ReportContext;

/// What `hasp report distance` measures. Free of VTK; rivals that need it are handed in. Each puts
/// rows into the report. WORKER.

/// distance.rms.chamfer_aa.*: what anti-aliasing of <3,4,5> is worth on offsets, as the papers
/// claim; distance.offset.*: the guides' transform there.
void TryChamfer(ReportContext& context);

/// distance.rms.guide, distance.max.guide, distance.rms.far: what the guides' transform is off by
/// on exact coverage; distance.cost.*: its time against anti-aliased <3,4,5>.
void TryGuides(ReportContext& context);

/// distance.rms.ct: the same of blurred and noisy images.
void TryScans(ReportContext& context);

/// distance.speed.edt: exact Euclidean distances against those rivals that are exact, too;
/// distance.field.*: the guides' transform against all of them.
void TryRivals(ReportContext& context, const std::vector<RivalTransform>& rivals);

/// distance.error_time: all transforms at several sizes.
void DrawCurves(ReportContext& context, const std::vector<RivalTransform>& rivals);

/// distance.wall: the thinnest place of a shell around a bone as a scanner sees it.
void TryShell(ReportContext& context);

/// contour.manifold, contour.crossing, contour.fallback: so many random trees of solids, each at
/// three voxel sizes.
void TryContour(ReportContext& context, int trees);

/// contour.flatness, contour.edge, contour.hole: a block with a slot and a hole; beside it a plain
/// contour's.
void TrySharpness(ReportContext& context, const PlainContour& plain);

/// contour.boolean_rival: a mesh Boolean's share of good results, of so many trees.
void TryBooleans(ReportContext& context, const BooleanRival& rival, int trees);

/// What is not made where nothing asks for it.
void AddUnusedDistances(ReportContext& context);

} // namespace hasp
