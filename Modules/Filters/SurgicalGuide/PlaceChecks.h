#pragma once
#include "Grid/GridGeometry.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace hasp
{

/// A place that a recipe names, as its key: "landmarks[2]".
struct NamedPlace
{
  std::string name;
  glm::dvec3 point{ 0.0 }; ///< mm
};

/// Whether all are in the volume or within `marginMm` of it: to be asked before any work is done.
/// Throws std::runtime_error "WHO: NAME (x, y, z) is outside the volume" of the first that is not;
/// if all would be in it in other units, or turned from RAS, that is said. O(places).
void CheckInVolume(const char* who, const GridGeometry& volume,
  const std::vector<NamedPlace>& places, double marginMm = 0.0);

} // namespace hasp
