#include "CellActors.h"

#include "Failure.h"
#include "Isosurface/ActiveCells.h"
#include "VtkMessages.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspRayCachingMapper.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>

namespace hasp
{
namespace
{

constexpr double WindowBudget = 50; // ms a frame of a window may take: 20 frames a second

template <typename Mapper>
std::optional<WorldPoint> PickIsosurface(
  Mapper* mapper, const WorldPoint& from, const WorldPoint& to)
{
  vtkNew<vtkHaspPickedCell> picked;
  if (!mapper->PickFirstCell(from.data(), to.data(), picked))
    return std::nullopt;
  const double* at = picked->GetPosition();
  return WorldPoint{ at[0], at[1], at[2] };
}

/// "traced: traced in 31.0 ms, rasterised in 412.5 ms" becomes "traced".
std::string Way(const std::string& choice)
{
  return choice.substr(0, choice.find(':'));
}

std::optional<WorldBounds> BoundsOf(const ClusteredCells& cells)
{
  if (cells.Count() == 0)
    return std::nullopt;
  const glm::dmat3 steps = cells.geometry.IndexToWorldMatrix();
  const auto extent = [&](const auto& least) // of one cell from its first corner
  {
    return least(steps[0], glm::dvec3(0)) + least(steps[1], glm::dvec3(0)) +
           least(steps[2], glm::dvec3(0));
  };
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const CellCluster& cluster : cells.clusters)
    for (int bit = 0; bit < 512; ++bit)
      if (const glm::ivec3 inCluster(bit & 7, bit >> 3 & 7, bit >> 6); cluster.Active(inCluster))
      {
        const glm::dvec3 corner =
          cells.geometry.IndexToWorld(glm::dvec3(cluster.Origin() + inCluster));
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
  low += extent([](const auto& a, const auto& b) { return glm::min(a, b); });
  high += extent([](const auto& a, const auto& b) { return glm::max(a, b); });
  return WorldBounds{ low.x, high.x, low.y, high.y, low.z, high.z };
}

SurfaceActor MakeRayActor(const vtkSmartPointer<vtkHaspRayCachingMapper>& mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  SurfaceActor result;
  result.prop = actor.Get();
  result.listResources = [mapper](ResourceList& list)
  {
    mapper->ListResources(list);
    list.push_back({ "mesh", 0, 0.0, "rays need none" });
  };
  result.setIsoValue = [mapper](double value) { mapper->SetIsoValue(value); };
  result.drewBy = [mapper] { return Way(mapper->GetModeChoice()); };
  result.pick = [mapper](const auto& from, const auto& to)
  { return PickIsosurface(mapper.Get(), from, to); };
  result.bounds = [mapper]
  {
    return IsosurfaceBounds(
      vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0)), mapper->GetIsoValue());
  };
  return result;
}

vtkSmartPointer<vtkHaspRayCachingMapper> RayMapper(vtkImageData* image, double isoValue, int mode)
{
  auto mapper = vtkSmartPointer<vtkHaspRayCachingMapper>::New();
  mapper->SetInputData(image);
  mapper->SetIsoValue(isoValue);
  mapper->SetMode(mode);
  return mapper;
}

/// What both mappers of active cells know.
template <typename Mapper>
void SetDrawing(const vtkSmartPointer<Mapper>& mapper, const SurfaceDrawing& drawing)
{
  const auto& names = CellRendererNames(); // in the order of the mappers' Renderers
  mapper->SetRenderer(
    static_cast<int>(std::find(names.begin(), names.end(), drawing.renderer) - names.begin()));
  ThrowVtkError(ExitCode::WrongUse, "--renderer " + drawing.renderer);
  mapper->SetAmbientOcclusion(drawing.ambientOcclusionMm.has_value());
  if (drawing.ambientOcclusionMm)
    mapper->SetAmbientOcclusionDistance(*drawing.ambientOcclusionMm);
  mapper->SetShadows(drawing.shadows);
}

} // namespace

SurfaceActor MakeCellActor(vtkDataObject* input, double isoValue, const SurfaceDrawing& drawing)
{
  auto mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
  SetDrawing(mapper, drawing);
  if (drawing.compact)
    mapper->SetPrecisionToCompact();
  mapper->SetBlendNormals(drawing.blendNormals);
  mapper->SetInputDataObject(input);
  mapper->SetIsoValue(isoValue);
  mapper->UpdateCells();
  ThrowVtkError(ExitCode::BadInput, "cannot extract the active cells");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  SurfaceActor result;
  result.prop = actor.Get();
  result.listResources = [mapper](ResourceList& list)
  {
    mapper->ListResources(list);
    list.push_back({ "mesh", 0, 0.0, "active cells are drawn without one" });
  };
  if (vtkImageData::SafeDownCast(input))
    result.setIsoValue = [mapper](double value) { mapper->SetIsoValue(value); };
  result.drewBy = [mapper] { return "active cells, " + Way(mapper->GetRendererChoice()); };
  result.pick = [mapper](const auto& from, const auto& to)
  { return PickIsosurface(mapper.Get(), from, to); };
  result.bounds = [mapper]
  {
    mapper->UpdateCells();
    return BoundsOf(mapper->GetCells());
  };
  return result;
}

SurfaceActor MakeCachingActor(vtkImageData* image, double isoValue, const SurfaceDrawing& drawing)
{
  const auto mapper = RayMapper(image, isoValue,
    drawing.interactive || drawing.Lit() ? vtkHaspRayCachingMapper::Automatic
                                         : vtkHaspRayCachingMapper::Cache);
  SetDrawing(mapper, drawing);
  if (drawing.interactive)
    mapper->SetFrameBudget(WindowBudget);
  else
  {
    mapper->SetRaysPerTile(256); // one a pixel: complete soon
    mapper->PredictionOff();     // the other eye's place is no way that the camera takes
  }
  SurfaceActor result = MakeRayActor(mapper);
  result.refining = [mapper] { return mapper->IsRefining(); };
  return result;
}

SurfaceActor MakeRaycastActor(vtkImageData* image, double isoValue)
{
  return MakeRayActor(RayMapper(image, isoValue, vtkHaspRayCachingMapper::RaycastSkipping));
}

std::function<std::optional<WorldPoint>(double, const WorldPoint&, const WorldPoint&)>
IsosurfaceRays(vtkImageData* image)
{
  return [image = vtkSmartPointer<vtkImageData>(image),
           mapper = vtkSmartPointer<vtkHaspRayCachingMapper>()](
           double isoValue, const WorldPoint& from, const WorldPoint& to) mutable
  {
    if (!mapper)
      mapper = RayMapper(image, isoValue, vtkHaspRayCachingMapper::RaycastSkipping);
    mapper->SetIsoValue(isoValue);
    return PickIsosurface(mapper.Get(), from, to);
  };
}

std::optional<WorldBounds> IsosurfaceBounds(vtkImageData* image, double isoValue)
{
  const AnyGridView grid = ViewImage(image);
  return BoundsOf(ExtractActiveCells(grid, MinMaxBlocks(grid), isoValue));
}

} // namespace hasp
