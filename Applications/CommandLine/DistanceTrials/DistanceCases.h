#pragma once

namespace hasp
{

struct ReportContext;

/// The cases of `hasp report stability` of distances and contours: extreme grids, images that are
/// no coverage, what is thinner than a voxel, and any number of threads. Each says beforehand what
/// comes. WORKER.
void TryDistanceCases(ReportContext& context);

/// Parts of it.
void TryDistanceGrids(ReportContext& context);
void TryDistanceImages(ReportContext& context);
void TryDistanceThreads(ReportContext& context);
void TryContourCases(ReportContext& context);

} // namespace hasp
