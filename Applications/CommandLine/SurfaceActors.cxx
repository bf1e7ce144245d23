#include "SurfaceActors.h"

#include "Failure.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VolumeActors.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"

#if HASP_WITH_CELLS
#include "CellActors.h"
#endif
#include "vtkActor.h"
#include "vtkCellLocator.h"
#include "vtkFlyingEdges3D.h"
#include "vtkHaspClusteredCells.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <chrono>

namespace hasp
{
namespace
{

constexpr std::size_t KiB = 1024; // vtkDataObject::GetActualMemorySize counts in these

/// Updates the filter and says what it made.
ResourceUse UpdateMesh(vtkPolyDataAlgorithm* filter, const std::string& resource,
  const std::string& reason, Session& session)
{
  ShowProgress(session, filter);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  return { resource, KiB * filter->GetOutput()->GetActualMemorySize(), spent.count(), reason };
}

/// The first triangle along the line. The tree is built by the first question and by a change.
std::optional<WorldPoint> PickMesh(
  vtkCellLocator* locator, vtkPolyData* mesh, const WorldPoint& from, const WorldPoint& to)
{
  if (mesh->GetNumberOfCells() == 0)
    return std::nullopt;
  locator->SetDataSet(mesh);
  locator->Update();
  WorldPoint point;
  double t = 0.0, inCell[3];
  int part = 0;
  if (!locator->IntersectWithLine(from.data(), to.data(), 0.0, t, point.data(), inCell, part))
    return std::nullopt;
  return point;
}

SurfaceActor MakeMeshActor(vtkPolyData* mesh, const ResourceUse& use)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  SurfaceActor result;
  result.prop = actor.Get();
  result.listResources = [use](ResourceList& list) { list.push_back(use); };
  result.drewBy = [] { return "mesh"; };
  result.pick = [locator = vtkSmartPointer<vtkCellLocator>::New(),
                  kept = vtkSmartPointer<vtkPolyData>(mesh)](const auto& from, const auto& to)
  { return PickMesh(locator, kept, from, to); };
  result.bounds = [kept = vtkSmartPointer<vtkPolyData>(mesh)]() -> std::optional<WorldBounds>
  {
    WorldBounds box;
    if (kept->GetNumberOfCells() == 0)
      return std::nullopt;
    kept->GetCellsBounds(box.data());
    return box;
  };
  return result;
}

SurfaceActor MakeMeshIsosurface(vtkImageData* image, double isoValue, Session& session)
{
  session.progress.Step("extracting the mesh");
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, isoValue);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  const auto use =
    std::make_shared<ResourceUse>(UpdateMesh(contour, "mesh", "--mapper mesh", session));
  ThrowVtkError(ExitCode::BadInput, "cannot extract the mesh");
  SurfaceActor result = MakeMeshActor(contour->GetOutput(), *use);
  result.listResources = [use](ResourceList& list)
  {
    list.push_back({ "active cells", 0, 0.0, "--mapper mesh" });
    list.push_back(*use);
  };
  result.setIsoValue = [use, kept = vtkSmartPointer<vtkFlyingEdges3D>(contour)](double value)
  {
    kept->SetValue(0, value);
    const auto start = std::chrono::steady_clock::now();
    kept->Update();
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    use->bytes = KiB * kept->GetOutput()->GetActualMemorySize();
    use->milliseconds = spent.count();
  };
  return result;
}

} // namespace

const std::vector<std::string>& SurfaceMappers()
{
#if HASP_WITH_CELLS
  static const std::vector<std::string> names{ "cells", "raycaching", "raycast", "mesh", "vtk" };
#else
  static const std::vector<std::string> names{ "mesh", "vtk" };
#endif
  return names;
}

const std::vector<std::string>& VolumeMappers()
{
  static const std::vector<std::string> names{ "mip", "composite" };
  return names;
}

const std::vector<std::string>& CellRendererNames()
{
  static const std::vector<std::string> names{ "automatic", "rasterize", "trace" };
  return names;
}

SurfaceActor MakeIsosurface(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing, Session& session)
{
#if HASP_WITH_CELLS
  if (drawing.mapper == "cells")
  {
    session.progress.Step("extracting active cells");
    return MakeCellActor(image, isoValue, drawing);
  }
  if (drawing.mapper == "raycaching")
    return MakeCachingActor(image, isoValue, drawing);
  if (drawing.mapper == "raycast")
    return MakeRaycastActor(image, isoValue);
#endif
  if (drawing.mapper == "mesh")
    return MakeMeshIsosurface(image, isoValue, session);
  if (drawing.mapper == "vtk")
    return MakeVolumeActor(image, isoValue);
  throw Failure(ExitCode::WrongUse, "this build has no mapper '" + drawing.mapper + "'");
}

SurfaceActor MakeVolume(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing, Session& session)
{
  if (drawing.mapper == "mip")
    return MakeBrightestActor(image, drawing);
  if (drawing.mapper == "composite")
    return MakeTranslucentActor(image, isoValue, drawing);
  return MakeIsosurface(image, isoValue, drawing, session);
}

SurfaceActor MakeCells(
  [[maybe_unused]] vtkHaspClusteredCells* cells, [[maybe_unused]] const SurfaceDrawing& drawing)
{
#if HASP_WITH_CELLS
  return MakeCellActor(cells, 0.0, drawing);
#else
  throw Failure(ExitCode::WrongUse, "this build cannot draw active cells");
#endif
}

SurfaceActor MakeSurface(const std::string& path, std::size_t number, Session& session)
{
  const std::string name =
    "surface " + std::to_string(number) + (FileNamesShown() ? ", " + FileLabel(path) : "");
  const auto start = std::chrono::steady_clock::now();
  const LoadedSurface read = ReadSurface(path, name, session.quiet, session);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  vtkNew<vtkPolyDataNormals> normals; // files bring none; edges stay sharp from 30 degrees
  normals->SetInputData(read.surface);
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOff();
  const ResourceUse smooth =
    UpdateMesh(normals, name, "--surface, " + read.passport.format, session);
  return MakeMeshActor(normals->GetOutput(),
    { name, smooth.bytes, spent.count() + smooth.milliseconds, smooth.reason });
}

} // namespace hasp
