#pragma once
#include "Grid/GridView.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

struct ReportContext;

/// A real skull to be broken: HU. No samples: `absent` says why there is none.
struct RealSkull
{
  GridGeometry geometry{};
  std::vector<std::int16_t> samples{};
  std::string data{}; ///< "real CT, 256x256x108"
  std::string absent{};
};

/// What `hasp report segmentation` measures, free of VTK. Each puts rows into the report. WORKER.
///
/// Bones are broken with voxel truth (FractureCases.h) and shared out among the strokes of a
/// simulated user: at most 10, of at most 3 mm radius and 30 mm length, made from a coarse hint
/// alone (SimulatedStrokes.h).

/// segmentation.dice, segmentation.surface, of each case and of the worst;
/// segmentation.error_time: the same strokes for the random walker at several tolerances, for a
/// watershed and for thresholds with components; in quick reports of the mandible alone.
void TrySegmentation(ReportContext& context, const RealSkull& skull);

/// Samples after a Gaussian blur of a standard deviation, mm.
using BlurSamples = std::function<std::vector<float>(const AnyGridView&, double)>;

/// segmentation.dice.cbct, segmentation.surface.cbct: of simulated cone-beam scans, at most 15
/// strokes, with correction and without.
void TryConeBeam(ReportContext& context, const RealSkull& skull, const BlurSamples& blur);

/// segmentation.first, segmentation.resolve, segmentation.memory, segmentation.undo,
/// segmentation.warm: a skull of at least 8 M voxels of bone; a smaller one in quick reports.
void TryResolve(ReportContext& context);

/// segmentation.direct: probabilities against a sparse direct solver.
void TryDirect(ReportContext& context);

/// What is not made where nothing asks for it.
void AddUnusedSegmentation(ReportContext& context);

} // namespace hasp
