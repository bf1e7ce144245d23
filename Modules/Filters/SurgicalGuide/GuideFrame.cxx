#include "GuideFrame.h"

#include "Distance/ImplicitShapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double MostVoxels = 2e8;

/// Right-handed axes with `z` as the third column.
glm::dmat3 AxesAlong(const glm::dvec3& z)
{
  glm::dvec3 least(0.0); // the world axis farthest from z
  const glm::dvec3 size = glm::abs(z);
  least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  const glm::dvec3 x = glm::normalize(glm::cross(least, z));
  return { x, glm::cross(z, x), z };
}
} // namespace

GuideFrame::GuideFrame(const GuideRecipe& recipe) : Recipe(recipe)
{
  const glm::dmat3 axes = AxesAlong(glm::normalize(recipe.withdrawal));
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec3& p : recipe.landmarks)
  {
    const glm::dvec3 local = p * axes; // transpose(axes) * p
    this->Polygon.emplace_back(local.x, local.y);
    low = glm::min(low, local);
    high = glm::max(high, local);
  }
  this->Deepest = low.z - 0.5 * recipe.widthMm;
  // Everything the guide's distance to bone can depend on, and a rim that stays outside.
  const double margin =
    0.5 * recipe.widthMm + recipe.gapMm + recipe.thicknessMm + 3.0 * recipe.spacingMm;
  glm::dvec3 above(margin);
  if (recipe.outline == GuideOutline::Filled) // bone may bulge between the landmarks
    above.z += 0.25 * glm::length(glm::dvec2(high - low));
  low -= margin;
  high += above;
  const glm::dvec3 count = glm::ceil((high - low) / recipe.spacingMm) + 1.0;
  if (!(count.x * count.y * count.z <= MostVoxels))
    throw std::invalid_argument("guide: the working grid would have " +
                                std::to_string(count.x * count.y * count.z) +
                                " voxels, at most 2e8 are allowed; raise spacingMm (now " +
                                std::to_string(recipe.spacingMm) + " mm)");
  this->Working = { glm::ivec3(count), axes * low, glm::dvec3(recipe.spacingMm), axes };
}

double GuideFrame::Region(const glm::dvec3& world) const
{
  const double reach = 0.5 * this->Recipe.widthMm;
  if (this->Recipe.outline != GuideOutline::Filled)
    return TubeDistance(
      world, this->Recipe.landmarks, this->Recipe.outline == GuideOutline::Closed, reach);
  const glm::dvec3 local = world * this->Working.direction;
  return std::max(
    PolygonDistance(glm::dvec2(local), this->Polygon) - reach, this->Deepest - local.z);
}

double GuideFrame::Slot(const GuideSlot& slot, const glm::dvec3& world) const
{
  const glm::dvec3 across = glm::normalize(glm::cross(slot.normal, this->Recipe.withdrawal));
  return std::max(SlabDistance(world, slot.point, slot.normal, slot.widthMm),
    SlabDistance(world, slot.point, across, slot.lengthMm));
}

double GuideFrame::Hole(const GuideHole& hole, const glm::dvec3& world)
{
  return CylinderDistance(world, hole.point, hole.axis, 0.5 * hole.diameterMm);
}

} // namespace hasp
