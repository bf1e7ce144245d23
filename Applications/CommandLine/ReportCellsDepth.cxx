// Where each renderer of clustered cells puts the surface, against a root in long double.
#include "ReportCellsParts.h"

#include "CellDepth.h"
#include "CellRenderers.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{
namespace
{

const char* const Truth = "a walk from cell to cell and bisection, both in long double";
const glm::dvec3 Oblique = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

struct Worst
{
  MeasuredError depth{ -1.0, "voxel" }, missed{ -1.0, "share of surface pixels" };
  Timing depthTime, missedTime;
  std::string depthBy, missedBy;
};

void AddRenderer(ReportContext& context, const CellScene& scene, const DepthTruth& truth,
  const NamedMethod& renderer, int pixels, Worst& worst)
{
  for (int frame = 1; frame < SettlingFrames; ++frame)
    renderer.method->Draw();
  const Timing time = TimeOf([&] { renderer.method->Draw(); });
  const DepthErrors errors = MeasureDepth(truth, renderer.method->Points());
  const std::string name = renderer.method->Name();
  const auto add = [&](const std::string& what, double value, const std::string& data)
  {
    context.report.rows.push_back(ErrorFigure("cells.depth." + what + "." + renderer.id + scene.tag,
      { value, "voxel" }, Truth, time, scene.data + ", " + name + data));
  };
  add("rms", errors.rms, "");
  add("p99", errors.p99, "");
  add("max", errors.max,
    ", at pixel " + std::to_string(errors.maxAt % pixels) + "," +
      std::to_string(errors.maxAt / pixels));
  add("max.grazing", errors.maxAll, ", rays that graze (cosine < 0.2) too");
  const MeasuredError missed{ errors.MissedShare(), "share of surface pixels" };
  context.report.rows.push_back(ErrorFigure("cells.missed." + renderer.id + scene.tag, missed,
    Truth, time, scene.data + ", " + name + ", " + errors.Text()));
  if (errors.max > worst.depth.value)
    worst = { { errors.max, "voxel" }, worst.missed, time, worst.missedTime, name, worst.missedBy };
  if (missed.value > worst.missed.value)
    worst = { worst.depth, missed, worst.depthTime, time, worst.depthBy, name };
}

} // namespace

void ReportCellDepth(ReportContext& context, const CellScene& scene, int pixels)
{
  context.progress(0.0, "cells: depth on " + scene.data);
  const IsosurfaceView view(scene.image, scene.isovalue, pixels, pixels, Oblique);
  const DepthTruth truth(view);
  Worst worst;
  std::vector<NamedMethod> renderers = CellRenderers(view);
  if (auto tracer = MakeTracerMethod(view))
    renderers.push_back({ "rays", std::move(tracer) });
  for (const NamedMethod& renderer : renderers)
    AddRenderer(context, scene, truth, renderer, pixels, worst);
  context.report.rows.push_back(ErrorFigure("cells.depth.max" + scene.tag, worst.depth, Truth,
    worst.depthTime, scene.data + ", the worst of all renderers: " + worst.depthBy));
  context.report.rows.push_back(ErrorFigure("cells.missed" + scene.tag, worst.missed, Truth,
    worst.missedTime, scene.data + ", the worst of all renderers: " + worst.missedBy));
}

} // namespace hasp
