#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"
#include "Planning/GuideRecipe.h"
#include "Planning/Osteotomy.h"

#include <span>
#include <vector>

namespace hasp
{

/// What a guide is made of: everything but its mesh, which SharpContour makes of the solid on the
/// grid.
struct GuideSolid
{
  SolidPointer solid;
  GridGeometry grid; ///< its z is the withdrawal direction
  /// As it was made: its withdrawal is unit and that which was found (no search is left to make),
  /// and the slots of the blades stand behind its own. What ClaimsOf asks for.
  GuideRecipe recipe;
  double undercut = -1.0; ///< share of the bone's area that it does not reach, if it was searched
};

/// The tree of vtkHaspGuideFilter, free of VTK: see there for what is made.
///
///   ((shell + boxes + flanges + sleeves + letters) in the room) - slots - holes - letters
///
/// The room is what is farther from bone than the gap, undercuts blocked out (GuideBone.h), and not
/// in pores and clefts; the shell is what is nearer to bone than the outer wall, in the region and
/// the room, with a round edge between the first two, where it is thick enough (GuideWalls.h): one
/// thinner than 4.5 spacings is looked at on a finer grid for that, of 4.5 to its thickness.
///
/// blades   of planned cuts: the guide gets a slot for each (Planning/GuideSlots.h). The slot's
///          point is where the blade's middle line, or the line nearest to that, enters bone from
///          above; all of the box below the blade's top is looked at
///
/// Throws std::invalid_argument (recipe, volume) and std::runtime_error (no such guide can be
/// made), naming the landmark, slot, hole or label; Cancelled. Any thread; all cores.
GuideSolid MakeGuideSolid(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, const ProgressFunction& progress = {});

/// A guide's values on a coarser grid of the same extent: a quick look without a mesh.
struct GuideSamples
{
  GridGeometry grid;
  std::vector<float> values; ///< x fastest; mm to the surface, INSIDE >= 0, cut off at 3 spacings
};

/// spacingMm   at least the working grid's, else std::invalid_argument
/// Cancelled. Any thread; all cores; O(samples near the surface).
GuideSamples SampleGuide(
  const GuideSolid& guide, double spacingMm, const ProgressFunction& progress = {});

/// The solid to take such a look at: made on the coarsest working grid up to spacingMm that the
/// recipe and its blades allow, so that it takes a fraction of MakeGuideSolid's time. What is
/// thinner than that grid may be missing, and thin edges of a shell below 4.5 of its spacings stay;
/// balls that enter pores are larger with it. Errors are MakeGuideSolid's, of the recipe's own
/// grid, which takes as long. Any thread; all cores.
GuideSolid MakePreviewSolid(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, double spacingMm);

/// A guide ready to be written. All of `made` but its surface is in `solid`.
struct BuiltGuide
{
  TriangleMesh mesh;
  GuideSolid made;
};

/// The same, contoured: one closed piece. Errors and threads as above.
BuiltGuide BuildGuide(const AnyGridView& ct, const GuideRecipe& recipe,
  std::span<const Osteotomy> blades, const ProgressFunction& progress = {});

} // namespace hasp
