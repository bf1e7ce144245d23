// Frame times of clustered cells against a mesh of the same surface, same camera, light and window.
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

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

void AddUnused(ReportContext& context, const IsosurfaceMethod& method)
{
  ResourceList& unused = context.report.unused;
  for (const ResourceUse& use : method.Resources())
    if (use.bytes == 0 && use.milliseconds == 0.0 &&
        std::none_of(unused.begin(), unused.end(),
          [&](const ResourceUse& known) { return known.resource == use.resource; }))
      unused.push_back(use);
}

void AddCurve(ReportContext& context, const std::string& method, double ms, double error)
{
  const std::string id = "cells.error_time@bone";
  for (ReportCurve& curve : context.report.curves)
    if (curve.id == id && curve.method == method)
      return curve.points.push_back({ ms, error });
  context.report.curves.push_back({ id, method, "ms", "voxel RMS", { { ms, error } } });
}

/// What drawing holds beside the kernel's cells, which stay in memory to answer picks.
void AddDrawingBytes(ReportContext& context, const CellScene& scene, const NamedMethod& renderer,
  const DepthErrors& errors, const PairedTimes& times)
{
  const IsosurfaceMethod& method = *renderer.method;
  std::size_t bytes = 0;
  std::string list;
  for (const ResourceUse& use : method.Resources())
    if (use.bytes > 0 && use.resource != "active cells, host" && use.resource != "min-max blocks")
    {
      bytes += use.bytes;
      list += ", " + use.resource + " " + std::to_string(use.bytes);
    }
  context.report.rows.push_back(FixedFigure("cells.bytes.drawing." + renderer.id + scene.tag,
    double(bytes) / double(method.Bytes()), "of the kernel's bytes", "the cells in the kernel",
    { errors.rms, "voxel RMS" }, times, scene.data + list));
}

std::string Rms(double voxels)
{
  char text[60];
  std::snprintf(text, sizeof text, "; its error %.4f voxel RMS", voxels);
  return text;
}

} // namespace

void ReportCellFrames(ReportContext& context, const CellScene& scene, int pixels, bool large)
{
  context.progress(0.0, "cells: frames of " + scene.data);
  const IsosurfaceView view(scene.image, scene.isovalue, pixels, pixels, Oblique);
  const DepthTruth truth(view);
  const auto mesh = MakeMeshMethod(view);
  mesh->Draw();
  const double meshRms = MeasureRival(truth, mesh->Points()).rms;
  const std::string data = scene.data + ", " + std::to_string(pixels) + "^2 pixels";
  bool first = true; // the renderer that a scene gets that asks for none
  for (const NamedMethod& renderer : CellRenderers(view))
  {
    for (int frame = 0; frame < SettlingFrames; ++frame)
      renderer.method->Draw();
    const DepthErrors errors = MeasureDepth(truth, renderer.method->Points());
    const PairedTimes times = ComparePairs([&] { return TimeOf([&] { renderer.method->Draw(); }); },
      [&] { return TimeOf([&] { mesh->Draw(); }); }, { 1, 9 });
    const std::string rival = mesh->Name() + Rms(meshRms);
    const ReportRow row = TimedRatio("cells.frame." + renderer.id + scene.tag, times, rival,
      { errors.rms, "voxel RMS" }, data + ", " + renderer.method->Name());
    context.report.rows.push_back(row);
    AddCurve(context, "clustered cells, " + renderer.id, 1e3 * times.a.wallS, errors.rms);
    AddDrawingBytes(context, scene, renderer, errors, times);
    if (!first)
      continue;
    first = false;
    if (large)
      context.report.rows.emplace_back(row).id = "cells.frame.large";
    AddCurve(context, mesh->Name(), 1e3 * times.b.wallS, meshRms);
    AddUnused(context, *renderer.method);
  }
}

} // namespace hasp
