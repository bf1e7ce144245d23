#include "CellActors.h"

#include "Failure.h"
#include "VtkMessages.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>

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

} // namespace hasp
