#include "ReportLight.h"

#include "CellScene.h"
#include "LightScenes.h"
#include "LightTrials.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "RivalMesh.h"
#include "RivalTriangles.h"
#include "TransparencyTrial.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>

namespace hasp
{
namespace
{

/// On one surface: what depends on it.
void MeasureOn(ReportContext& context, const CellScene& scene)
{
  context.progress(0.0, "light: cells and mesh of " + scene.data);
  RivalMesh mesh(scene);
  mesh.Extract(scene.isovalue);
  const AnyGridView grid = ViewImage(scene.image);
  const glm::dvec3& spacing = GeometryOf(grid).spacing;
  const LightData data{ scene.tag, scene.data, CellsOf(grid, scene.isovalue),
    TrianglesOf(mesh.Mesh()), std::min({ spacing.x, spacing.y, spacing.z }) };
  const RivalTriangles triangles(mesh.Mesh());
  const RayRival rival{ triangles.Name(),
    [&](std::span<const WorldRay> rays, std::span<float> t)
    { triangles.Trace(rays, t, RivalTriangles::Packets::One); },
    [&](std::span<const WorldRay> rays, std::span<float> t) { triangles.Occluded(rays, t); } };
  MeasureEnergy(context, data);
  const bool quick = context.settings.quick;
  MeasureSobol(context, data, quick ? 200 : 1000);
  MeasureRays(context, data, rival);
  MeasureHybrid(context, data, quick ? HybridSettings() : HybridSettings{ 256, 1024, 256 });
}

void MeasureVolume(ReportContext& context)
{
  const std::string& path = context.settings.volume;
  if (!std::filesystem::exists(path))
  {
    context.report.rows.push_back(AbsentRow("light.hybrid.still@cranium", "paths anew on a real CT",
      "no real CT there: give --volume the path that Utilities/Scripts/cranium prints"));
    return;
  }
  const ReportVolume volume = ReadReportVolume(path);
  MeasureOn(context, { "@" + volume.name, volume.data, volume.image, volume.isovalue });
}

} // namespace

void ReportLight(ReportContext& context)
{
  RequireReportVolume(context.settings.volume);
  MeasureFurnace(context, context.settings.quick ? 512 : 4096);
  MeasureSphere(context);
  MeasureReciprocity(context);
  MeasureLightExtremes(context);
  MeasureLightScales(context);
  MeasureOn(context, HeadScene(context.settings.quick ? 96 : 200, context.settings.seed, true));
  MeasureVolume(context);
  ChooseWindows();
  MeasureTransparency(context);
  for (const char* id : { "light.furnace", "light.hybrid", "light.rays" })
    AddWorstLight(context, id);
  AddUnusedLight(context);
}

} // namespace hasp
