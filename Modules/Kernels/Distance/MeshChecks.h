#pragma once
#include "Grid/TriangleMesh.h"

#include <string>

namespace hasp
{

/// What all that fill meshes ask of them: points are finite, triangles name points that are there,
/// and pass each edge as often one way as the other, so that there is no rim. Points need not be
/// shared, only equal. Throws std::invalid_argument, `who` before what is wrong; where the mesh
/// ends, mm. O(edges log edges).
void RequireClosedMesh(const std::string& who, const TriangleMesh& mesh);

} // namespace hasp
