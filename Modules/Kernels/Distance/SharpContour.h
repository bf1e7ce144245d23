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
  std::size_t mostTriangles = 200'000'000; ///< 5 GB of a mesh; more are refused: before the work
                                           ///< where twice as many are to be expected
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

/// The surface of a solid with its edges and corners: a closed 2-manifold that does not meet
/// itself, proven for the coordinates returned. These are those of 32-bit floats, as an STL file
/// keeps them.
///
/// solid    its faces, continued, are asked for where they meet (FaceAt)
/// grid     its points are asked for their side. What reaches the border is cut flat, an eighth
///          of a cell before it.
/// Method: a hybrid of the hybrid points of Ju and Udeshi 2006 ("Intersection-free contouring on an
/// octree grid") and the features of Kobbelt et al. 2001 ("Feature sensitive surface extraction"),
/// on Kuhn's tetrahedra, six to a cell, as those of ContourTetrahedra. A crossing is the root of
/// the solid's value on an edge. In a triangle between two crossings goes the point where their
/// faces meet in its plane, or two if a third face cuts that off; in a tetrahedron the corner of
/// its faces, or a point of their crease, and a fan from it to the closed line on its boundary.
/// Where that fan's triangles look into the solid, as where two creases pass through, there are two
/// fans, each round a point of a crease, or the best of the fans that its faces offer (ours).
/// Points are held in their triangle or tetrahedron, so that no fan leaves its own, and moved back
/// to where the surface is on the way, so that they do not stand out of it. Where the tip
/// of a wedge comes through an edge whose ends do not see it, or that of a corner through a
/// triangle, a point in the tip divides all tetrahedra there first (ours); so it does where an edge
/// is crossed three times. A triangle's line or a tetrahedron's fan that is more than 0.04 of a
/// cell off is made again of parts, twice at most, with a vertex at that place. Parts are divided
/// only by tips that are as deep: what a shallower one would give is thinner than what it mends.
/// What is in an edge or a triangle follows from it alone, so that neighbours agree.
///
/// Why it does not meet itself: the surface divides its tetrahedra into smaller ones, and none of
/// them is turned over when its points are rounded (DividedTetrahedron.h). Each is looked at; the
/// center of a fan that fails moves towards the middle, bends of a line that leave a triangle
/// thinner than 32 steps of floats are left out before. Nothing falls back to another method.
///
/// Points keep 1 % of an edge from its ends, more where floats are coarse: 1.6 times the root of
/// their step / the edge, 25 % at most. So a face along grid points moves inwards by that.
/// Limits: what is thinner than a cell may be missing, but for the tips of wedges; of a tetrahedron
/// that holds two corners one is bevelled. Along bevels narrower than a cell 0.005 squares of cells
/// of triangles, on each cell of length, may still be folded; of 3,461 tetrahedra with two fans one
/// in 20 is 0.08 to 0.29 of a cell off. Other edges of planes are true to 0.08 of a
/// cell (the radius of a fillet as far off). Where round walls of 1 to 3 cells' radius meet an
/// edge, parts can be too thin to be divided again: of engraved text one triangle in 50,000 is 0.08
/// to 0.16 of a cell off, in no mesh of 79 more than one in 5,000; of strokes that meet at any
/// angle one in 80,000, 0.08 to 0.22, in no mesh of 120 more than one in 2,400. Of 8,000 corners of
/// boxes 86 of 100 are exact and 97 within 0.1 of a cell; the others, whose faces come through a
/// triangle as a strip narrower than a cell, lose up to 0.34. Outwards no point of 3,000 turned
/// parts, thin ones among them, is more than 0.16 of a cell off. A curved face is true to
/// `tolerance`.
///
/// Returns world millimetres, points welded, triangles counter-clockwise seen from outside. Empty
/// if nothing is inside.
/// Throws std::invalid_argument on an invalid grid or setting, where floats come in steps above a
/// thousandth of a cell, for more than mostTriangles, and 2^32 - 1 points; std::runtime_error if
/// the solid is steeper than it says, so that the surface was left open, and if a tetrahedron is
/// turned over (not seen); Cancelled. Any thread; all cores, the same bits on any number of them.
/// Lazy: the solid is asked once for each block of 8^3 cells, and more only near its surface.
/// About 1.5 us a triangle of a simple solid, one core; memory is that of the mesh, and of 4,096
/// blocks.
TriangleMesh SharpContour(const ImplicitSolid& solid, const GridGeometry& grid,
  const SharpContourSettings& settings = {}, SharpContourFacts* facts = nullptr,
  const ProgressFunction& progress = {});

} // namespace hasp
