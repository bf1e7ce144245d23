#include "GuideParts.h"

#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double EndlessMm = 20000.0; // farther than any place of a recipe from another
constexpr int LeastPlaces = 4;

std::string Name(const char* what, const char* list, std::size_t n)
{
  return std::string(what) + list + "[" + std::to_string(n) + "]";
}

/// All between `low` and `high` along the axes from a point.
struct Extent
{
  glm::dvec3 point;
  glm::dmat3 axes;
  glm::dvec3 low, high;

  glm::dvec3 Center() const { return this->point + this->axes * (0.5 * (this->low + this->high)); }
  glm::dvec3 Half() const { return 0.5 * (this->high - this->low); }
  GuidePart Part(std::string name, SolidPointer solid) const
  {
    return { std::move(name), std::move(solid), this->Center(), this->axes, this->Half() };
  }
  SolidPointer Box(double edgeRadius) const
  {
    return edgeRadius > 0.0 ? MakeRoundedBox(this->Center(), this->axes, this->Half(), edgeRadius)
                            : MakeBox(this->Center(), this->axes, this->Half());
  }
};

/// How far boxes and sleeves reach below their point, so that they stand in the shell.
double RootMm(const GuideRecipe& r)
{
  return r.gapMm + r.thicknessMm;
}

void AddSlot(const GuideRecipe& r, std::size_t n, GuideParts& parts)
{
  const GuideSlot& slot = r.slots[n];
  const double half = 0.5 * SlotWidthMm(r, slot.kerfMm), length = 0.5 * slot.lengthMm;
  const glm::dmat3 axes = SawAxes(slot.normal, r.withdrawal);
  const Extent blade{ slot.point, axes, { -half, -length, -slot.depthMm },
    { half, length, EndlessMm } };
  parts.taken.push_back(blade.Part(Name("", "slots", n), blade.Box(0.0)));
  if (slot.guidingHeightMm == 0.0)
    return;
  const double side = half + r.wallMm, end = length + r.wallMm;
  const Extent box{ slot.point, axes, { -side, -end, -RootMm(r) },
    { side, end, slot.guidingHeightMm } };
  parts.added.push_back(box.Part(Name("the box of ", "slots", n), box.Box(r.edgeRadiusMm)));
}

void AddFlange(const GuideRecipe& r, std::size_t n, GuideParts& parts)
{
  const GuideFlange& flange = r.flanges[n];
  const double face = -0.5 * SlotWidthMm(r, flange.kerfMm), length = 0.5 * flange.lengthMm;
  const glm::dmat3 axes = SawAxes(flange.normal, r.withdrawal);
  const Extent room{ flange.point, axes, { face, -length, -flange.depthMm },
    { flange.freeMm, length, EndlessMm } };
  parts.taken.push_back(room.Part(Name("", "flanges", n), room.Box(0.0)));
  // The face itself stays flat up to its edges: the round box goes on, and a plane ends it.
  const Extent wall{ flange.point, axes, { face - r.wallMm, -length, -RootMm(r) },
    { face + 2.0 * r.edgeRadiusMm, length, flange.heightMm } };
  SolidPointer solid = wall.Box(r.edgeRadiusMm);
  if (r.edgeRadiusMm > 0.0)
    solid =
      MakeIntersection({ std::move(solid), MakePlane(flange.point + face * axes[0], axes[0]) });
  parts.added.push_back(wall.Part(Name("the wall of ", "flanges", n), std::move(solid)));
}

void AddHole(const GuideRecipe& r, std::size_t n, GuideParts& parts)
{
  const GuideHole& hole = r.holes[n];
  const glm::dvec3 up = glm::dot(hole.axis, r.withdrawal) < 0.0 ? -hole.axis : hole.axis;
  const glm::dvec3 other = std::abs(up.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(other, up));
  const glm::dmat3 axes(across, glm::cross(up, across), up);
  const double radius = 0.5 * hole.diameterMm;
  const Extent drill{ hole.point, axes, { -radius, -radius, -hole.depthMm },
    { radius, radius, EndlessMm } };
  parts.taken.push_back(drill.Part(Name("", "holes", n),
    MakeCylinder(hole.point - hole.depthMm * up, hole.point + EndlessMm * up, radius)));
  if (hole.sleeveHeightMm == 0.0)
    return;
  const double outer = radius + r.sleeveWallMm, edge = r.edgeRadiusMm;
  const Extent sleeve{ hole.point, axes, { -outer, -outer, -RootMm(r) },
    { outer, outer, hole.sleeveHeightMm } };
  SolidPointer solid = MakeCylinder(hole.point - (RootMm(r) - edge) * up,
    hole.point + (hole.sleeveHeightMm - edge) * up, outer - edge);
  parts.added.push_back(sleeve.Part(Name("the sleeve of ", "holes", n),
    edge > 0.0 ? MakeOffset(std::move(solid), edge) : std::move(solid)));
}
} // namespace

GuideParts MakeGuideParts(const GuideRecipe& recipe)
{
  GuideParts parts;
  for (std::size_t n = 0; n < recipe.slots.size(); ++n)
    AddSlot(recipe, n, parts);
  for (std::size_t n = 0; n < recipe.flanges.size(); ++n)
    AddFlange(recipe, n, parts);
  for (std::size_t n = 0; n < recipe.holes.size(); ++n)
    AddHole(recipe, n, parts);
  return parts;
}

bool PartMeets(const GuidePart& part, const ImplicitSolid& solid, double spacingMm,
  const ImplicitSolid::Box& where)
{
  // Of the part's box, what lies within the other.
  const glm::dvec3 middle = 0.5 * (where.low + where.high), reach = 0.5 * (where.high - where.low);
  glm::dvec3 low, step;
  glm::ivec3 count;
  for (int a = 0; a < 3; ++a)
  {
    const double at = glm::dot(middle - part.center, part.axes[a]);
    const double around = glm::dot(glm::abs(part.axes[a]), reach);
    const double from = std::max(-part.half[a], at - around);
    const double to = std::min(part.half[a], at + around);
    if (!(from < to))
      return false;
    count[a] = std::max(1, static_cast<int>((to - from) / spacingMm));
    step[a] = (to - from) / count[a];
    low[a] = from + 0.5 * step[a];
  }
  const double partSteps = part.solid->Steepness() * step.x, steps = solid.Steepness() * step.x;
  int found = 0;
  for (int k = 0; k < count.z; ++k)
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x;)
      {
        const glm::dvec3 x = part.center + part.axes * (low + step * glm::dvec3(i, j, k));
        double free = part.solid->At(x) / partSteps; // places along the row, before there is any
        if (free < 1.0 && &solid != part.solid.get())
          free = std::max(free, solid.At(x) / steps);
        found += free < 0.0;
        if (found == LeastPlaces)
          return true;
        i += std::max(1, static_cast<int>(std::min(free, double(count.x))));
      }
  return false;
}

} // namespace hasp
