#pragma once
#include "Grid/TriangleMesh.h"

#include <cstddef>

namespace hasp
{

struct SheetMeshSettings
{
  double thicknessMm = 1.0; ///< (0, 100]
  /// True: the mesh is the front, and the material lies behind the face that its winding shows.
  /// False: half of it lies on either side.
  bool behind = true;
};

/// An open mesh as a closed one, a sheet: a front, a back, and walls along the rims. The back is
/// the front with each point moved along its normal (the mean of its triangles', by their angles
/// there). Points need not be shared, only equal within 1e-6 mm, and are not shared in the result.
///
/// Exact where the mesh is flat or a sphere; at edges the sheet is as thick as the cosine of half
/// the angle between their faces says. Where it is bent more than its thickness allows, front and
/// back meet: what fills the mesh by a flood (LevelSetOf) or takes twice for once (MeshCoverage)
/// makes one body of it. Triangles that have no normal are left out.
/// Throws std::invalid_argument if there are no triangles with a normal, a point is not finite, a
/// triangle names a point that is not there, or the thickness is out of range. Any thread; O(points
/// log points + triangles).
TriangleMesh SheetMesh(const TriangleMesh& mesh, const SheetMeshSettings& settings = {});

/// Edges that triangles do not pass as often one way as the other, points equal within 1e-6 mm made
/// one: the rims. None: the mesh is closed. Throws as above. `at` is the middle of the first, mm.
struct MeshRims
{
  std::size_t edges = 0;
  std::size_t loops = 0; ///< connected ones: holes, and the outline of an open mesh
  double longestMm = 0.0, lengthMm = 0.0; ///< of a loop; of all
  glm::dvec3 at{ 0.0 };
};
MeshRims FindRims(const TriangleMesh& mesh);

} // namespace hasp
