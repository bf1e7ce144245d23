#pragma once
#include "vtkHaspSurfaceFile.h"

#include "vtkPolyData.h"

#include <string>

namespace hasp
{

struct Session;

/// Reads a surface, with progress under `name` ("surface 1"), and says its warnings on standard
/// error unless `quiet`. Throws Failure: BadInput.
LoadedSurface ReadSurface(
  const std::string& path, const std::string& name, bool quiet, Session& session);

/// Bytes of points and triangles.
std::size_t BytesOf(const LoadedSurface& surface);

} // namespace hasp
