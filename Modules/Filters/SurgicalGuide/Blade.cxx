#include "Blade.h"

#include "Distance/SolidShapes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

Blade::Blade(const Osteotomy& osteotomy)
  : Middle(osteotomy.point),
    HalfSides(0.5 * glm::dvec3(osteotomy.widthMm, osteotomy.depthMm, osteotomy.kerfMm))
{
  // Upright on each other within 1e-3 only, as people write them: the plane is what is held.
  const glm::dvec3 normal = glm::normalize(osteotomy.normal);
  const glm::dvec3 across = glm::normalize(glm::cross(normal, osteotomy.along));
  this->Directions = glm::dmat3(glm::cross(across, normal), across, normal);
}

glm::dvec3 Blade::Local(const glm::dvec3& world) const
{
  return glm::transpose(this->Directions) * (world - this->Middle);
}

glm::dvec3 Blade::World(const glm::dvec3& local) const
{
  return this->Middle + this->Directions * local;
}

SolidPointer Blade::Box() const
{
  return MakeBox(this->Middle, this->Directions, this->HalfSides);
}

ImplicitSolid::Box Blade::Bounds() const
{
  glm::dvec3 reach(0.0);
  for (int a = 0; a < 3; ++a)
    reach += glm::abs(this->Directions[a]) * this->HalfSides[a];
  return { this->Middle - reach, this->Middle + reach };
}

bool Blade::Meets(const glm::dvec3& a, const glm::dvec3& b, glm::dvec3& inside) const
{
  const glm::dvec3 from = this->Local(a), way = this->Local(b) - from;
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double half = this->HalfSides[axis];
    if (way[axis] == 0.0)
    {
      if (std::abs(from[axis]) > half)
        return false;
      continue;
    }
    const double t = (-half - from[axis]) / way[axis], u = (half - from[axis]) / way[axis];
    first = std::max(first, std::min(t, u));
    last = std::min(last, std::max(t, u));
  }
  inside = a + 0.5 * (first + last) * (b - a);
  return first <= last;
}

bool CutTool::Takes(const glm::dvec3& world) const
{
  return this->tool->At(world) < 0.0;
}

bool CutTool::Blocks(const glm::dvec3& a, const glm::dvec3& b) const
{
  glm::dvec3 inside;
  return this->blade.Meets(a, b, inside) && (!this->region || this->region->At(inside) < 0.0);
}

} // namespace hasp
