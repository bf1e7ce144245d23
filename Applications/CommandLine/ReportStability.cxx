#include "ReportStability.h"

#include "CellChecks.h"
#include "DistanceCases.h"
#include "ExtremeVolumes.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"
#if HASP_WITH_REDUCTION
#include "ReductionTrials.h"
#endif
#include "ReportRegistry.h"
#include "StabilityChecks.h"
#include "StabilityTrial.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

/// Predicted: so many active cells, each corner as in the volume; compact cells with the same
/// signs.
void CheckExtraction(ReportContext& context, const ExtremeVolume& volume)
{
  const AnyGridView grid = ViewImage(volume.image);
  const ClusteredCells exact = ExtractActiveCells(grid, MinMaxBlocks(grid), volume.isovalue);
  const LosslessCheck check = CheckLossless(grid, exact);
  const double off = std::abs(double(exact.Count()) - double(volume.activeCells)) +
                     double(check.activeInVolume - check.cells) + double(check.wrongCorners);
  AddStability(context, "stability.extraction",
    volume.name + ": " + std::to_string(volume.activeCells) + " active cells", off, 0.0,
    "cells and corners that differ");
  const CompactShift shift = MeasureShift(grid, CompactCells(exact));
  AddStability(context, "stability.compact", volume.name + ": the same signs",
    double(shift.changedCells), 0.0, "cells that differ");
}

void CheckVolume(ReportContext& context, const ExtremeVolume& volume, int pixels)
{
  CheckExtraction(context, volume);
  CheckStablePicture(context, volume.name,
    IsosurfaceView(volume.image, volume.isovalue, pixels, pixels, ObliqueView), volume);
}

/// Predicted: refused, by std::invalid_argument.
void CheckRefusals(ReportContext& context, const ExtremeVolume& ball)
{
  const AnyGridView grid = ViewImage(ball.image);
  const MinMaxBlocks blocks(grid);
  const auto refused = [&](const std::string& name, const std::function<void()>& call)
  {
    double figure = 1.0;
    try
    {
      call();
    }
    catch (const std::invalid_argument&)
    {
      figure = 0.0;
    }
    AddStability(context, "stability.refused", name, figure, 0.0, "accepted");
  };
  for (const auto& [name, isovalue] :
    { std::pair("isovalue NaN", std::nan("")), std::pair("isovalue infinite", HUGE_VAL),
      std::pair("isovalue 1e300, infinite as a float", 1e300) })
    refused(name, [&, value = isovalue] { ExtractActiveCells(grid, blocks, value); });
  refused("min-max blocks of another grid", [&] { ExtractActiveCells(grid, {}, 0.0); });
  const std::vector<std::uint8_t> thread(4 * 65538);
  const GridView<const std::uint8_t> tooLong{ thread.data(),
    { { 65538, 2, 2 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) } };
  refused("65,538 samples along an axis",
    [&] { ExtractActiveCells(tooLong, MinMaxBlocks(AnyGridView(tooLong)), 0.5); });
}

void AddShare(ReportContext& context)
{
  const auto& rows = context.report.stability;
  const auto held =
    std::count_if(rows.begin(), rows.end(), [](const ReportCase& row) { return row.pass; });
  ReportRow share;
  share.id = "stability.pass";
  share.value = double(held) / double(rows.size());
  share.unit = "share of cases whose outcome is the predicted one";
  share.rival =
    "the prediction: closed forms, the rule by brute force, roots in long double, spectral radii";
  share.n = int(rows.size());
  ReportRow count = share;
  share.better = Better::Higher;
  count.id = "stability.rows";
  count.value = double(rows.size());
  count.unit = "cases";
  context.report.rows.insert(context.report.rows.end(), { share, count });
}

} // namespace

void ReportStability(ReportContext& context)
{
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  const int pixels = context.settings.quick ? 100 : 300;
  const std::vector<ExtremeVolume> volumes = ExtremeVolumes();
  double done = 0.0;
  for (const ExtremeVolume& volume : volumes)
  {
    context.progress(done++ / double(volumes.size() + 1), "stability: " + volume.name);
    CheckVolume(context, volume, pixels);
  }
  const ExtremeVolume ball = OrdinaryBall();
  context.progress(done / double(volumes.size() + 1), "stability: eyes");
  CheckStableEyes(context, ball, pixels);
  CheckRefusals(context, ball);
  TryDistanceCases(context);
  TryStability(context);
#if HASP_WITH_REDUCTION
  TryReductionExtremes(context);
#endif
  AddShare(context);
}

} // namespace hasp
