#pragma once
#include "Grid/TriangleMesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hasp
{

/// Pairs of triangles that meet other than in a shared edge or point, by CGAL's exact predicates on
/// the coordinates as they stand.
/// Throws std::invalid_argument on a triangle without area and on a mesh that is no oriented
/// 2-manifold: CheckMesh counts them. A library of its own
/// (Hasp::KernelSelfIntersections, HASP_ENABLE_CGAL), since CGAL's mesh processing is GPL.
/// Any thread; O(triangles log triangles) where few meet.
std::vector<std::array<std::uint32_t, 2>> FindSelfIntersections(const TriangleMesh& mesh);

/// How many there are.
std::size_t CountSelfIntersections(const TriangleMesh& mesh);

} // namespace hasp
