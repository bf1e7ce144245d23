#pragma once
#include "Grid/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// A place on a mesh that stands for some of its area.
struct MeshSample
{
  glm::dvec3 point;
  glm::dvec3 normal; ///< unit, of its triangle, out of the solid
  double areaMm2;
  std::uint32_t triangle;
};

/// Triangles lower than this have no direction that 32-bit floats could hold: some 60 of their
/// steps 200 mm from the origin.
inline constexpr double SliverMm = 1e-3;

/// Places all over a mesh, in the order of its triangles: each is halved across its longest side
/// until that is at most `spacingMm` long, and its parts' centres are given. Triangles lower than
/// SliverMm are left out.
///
/// spacingMm   > 0; made larger for large parts, so that some 100,000 places are enough
/// Throws std::invalid_argument on a spacing out of range and a triangle whose points are not
/// there; std::runtime_error on triangles so long and thin that there would be over 4,000,000
/// places besides one of each. Any thread; O(places), one core.
std::vector<MeshSample> SampleMesh(const TriangleMesh& mesh, double spacingMm);

/// Twice the area over the longest side, mm; 0 without an area.
double HeightOf(const TriangleMesh& mesh, const glm::uvec3& triangle);

} // namespace hasp
