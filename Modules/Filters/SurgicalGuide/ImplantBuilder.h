#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"
#include "ImplantRim.h"
#include "Planning/ImplantRecipe.h"

#include <vector>

namespace hasp
{

/// What an implant is made of: everything but its mesh, which SharpContour makes of the solid on
/// the grid.
struct ImplantSolid
{
  SolidPointer solid;
  GridGeometry grid;  ///< its z is the axis
  MirrorPlane mirror; ///< given or fitted; what it gives is laid on the rim besides
  LaidTable laid;
  glm::dvec3 axis;               ///< unit, out of the head: it is put in against it
  std::vector<glm::dvec3> holes; ///< where each one's axis comes out of the outer face
};

/// The tree of vtkHaspImplantFilter, free of VTK: see there for what is made.
///
///   shell(mirrored bone, filled below its outer table, laid on the rim) & footprint - holes
///
/// The footprint is what columns along the axis leave that meet no bone at the height of the
/// implant or above it, less the clearance (ImplantFootprint.h): so the edge is upright, clear of
/// bone, and the implant can be put in. Seen along the axis the clearance is exact where the hole's
/// wall is narrowest. Tongues narrower than the implant is thick are left out, and corners that
/// stick out are round by half of that.
/// Throws std::invalid_argument (recipe, volume, over 2e8 grid points) and std::runtime_error (no
/// such implant can be made), naming what and where; Cancelled. Any thread; all cores.
/// Limit: bone above the grid (half the outline's width over it) is not seen.
ImplantSolid MakeImplantSolid(
  const AnyGridView& ct, const ImplantRecipe& recipe, const ProgressFunction& progress = {});

/// An implant ready to be written: one closed piece.
struct BuiltImplant
{
  TriangleMesh mesh;
  ImplantSolid made;
};
BuiltImplant BuildImplant(
  const AnyGridView& ct, const ImplantRecipe& recipe, const ProgressFunction& progress = {});

} // namespace hasp
