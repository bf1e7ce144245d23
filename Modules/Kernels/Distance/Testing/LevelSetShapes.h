#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <vector>

namespace hasp
{

/// A grid turned about the world's origin, which is its middle.
inline GridGeometry Turned(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  GridGeometry g;
  g.dims = dims;
  g.spacing = spacing;
  g.direction = glm::dmat3(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(1, 2, 2)));
  g.origin = -g.direction * (0.5 * glm::dvec3(g.Cells()) * spacing);
  return g;
}

inline std::vector<float> SampledSolid(const ImplicitSolid& solid, const GridGeometry& g)
{
  std::vector<float> values;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        values.push_back(static_cast<float>(solid.At(g.IndexToWorld({ i, j, k }))));
  return values;
}

} // namespace hasp
