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

/// How far along the third axis marked samples go inside the polygon or within `reach` of it; at
/// least `low`.
double Highest(const GridGeometry& ct, std::span<const std::uint8_t> marked, const glm::dmat3& axes,
  std::span<const glm::dvec2> polygon, double reach, double low)
{
  const glm::dmat3 step = glm::transpose(axes) * ct.IndexToWorldMatrix();
  const glm::dvec3 first = ct.origin * axes;
  std::size_t n = 0;
  for (int k = 0; k < ct.dims.z; ++k)
    for (int j = 0; j < ct.dims.y; ++j)
      for (int i = 0; i < ct.dims.x; ++i, ++n)
        if (marked[n])
          if (const glm::dvec3 p = first + step * glm::dvec3(i, j, k);
              p.z > low && PolygonDistance(glm::dvec2(p), polygon) <= reach)
            low = p.z;
  return low;
}
} // namespace

GuideFrame::GuideFrame(
  const GuideRecipe& recipe, const GridGeometry& ct, std::span<const std::uint8_t> keep)
  : Recipe(recipe)
{
  const glm::dmat3 axes = AxesAlong(recipe.withdrawal);
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
  if (recipe.outline == GuideOutline::Filled) // bone may bulge between the landmarks
    high.z = Highest(ct, keep, axes, this->Polygon, 0.5 * recipe.widthMm, high.z) +
             glm::length(ct.spacing); // its surface is less than a cell beyond its samples
  low -= margin;
  high += margin;
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
