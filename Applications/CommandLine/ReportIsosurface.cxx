#include "ReportIsosurface.h"

#include "Grid/AnalyticVolumes.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCaster.h"
#include "IsosurfaceComparison.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

namespace hasp
{
namespace
{

const glm::dvec3 Oblique = glm::normalize(glm::dvec3(-0.6, 1.0, -0.4));

/// A volume whose surface is known in closed form.
struct Case
{
  std::string shapeName;
  AnalyticVolume shape;
  GridGeometry geometry;
};

/// 64 mm across whatever the number of samples: only the voxel changes.
Case MakeCase(const std::string& shape, int dims)
{
  const GridGeometry geometry{ glm::ivec3(dims), glm::dvec3(-32.0), glm::dvec3(64.0 / (dims - 1)),
    glm::dmat3(1) };
  return { shape,
    shape == "gyroid" ? AnalyticGyroid(16.0) : AnalyticSphere({ 0.1, -0.2, 0.3 }, 28.0), geometry };
}

glm::dvec3 Gradient(const AnalyticVolume& shape, const glm::dvec3& p)
{
  constexpr double h = 1e-5;
  glm::dvec3 gradient;
  for (int a = 0; a < 3; ++a)
  {
    glm::dvec3 step(0.0);
    step[a] = h;
    gradient[a] = shape.value(p + step) - shape.value(p - step);
  }
  return gradient;
}

/// The first surface inside the volume's box; a ray that starts inside the solid meets its far
/// side.
std::optional<TrueHit> FirstInBox(
  const Case& c, const glm::dvec3& origin, const glm::dvec3& direction)
{
  double t0 = 0.0, t1 = 1e9;
  const glm::dvec3 low = c.geometry.origin;
  const glm::dvec3 high = c.geometry.IndexToWorld(glm::dvec3(c.geometry.dims - 1));
  for (int a = 0; a < 3; ++a)
  {
    const double u = (low[a] - origin[a]) / direction[a];
    const double v = (high[a] - origin[a]) / direction[a];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (!(t0 < t1))
    return std::nullopt;
  AnalyticVolume seen = c.shape;
  if (c.shape.value(origin + t0 * direction) > 0.0)
    seen.value = [&](const glm::dvec3& p) { return -c.shape.value(p); };
  const auto t = FirstSurface(seen, origin, direction, t0, t1);
  if (!t)
    return std::nullopt;
  const glm::dvec3 p = origin + *t * direction;
  // Within a voxel of the border the samples end on one side of the surface or the other.
  const glm::dvec3 margin = glm::min(p - low, high - p) / c.geometry.spacing;
  if (std::min({ margin.x, margin.y, margin.z }) < 1.0)
    return TrueHit{ p, 0.0 };
  return TrueHit{ p, std::abs(glm::dot(glm::normalize(Gradient(c.shape, p)), direction)) };
}

void CompareAll(IsosurfaceComparison& comparison, const IsosurfaceView& view)
{
  const auto mesh = MakeMeshMethod(view);
  comparison.Against(*mesh, "VTK mesh", "mesh");
  const auto direct = MakeDirectMethod(view);
  comparison.Against(*direct, "direct ray cast", "direct");
  for (const auto& [step, id] : { std::pair(1.0, "volume1"), std::pair(0.25, "volume025") })
    comparison.Against(*MakeVolumeMethod(view, step), "VTK GPU volume mapper", id);
  comparison.Finish(mesh->Bytes());
}

void RunAnalytic(ReportContext& context, const Case& c, int pixels)
{
  const auto image =
    MakeImage(c.geometry, SampleAnalytic<std::int16_t>(c.shape, c.geometry, 1000.0, 0.0));
  const IsosurfaceView view(image, 0.0, pixels, pixels, Oblique);
  SurfaceTruth truth = TraceTruth(view, [&](const glm::dvec3& origin, const glm::dvec3& direction)
    { return FirstInBox(c, origin, direction); });
  IsosurfaceComparison comparison(context, c.shapeName + std::to_string(c.geometry.dims.x),
    c.shapeName, c.geometry.spacing.x, view, std::move(truth));
  CompareAll(comparison, view);
}

/// The trilinear surface by the ray caster, itself within 1e-5 voxel of it.
SurfaceTruth TrilinearTruth(const IsosurfaceView& view)
{
  const AnyGridView grid = ViewImage(view.image);
  const MinMaxBlocks blocks(grid);
  const RayCaster caster(grid, blocks, view.isovalue);
  return TraceTruth(view,
    [&](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<TrueHit>
    {
      const auto hit = caster.Cast(origin, direction);
      if (!hit)
        return std::nullopt;
      return TrueHit{ hit->position, std::abs(glm::dot(glm::normalize(hit->gradient), direction)) };
    });
}

void RunRealVolume(ReportContext& context, int pixels)
{
  const std::string& path = context.settings.volume;
  if (!std::filesystem::exists(path))
  {
    ReportRow row;
    row.id = "isosurface.frame.mesh@cranium";
    row.rival = "all methods on a real CT";
    row.absent = "no real CT there: give --volume the path that Utilities/Scripts/cranium prints";
    context.report.rows.push_back(row);
    return;
  }
  const ReportVolume volume = ReadReportVolume(path);
  const double* spacing = volume.image->GetSpacing();
  const IsosurfaceView view(volume.image, volume.isovalue, pixels, pixels, Oblique);
  IsosurfaceComparison comparison(context, volume.name, volume.name,
    *std::min_element(spacing, spacing + 3), view, TrilinearTruth(view));
  CompareAll(comparison, view);
}

/// The cells on one hard case against the ray caster: largest distance, in voxels.
void AddStability(ReportContext& context, const std::string& name, const GridGeometry& geometry,
  double scale, const std::function<void(vtkCamera*)>& place)
{
  const auto sphere = AnalyticSphere({ 0, 0, 0 }, 20.0);
  IsosurfaceView view(
    MakeImage(geometry, SampleAnalytic<std::int16_t>(sphere, geometry, scale, 0.0)), 0.0, 200, 200,
    Oblique);
  place(view.camera);
  view.CameraMoved();
  const auto cells = MakeCellMethod(view);
  cells->Draw();
  const SurfaceErrors errors = MeasureErrors(view, TrilinearTruth(view), cells->Points());
  const glm::dvec3& s = geometry.spacing;
  const double figure = errors.maxMm / std::min({ s.x, s.y, s.z });
  constexpr double limit = 0.1;
  context.report.stability.push_back(
    { "isosurface.depth", name, figure <= limit && errors.missed <= 0.001 && errors.pixels > 1000,
      figure, limit, "voxel from the exact root" });
}

void RunStability(ReportContext& context)
{
  const auto grid = [](const glm::dvec3& spacing)
  {
    const glm::ivec3 dims(glm::dvec3(48.0) / spacing + 1.0);
    return GridGeometry{ dims, -0.5 * spacing * glm::dvec3(dims - 1), spacing, glm::dmat3(1) };
  };
  const auto stay = [](vtkCamera*) {};
  AddStability(context, "spacing 1 x 1 x 1 mm", grid({ 1, 1, 1 }), 100.0, stay);
  AddStability(context, "spacing 0.3 x 0.3 x 3 mm", grid({ 0.3, 0.3, 3.0 }), 100.0, stay);
  AddStability(context, "a step from -32768 to 32767", grid({ 1, 1, 1 }), 1e9, stay);
  AddStability(context, "slope of one grey level a voxel", grid({ 1, 1, 1 }), 1.0, stay);
  AddStability(context, "parallel projection", grid({ 1, 1, 1 }), 100.0,
    [](vtkCamera* camera)
    {
      camera->SetParallelProjection(true);
      camera->SetParallelScale(25.0);
    });
  AddStability(context, "eye 1e6 voxels away", grid({ 1, 1, 1 }), 100.0,
    [](vtkCamera* camera)
    {
      const glm::dvec3 eye = -1e6 * Oblique;
      camera->SetPosition(eye.x, eye.y, eye.z);
      camera->SetFocalPoint(0, 0, 0);
      camera->SetViewAngle(0.003);
      camera->SetClippingRange(1e6 - 50.0, 1e6 + 50.0);
    });
  AddStability(context, "eye inside the sphere", grid({ 1, 1, 1 }), 100.0,
    [](vtkCamera* camera)
    {
      camera->SetPosition(3, 4, 5);
      camera->SetFocalPoint(3, 5, 5);
      camera->SetViewAngle(70.0);
      camera->SetClippingRange(0.5, 60.0);
    });
}

} // namespace

void ReportIsosurface(ReportContext& context)
{
  RequireReportVolume(context.settings.volume);
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  const bool quick = context.settings.quick;
  const int pixels = quick ? 160 : 512;
  RunStability(context);
  for (const char* shape : { "sphere", "gyroid" })
    for (const int size : quick ? std::vector{ 48, 80 } : std::vector{ 128, 256 })
      RunAnalytic(context, MakeCase(shape, size), pixels);
  RunRealVolume(context, pixels);
}

} // namespace hasp
