#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <cstddef>

namespace hasp
{

struct SharpContourSettings
{
  double tolerance = 0.01; ///< of the grid's shortest spacing: how far a curved face may be from a
                           ///< triangle's side before that is broken in two; [0.001, 0.1]
};

/// What a contour was made of.
struct SharpContourFacts
{
  std::size_t blocks = 0;       ///< of 8^3 cells in the grid
  std::size_t blocksHeld = 0;   ///< that may hold surface, and were looked at
  std::size_t cells = 0;        ///< of those, the same
  std::size_t splits = 0;       ///< of edges and triangles through which a tip came
  std::size_t creasePoints = 0; ///< of triangles, where faces meet
  std::size_t keptInside = 0;   ///< points that were held in their triangle or tetrahedron
  double leastHeight = 1e30;    ///< of the parts of divided tetrahedra, in steps of floats: proof
                                ///< that the surface does not meet itself
};

/// The surface of a solid with its edges and corners: a closed 2-manifold without
/// self-intersections, by construction, also after its coordinates are rounded to the 32-bit floats
/// of an STL file.
///
/// solid    its faces, continued, are asked for where they meet (FaceAt)
/// grid     the grid's points are asked for their side; a face along them moves inwards by the
///          margin below. What reaches the border is cut flat, an eighth of a cell before it.
/// Each cell is cut into Kuhn's six tetrahedra, as by ContourTetrahedra. Where the tip of a wedge
/// comes through an edge whose ends do not see it, or that of a corner through a triangle, a point
/// in the tip divides all tetrahedra there; the order follows from edges and triangles alone, so
/// that neighbours agree. A crossing is the root of the solid's value on its edge. In a triangle
/// between two crossings goes the point where their faces meet in the triangle's plane, or two if a
/// third face cuts that off, held inside the triangle; in the tetrahedron the corner of its faces,
/// or a point of their crease, held inside, and a fan from it to the closed line on the
/// tetrahedron's boundary. Such a fan, from a point inside of a convex body, cannot meet itself,
/// nor leave the body: that is why there is no fall-back (so argue, for cubes, Ju and Udeshi 2006;
/// features of faces that meet are those of Kobbelt et al. 2001; tips are ours).
///
/// Points keep a margin from the ends of an edge, a quarter of it from the sides of a triangle, an
/// eighth from those of a tetrahedron. It is 1 % of the edge, up to 5 % where the steps of floats
/// are coarse against the grid; fans grow flatter before a triangle gets thinner than eight steps.
///
/// Returns world millimetres, points welded, triangles counter-clockwise seen from outside. Empty
/// if nothing is inside. Limits: what is thinner than a cell may be missing, but for the tips of
/// wedges; of a tetrahedron that holds two corners one is bevelled.
/// Throws std::invalid_argument on an invalid grid or setting, where floats come in steps above a
/// thousandth of a cell, and for more than 2^32 - 1 points; std::runtime_error if the solid is
/// steeper than it says, so that the surface was left open; Cancelled. Any thread; all cores, the
/// same bits on any number of them. Lazy: the solid is asked once for each block of 8^3 cells, and
/// more only near its surface. About 1.5 us a triangle of a simple solid, one core.
TriangleMesh SharpContour(const ImplicitSolid& solid, const GridGeometry& grid,
  const SharpContourSettings& settings = {}, SharpContourFacts* facts = nullptr,
  const ProgressFunction& progress = {});

} // namespace hasp
