#pragma once
#include "Distance/ImplicitSolid.h"
#include "PlatePath.h"

#include <vector>

namespace hasp
{

/// A screw's axis where it passes through the plate.
struct PlacedScrew
{
  glm::dvec3 axis;  ///< unit, out of the bone
  glm::dvec3 outer; ///< where the axis comes through the plate's outer face, world mm
  glm::dvec3 inner; ///< and through the one on the bone
};

/// Places the recipe's screws on a plate along `path`.
///
/// bone      as it is: each shaft must go through some of it
/// surface   what the plate lies on: bone, bridged
/// Throws std::runtime_error, naming the screw, if it is over 3 mm from bone, leans on the plate by
/// over 45 degrees, its shaft meets no bone, its head's or bore's rim is nearer to the plate's edge
/// than edgeDistanceMm, its head does not sit in the plate, or it clashes with another: rims nearer
/// than holeDistanceMm, or shafts that meet. Where an axis leans, a rim is taken as the circle
/// around its ellipse. A head sits in the plate where the outer face is nowhere around it so low
/// that the cone ends above it, and the bore below the cone is everywhere at least half as long as
/// in a flat plate: else the plate would end in a knife's edge there.
std::vector<PlacedScrew> PlaceScrews(const ImplicitSolid& bone, const ImplicitSolid& surface,
  const PlatePath& path, const PlateRecipe& recipe);

/// What a screw takes away: the bore through the plate, the cone of its head, and its room above.
SolidPointer MakeScrewHole(const PlateScrew& screw, const PlacedScrew& placed);

} // namespace hasp
