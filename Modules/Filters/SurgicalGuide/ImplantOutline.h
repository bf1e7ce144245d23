#pragma once
#include "Distance/ImplicitSolid.h"
#include "ImplantFootprint.h"
#include "Planning/ImplantRecipe.h"

namespace hasp
{

/// The axis that an implant is put in against, unit, out of the head: the recipe's, or upright on
/// the outline (its area vector).
///
/// head   middle of all bone
/// Throws std::runtime_error, beginning with "implant", if the outline lies on one line, and if the
/// recipe's axis is more than 60 degrees from upright on the outline or points into the head.
glm::dvec3 ImplantAxis(const ImplantRecipe& recipe, const glm::dvec3& head);

/// Around the outline and 8 mm of the bone outside it, its third axis along `axis`: as high as a
/// ball over the outline may bulge, and as deep as the implant may reach. Throws
/// std::invalid_argument over 2e8 points.
GridGeometry ImplantGrid(const ImplantRecipe& recipe, const glm::dvec3& axis);

/// As CheckInVolume does, within 3 mm: before any work.
void CheckOutlineInVolume(const ImplantRecipe& recipe, const GridGeometry& volume);

/// Throws std::runtime_error, naming the places, where a point of the outline is more than 3 mm
/// from bone, the outline crosses or touches itself seen along the grid's third axis, or there is
/// no bone below a place between two of its points, down to the grid's end, so that the hole is
/// open there.
void CheckOutline(const ImplantRecipe& recipe, const GridGeometry& grid, const ImplicitSolid& bone);

/// Depth of the grid's columns inside the outline, mm, negative outside.
ColumnLayer OutlineDepth(const ImplantRecipe& recipe, const GridGeometry& grid);

} // namespace hasp
