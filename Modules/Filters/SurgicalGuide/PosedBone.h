#pragma once
#include "Distance/ImplicitSolid.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Planning/PlateRecipe.h"

#include <optional>
#include <span>

namespace hasp
{

/// A scan, and whose bone each voxel is.
struct BoneScan
{
  AnyGridView grey;
  std::optional<AnyGridView> labels =
    std::nullopt; ///< of the same grid; needed where fragments are moved
};

/// The bone near a part, where it shall be.
///
/// region   what must be known of it: the box, world mm. Bone is cut off flat somewhere beyond.
/// Each fragment is its own distances (CoverageDistance) on a grid with the scan's axes, moved by
/// its pose; without fragments bone is all of the scan that is not in islands below ignoreBelowMm3.
/// Throws std::invalid_argument, beginning with "plate", without labels for fragments, with labels
/// of another grid, and over 2e8 grid points; std::runtime_error if there is no bone in the region;
/// Cancelled. Any thread; all cores.
SolidPointer PosedBone(const BoneScan& scan, const PlateRecipe& recipe,
  const ImplicitSolid::Box& region, const ProgressFunction& progress);

/// The closing of a solid by a ball: what such a ball cannot enter from outside is filled. Lines of
/// fracture are bridged, convex places stay where they are.
///
/// region, spacingMm   of the grid that it is sampled on, axes of the world
/// A bound within what CoverageDistance errs by; cut off flat at the region's border. Throws
/// std::runtime_error if the region holds none of the solid, nor of what is radiusMm around it.
SolidPointer BridgedSolid(const ImplicitSolid& solid, double radiusMm,
  const ImplicitSolid::Box& region, double spacingMm, const ProgressFunction& progress);

/// GridIn, around a box of the world.
GridGeometry GridAround(
  const char* who, const ImplicitSolid::Box& box, const glm::dmat3& axes, double spacingMm);

/// The least box that holds all points and `margin` around them.
ImplicitSolid::Box BoxAround(std::span<const glm::dvec3> points, double margin);

} // namespace hasp
