#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

namespace hasp
{

/// The surface value = 0 of a field sampled at grid points, inside where value < 0: a closed
/// 2-manifold without self-intersections, by construction, also after its coordinates are rounded
/// to the 32-bit floats of an STL file.
///
/// field    negative inside, mm or any unit; 0, NaN and every point on the grid's border count as
///          outside, so that the surface always closes
/// Each cell is cut into the six Kuhn tetrahedra around its main diagonal, which match across
/// faces; each tetrahedron holds at most two triangles, and triangles of two tetrahedra meet only
/// in their common face. A crossing stays 2 % of an edge away from its ends, so that points and
/// triangles never collapse: that moves the surface by at most 2 % of a cell's diagonal, next to
/// grid points only. Returns world millimetres, points welded, triangles counter-clockwise seen
/// from outside. Empty if nothing is inside. Throws std::invalid_argument on an invalid geometry,
/// or if there are more than 2^32 - 1 points; Cancelled. Any thread; one core; O(points of the
/// grid).
TriangleMesh ContourTetrahedra(
  const GridView<const float>& field, const ProgressFunction& progress = {});

/// Connected pieces of a closed mesh with the signed volume of each, mm^3: negative for the wall of
/// a hollow inside another piece.
struct MeshPieces
{
  std::vector<std::uint32_t> pieceOfTriangle;
  std::vector<double> volume;
};
/// Triangles are connected if they share a point. Any thread; O(triangles).
MeshPieces FindPieces(const TriangleMesh& mesh);

/// The mesh without its pieces of |volume| below `leastMm3`: specks go and small hollows are
/// filled. Points no triangle uses are dropped. Any thread.
TriangleMesh WithoutSmallPieces(const TriangleMesh& mesh, double leastMm3);

} // namespace hasp
