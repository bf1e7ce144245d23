#pragma once
#include "Surfaces/Lib3mf.h"
#include "XML/XMLWire.h"

#include <array>
#include <vector>

/// Rows of a 3 x 4 matrix that takes columns (x, y, z, 1).
using Transform = std::array<std::array<double, 4>, 3>;

/// One mesh where it is built.
struct BuiltMesh
{
  DWORD mesh; ///< its resource
  Transform place;
  hasp::ThreeMfObject record; ///< its size, and the name of the object that is built
};

struct TooManyObjects
{
};

/// What the model builds: components resolved, hence one mesh as often as it is named. Throws
/// TooManyObjects beyond 100,000, or of components 64 deep, and as Check3mf.
std::vector<BuiltMesh> BuiltMeshes(hasp::Lib3mfHandle model);
