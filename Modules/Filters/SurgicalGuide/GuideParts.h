#pragma once
#include "Distance/ImplicitSolid.h"
#include "Planning/GuideRecipe.h"

#include <glm/mat3x3.hpp>

#include <string>
#include <vector>

namespace hasp
{

/// A part of a guide that is not the shell, and a box that holds it: where to look for it.
struct GuidePart
{
  std::string name; ///< in errors: "slots[2]", "the sleeve of holes[0]"
  SolidPointer solid;
  glm::dvec3 center;
  glm::dmat3 axes;
  glm::dvec3 half;
};

/// What is joined with the shell, before bone and its gap are taken away, and what is taken away
/// after it.
struct GuideParts
{
  std::vector<GuidePart> added; ///< boxes of slots, flanges, sleeves
  std::vector<GuidePart> taken; ///< slots, the room before flanges, holes; upwards without an end
};

/// Of a recipe that is valid, with unit directions. Any thread.
GuideParts MakeGuideParts(const GuideRecipe& recipe);

/// Whether at least four places of a lattice of `spacingMm` are in the part and in the solid; only
/// within `where`'s box is looked. Any thread; O(lattice).
bool PartMeets(const GuidePart& part, const ImplicitSolid& solid, double spacingMm,
  const ImplicitSolid::Box& where);

} // namespace hasp
