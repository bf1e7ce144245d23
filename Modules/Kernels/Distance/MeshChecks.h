#pragma once
#include "Grid/TriangleMesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// What all that fill meshes ask of them: points are finite, triangles name points that are there,
/// and pass each edge as often one way as the other, so that there is no rim. Points need not be
/// shared, only equal. Throws std::invalid_argument, `who` before what is wrong; where the mesh
/// ends, mm. O(edges log edges).
void RequireClosedMesh(const std::string& who, const TriangleMesh& mesh);
/// The same but for the rim.
void RequireFiniteMesh(const std::string& who, const TriangleMesh& mesh);
/// For each point the first that is equal to it. O(points log points).
std::vector<std::uint32_t> FirstEqualPoints(const std::vector<glm::dvec3>& points);

} // namespace hasp
