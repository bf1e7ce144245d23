#include "SurfaceActors.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"

#if HASP_WITH_CELLS
#include "vtkHaspClusteredCellMapper.h"
#endif
#include "vtkActor.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkSTLReader.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

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
  return { actor.Get(), [use](ResourceList& list) { list.push_back(use); } };
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

/// VTK's reader takes what is there of a binary STL file that is cut off, without a word.
void RequireWholeStl(const std::string& path, const std::string& name)
{
  std::array<char, 84> start{}; // text, and the number of triangles
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), start.size());
  if (std::string_view(start.data(), 5) == "solid") // STL as text; the reader sees its end
    return;
  std::uint32_t count = 0;
  std::memcpy(&count, start.data() + 80, sizeof count);
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error || bytes < start.size() + std::uintmax_t(50) * count)
    throw Failure(ExitCode::BadInput, name + ": declares " + std::to_string(count) +
                                        " triangles, the file is too short for them: it is cut "
                                        "off or no STL. Copy it again");
}

/// One wild corner would push all else out of the picture, or make the surface invisible.
void RequirePlausible(vtkPolyData* mesh, const std::string& name)
{
  constexpr double farthestMm = 1e6; // a kilometre: no patient, and no wrong unit either
  for (vtkIdType n = 0; n < mesh->GetNumberOfPoints(); ++n)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(mesh->GetPoint(n)[axis]) <= farthestMm))
        throw Failure(ExitCode::BadInput,
          name + ": has a corner that is no number or a kilometre away; write it again, in mm");
}

#if HASP_WITH_CELLS
SurfaceActor MakeCellIsosurface(vtkImageData* image, double isoValue, Session& session)
{
  session.progress.Step("extracting active cells");
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputDataObject(image);
  mapper->SetIsoValue(isoValue);
  mapper->UpdateCells();
  ThrowVtkError(ExitCode::BadInput, "cannot extract the active cells");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkSmartPointer<vtkHaspClusteredCellMapper> kept = mapper.Get();
  return { actor.Get(), [kept](ResourceList& list)
    {
      kept->ListResources(list);
      list.push_back({ "mesh", 0, 0.0, "--mapper cells draws without one" });
    } };
}
#endif

} // namespace

const std::vector<std::string>& SurfaceMappers()
{
#if HASP_WITH_CELLS
  static const std::vector<std::string> names{ "cells", "mesh" };
#else
  static const std::vector<std::string> names{ "mesh" };
#endif
  return names;
}

SurfaceActor MakeIsosurface(
  vtkImageData* image, double isoValue, const std::string& mapper, Session& session)
{
#if HASP_WITH_CELLS
  if (mapper == "cells")
    return MakeCellIsosurface(image, isoValue, session);
#endif
  if (mapper == "mesh")
    return MakeMeshIsosurface(image, isoValue, session);
  throw Failure(ExitCode::WrongUse, "this build has no mapper '" + mapper + "'");
}

SurfaceActor MakeSurface(const std::string& path, std::size_t number, Session& session)
{
  RequireInput(path);
  const std::string name =
    "surface " + std::to_string(number) + (FileNamesShown() ? ", " + FileLabel(path) : "");
  session.progress.Step("reading " + name);
  RequireWholeStl(path, name);
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  const ResourceUse read = UpdateMesh(reader, name, "--surface", session);
  ThrowVtkError(ExitCode::BadInput, name + ": cannot be read as STL");
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
    throw Failure(ExitCode::BadInput, name + ": no triangles in it; give an STL file");
  RequirePlausible(reader->GetOutput(), name);
  vtkNew<vtkPolyDataNormals>
    normals; // STL has none at its points; edges stay sharp from 30 degrees
  normals->SetInputConnection(reader->GetOutputPort());
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOff();
  const ResourceUse smooth = UpdateMesh(normals, read.resource, read.reason, session);
  return MakeMeshActor(normals->GetOutput(),
    { read.resource, smooth.bytes, read.milliseconds + smooth.milliseconds, read.reason });
}

} // namespace hasp
