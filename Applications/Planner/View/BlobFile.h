#pragma once
#include "Grid/Progress.h"
#include "Planning/DerivedPart.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <string>

/// Blobs of a plan's folder as VTK's data, read as any file that comes from outside is. A blob has
/// no name that says what it is: it passes through a file that has one, in a folder of its own
/// within the plan's. WORKER. Throw std::runtime_error (disk, damage) without a path; Cancelled.
namespace hasp
{

/// A label map: unsigned short.
vtkSmartPointer<vtkImageData> ReadLabelBlob(
  const std::filesystem::path& folder, const std::string& blob, const ProgressFunction& progress);

/// A part's mesh, with normals to be drawn by: points at edges sharper than 30 degrees are doubled.
vtkSmartPointer<vtkPolyData> ReadMeshBlob(const std::filesystem::path& folder,
  const std::string& blob, PartFormat format, const ProgressFunction& progress);

/// The same normals for any mesh; `whole`: no point is doubled, so that a closed mesh stays closed.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh, bool whole = false);

} // namespace hasp
