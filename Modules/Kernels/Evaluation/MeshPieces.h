#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace hasp
{

/// A piece of a mesh: triangles connected through edges.
struct MeshPiece
{
  std::size_t triangles = 0;
  double volumeMm3 = 0.0; ///< signed; negative: a hollow, or turned inside out
  glm::dvec3 low{ 0.0 }, high{ 0.0 };
};

/// The pieces of a mesh, that of the greatest volume first. Points are told apart by index: weld
/// the mesh first (WeldPoints). Throws std::invalid_argument if a triangle names a point that is
/// not there. Any thread; O(triangles log triangles), one core.
std::vector<MeshPiece> MeshPieces(const TriangleMesh& mesh);

} // namespace hasp
