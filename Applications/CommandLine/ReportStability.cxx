#include "ReportStability.h"

#include "CellChecks.h"
#include "CellDepth.h"
#include "CellRenderers.h"
#include "ExtremeVolumes.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"
#include "ReportRegistry.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

/// How far a renderer may be off, voxels: the bar of `hasp report cells`.
constexpr double DepthLimit = 1e-3;
/// The shader's division, scaling and offset round depth to float, the buffer to 24 bits.
constexpr double Roundings = 4.0;

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

void Add(ReportContext& context, const std::string& id, const std::string& testCase, double figure,
  double limit, const std::string& unit)
{
  context.report.stability.push_back({ id, testCase, figure <= limit, figure, limit, unit });
}

/// Predicted: so many active cells, each corner as in the volume; compact cells with the same
/// signs.
void CheckExtraction(ReportContext& context, const ExtremeVolume& volume)
{
  const AnyGridView grid = ViewImage(volume.image);
  const ClusteredCells exact = ExtractActiveCells(grid, MinMaxBlocks(grid), volume.isovalue);
  const LosslessCheck check = CheckLossless(grid, exact);
  const double off = std::abs(double(exact.Count()) - double(volume.activeCells)) +
                     double(check.activeInVolume - check.cells) + double(check.wrongCorners);
  Add(context, "stability.extraction",
    volume.name + ": " + std::to_string(volume.activeCells) + " active cells", off, 0.0,
    "cells and corners that differ");
  const CompactShift shift = MeasureShift(grid, CompactCells(exact));
  Add(context, "stability.compact", volume.name + ": the same signs", double(shift.changedCells),
    0.0, "cells that differ");
}

/// The largest way between two values of a 24-bit depth buffer, voxels: what a picture cannot say.
double DepthStep(const IsosurfaceView& view, const DepthTruth& truth)
{
  const glm::dvec3& s = GeometryOf(truth.grid).spacing;
  const glm::dmat4 worldToClip = glm::inverse(view.clipToWorld);
  double largest = 0.0;
  for (const auto& hit : truth.hits)
    if (hit)
    {
      glm::dvec4 clip = worldToClip * glm::dvec4(hit->position, 1.0);
      clip /= clip.w;
      const auto at = [&](double depth)
      {
        const glm::dvec4 p = view.clipToWorld * glm::dvec4(clip.x, clip.y, depth, 1.0);
        return glm::dvec3(p) / p.w;
      };
      largest = std::max(largest, glm::length(at(clip.z + 2.0 * 0x1p-24) - at(clip.z)));
    }
  return largest / std::min({ s.x, s.y, s.z });
}

/// Predicted: the surface where a root in long double has it, and nothing else. In a picture, cells
/// overlap by 1e-4 voxel: beside a hole of `volume` a pixel in a thousand may show a root just
/// outside its cell; and denormal samples may be gone.
void CheckPicture(ReportContext& context, const std::string& name, const IsosurfaceView& view,
  const ExtremeVolume& volume)
{
  const DepthTruth truth(view);
  std::vector<NamedMethod> renderers = CellRenderers(view);
  std::erase_if(
    renderers, [](const NamedMethod& r) { return r.id == "automatic"; }); // one of the others
  if (auto tracer = MakeTracerMethod(view))
    renderers.push_back({ "rays", std::move(tracer) });
  for (const NamedMethod& renderer : renderers)
  {
    renderer.method->Draw();
    const bool picture = renderer.id != "rays"; // those give the hit itself
    const DepthErrors errors = MeasureDepth(truth, renderer.method->Points());
    const bool gone = picture && volume.denormal && errors.missed == errors.surface;
    Add(context, "stability.missed." + renderer.id, name + ": " + errors.Text(),
      double((gone ? 0 : errors.missed) + errors.invented),
      picture && volume.holes ? 1e-3 * double(errors.surface) : 0.0, "pixels");
    Add(context, "stability.depth." + renderer.id, name, errors.max,
      picture ? DepthLimit + Roundings * DepthStep(view, truth) : DepthLimit, "voxel");
  }
}

void CheckVolume(ReportContext& context, const ExtremeVolume& volume, int pixels)
{
  CheckExtraction(context, volume);
  CheckPicture(context, volume.name,
    IsosurfaceView(volume.image, volume.isovalue, pixels, pixels, Oblique), volume);
}

/// Eyes, with an ordinary ball in view.
void CheckEyes(ReportContext& context, const ExtremeVolume& ball, int pixels)
{
  const auto look = [&](const std::string& name, const glm::dvec3& eye, const glm::dvec3& at,
                      double angle, double nearMm, double farMm, bool parallel = false)
  {
    IsosurfaceView view(ball.image, ball.isovalue, pixels, pixels, Oblique);
    view.camera->SetPosition(eye.x, eye.y, eye.z);
    view.camera->SetFocalPoint(at.x, at.y, at.z);
    view.camera->SetViewAngle(angle);
    view.camera->SetClippingRange(nearMm, farMm);
    view.camera->SetParallelProjection(parallel);
    view.camera->SetParallelScale(8.0);
    view.CameraMoved();
    CheckPicture(context, name, view, ball);
  };
  const double voxel = 0.7, far = 1e6 * voxel;
  // The ball is 13 mm across, the volume's diagonal 28.
  look("eye 1e6 voxels away", -far * Oblique, glm::dvec3(0), 0.0015, far - 15, far + 15);
  look("eye inside the ball", { 1, 2, 0.5 }, { 1, 3, 0.5 }, 80.0, 0.05, 30.0);
  look("eye on the surface", 0.4 * 24 * voxel * Oblique, glm::dvec3(0), 60.0, 0.01, 30.0);
  look("parallel projection", -30.0 * Oblique, glm::dvec3(0), 30.0, 5.0, 60.0, true);
  const GridGeometry grid = ImageGeometry(ball.image);
  for (int axis = 0; axis < 3; ++axis) // along the grid, the middle column of pixels in its planes
    look("rays along grid axis " + std::to_string(axis), -30.0 * grid.direction[axis],
      glm::dvec3(0), 30.0, 5.0, 60.0, true);
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
    Add(context, "stability.refused", name, figure, 0.0, "accepted");
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
    std::count_if(rows.begin(), rows.end(), [](const StabilityRow& row) { return row.pass; });
  ReportRow share;
  share.id = "stability.pass";
  share.value = double(held) / double(rows.size());
  share.unit = "share of cases whose outcome is the predicted one";
  share.rival = "the prediction: closed forms, the rule by brute force, roots in long double";
  share.n = int(rows.size());
  ReportRow count = share;
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
  CheckEyes(context, ball, pixels);
  CheckRefusals(context, ball);
  AddShare(context);
}

} // namespace hasp
