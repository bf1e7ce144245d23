#pragma once
#include "GapColours.h"

#include "Grid/GridView.h"
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <vector>

namespace hasp
{

/// What of a part faces bone, told as MeasureGuideGap tells it, by the middle of each triangle.
struct InnerWall
{
  std::vector<Colour> colours; ///< of each triangle: GapColour, or NoInnerWall
  glm::dvec3 away{ 0.0 };      ///< its area's mean way off the bone; 0 without any
};

/// Of claims with a shell. Throws as DistanceToIsosurface does. All cores.
InnerWall FindInnerWall(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims);

} // namespace hasp
