#include "SurfaceActors.h"

#include "Failure.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"

#if HASP_WITH_CELLS
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRayCachingMapper.h"
#endif
#include "vtkActor.h"
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

SurfaceActor MakeMeshActor(vtkPolyData* mesh, const ResourceUse& use)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return { actor.Get(), [use](ResourceList& list) { list.push_back(use); }, {} };
}

SurfaceActor MakeMeshIsosurface(vtkImageData* image, double isoValue, Session& session)
{
  session.progress.Step("extracting the mesh");
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, isoValue);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  const ResourceUse use = UpdateMesh(contour, "mesh", "--mapper mesh", session);
  ThrowVtkError(ExitCode::BadInput, "cannot extract the mesh");
  SurfaceActor result = MakeMeshActor(contour->GetOutput(), use);
  result.listResources = [use](ResourceList& list)
  {
    list.push_back({ "active cells", 0, 0.0, "--mapper mesh" });
    list.push_back(use);
  };
  return result;
}

#if HASP_WITH_CELLS
/// `input` is an image, or cells, whose isovalue is their own.
SurfaceActor MakeCellActor(vtkDataObject* input, double isoValue, const CellDrawing& drawing)
{
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  const auto& names = CellRendererNames(); // in the order of the mapper's Renderers
  mapper->SetRenderer(
    static_cast<int>(std::find(names.begin(), names.end(), drawing.renderer) - names.begin()));
  ThrowVtkError(ExitCode::WrongUse, "--renderer " + drawing.renderer);
  if (drawing.compact)
    mapper->SetPrecisionToCompact();
  mapper->SetAmbientOcclusion(drawing.ambientOcclusionMm.has_value());
  if (drawing.ambientOcclusionMm)
    mapper->SetAmbientOcclusionDistance(*drawing.ambientOcclusionMm);
  mapper->SetShadows(drawing.shadows);
  mapper->SetInputDataObject(input);
  mapper->SetIsoValue(isoValue);
  mapper->UpdateCells();
  ThrowVtkError(ExitCode::BadInput, "cannot extract the active cells");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkSmartPointer<vtkHaspClusteredCellMapper> kept = mapper.Get();
  return { actor.Get(),
    [kept](ResourceList& list)
    {
      kept->ListResources(list);
      list.push_back({ "mesh", 0, 0.0, "active cells are drawn without one" });
    },
    {} };
}

/// mode: of vtkHaspRayCachingMapper::Modes. Nothing is extracted before the first frame.
SurfaceActor MakeCachingActor(vtkImageData* image, double isoValue, int mode)
{
  auto mapper = vtkSmartPointer<vtkHaspRayCachingMapper>::New();
  mapper->SetInputData(image);
  mapper->SetIsoValue(isoValue);
  mapper->SetMode(mode);
  mapper->SetRaysPerTile(256); // one picture, complete soon
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return { actor.Get(),
    [mapper](ResourceList& list)
    {
      mapper->ListResources(list);
      list.push_back({ "mesh", 0, 0.0, "rays need none" });
    },
    [mapper] { return mapper->IsRefining(); } };
}
#endif

} // namespace

const std::vector<std::string>& SurfaceMappers()
{
#if HASP_WITH_CELLS
  static const std::vector<std::string> names{ "cells", "raycaching", "raycast", "mesh" };
#else
  static const std::vector<std::string> names{ "mesh" };
#endif
  return names;
}

const std::vector<std::string>& CellRendererNames()
{
  static const std::vector<std::string> names{ "automatic", "rasterize", "trace" };
  return names;
}

SurfaceActor MakeIsosurface(vtkImageData* image, double isoValue, const std::string& mapper,
  [[maybe_unused]] const CellDrawing& drawing, Session& session)
{
#if HASP_WITH_CELLS
  if (mapper == "cells")
  {
    session.progress.Step("extracting active cells");
    return MakeCellActor(image, isoValue, drawing);
  }
  if (mapper == "raycaching")
    return MakeCachingActor(image, isoValue, vtkHaspRayCachingMapper::Cache);
  if (mapper == "raycast")
    return MakeCachingActor(image, isoValue, vtkHaspRayCachingMapper::RaycastSkipping);
#endif
  if (mapper == "mesh")
    return MakeMeshIsosurface(image, isoValue, session);
  throw Failure(ExitCode::WrongUse, "this build has no mapper '" + mapper + "'");
}

SurfaceActor MakeCells(
  [[maybe_unused]] vtkHaspClusteredCells* cells, [[maybe_unused]] const CellDrawing& drawing)
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
