#pragma once
#include "vtkHaspLabelFile.h"

#include <optional>
#include <string>

/// Label maps and scans that verbs read, and which is which.
namespace hasp
{

struct Session;

/// The labels of a file, as LoadLabels gives them, with its names on the image, too
/// (vtkHaspLabelTable.h). Throws Failure: BadInput, also where they look like a scan's values: more
/// than 64 of them, and most voxels are not like the one before them.
LoadedLabels ReadLabels(
  const std::string& path, const std::optional<GridGeometry>& onto, Session& session);

/// Of a volume that labels shall be made of. Throws Failure: BadInput for a .seg.nrrd file. Says so
/// where other files look like labels: whole numbers from 0 on, at most 64 different ones. `path`
/// is what was read.
void RequireScan(const LoadedVolume& volume, const std::string& path, Session& session);

} // namespace hasp
