#include "Studies/BenchBodies.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <numbers>

namespace hasp
{

ImplicitField::Sample WallBody::At(const glm::dvec3& p) const noexcept
{
  return { glm::dot(p, this->normal) - this->height, this->normal };
}

ImplicitField::Sample PlateBody::At(const glm::dvec3& p) const noexcept
{
  return { std::abs(p.z) - this->half, { 0.0, 0.0, p.z < 0.0 ? -1.0 : 1.0 } };
}

ImplicitField::Sample GrooveBody::At(const glm::dvec3& p) const noexcept
{
  const double side = p.x < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 normal(-side * std::sin(this->slope), 0.0, std::cos(this->slope));
  return { glm::dot(p, normal), normal };
}

ImplicitField::Sample HoleBody::At(const glm::dvec3& p) const noexcept
{
  const double length = std::hypot(p.x, p.y);
  const glm::dvec3 inward =
    length > 0.0 ? glm::dvec3(-p.x / length, -p.y / length, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  return { this->radius - length, inward };
}

ImplicitField::Sample SlotBody::At(const glm::dvec3& p) const noexcept
{
  return { this->half - std::abs(p.x), { p.x < 0.0 ? 1.0 : -1.0, 0.0, 0.0 } };
}

ImplicitField::Sample BallBody::At(const glm::dvec3& p) const noexcept
{
  const glm::dvec3 arm = p - this->center;
  const double length = glm::length(arm);
  return { length - this->radius, length > 0.0 ? arm / length : glm::dvec3(0.0, 0.0, 1.0) };
}

std::vector<glm::dvec3> TipPoints()
{
  return { glm::dvec3(0.0) };
}

std::vector<glm::dvec3> FootPoints(int perSide, double sideMm)
{
  std::vector<glm::dvec3> points;
  for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
      points.emplace_back(
        (i / (perSide - 1.0) - 0.5) * sideMm, (j / (perSide - 1.0) - 0.5) * sideMm, 0.0);
  return points;
}

std::vector<glm::dvec3> PegPoints(double radiusMm, double heightMm, int rings, int perRing)
{
  std::vector<glm::dvec3> points;
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < perRing; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / perRing;
      points.emplace_back(
        radiusMm * std::cos(angle), radiusMm * std::sin(angle), heightMm * ring / (rings - 1.0));
    }
  return points;
}

GridGeometry MapGrid(bool skewed)
{
  GridGeometry grid{ glm::ivec3(36), glm::dvec3(-17.5), glm::dvec3(1.0), glm::dmat3(1.0) };
  if (skewed)
  {
    grid.spacing = { 0.7, 1.1, 1.6 };
    grid.direction =
      glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1.0, -2.0, 0.5))));
    grid.origin = glm::dvec3(0.0);
    grid.origin = -grid.IndexToWorld(0.5 * glm::dvec3(grid.dims - 1));
  }
  return grid;
}

std::vector<glm::dvec3> LinePoints(int count, double lengthMm)
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back((i / (count - 1.0) - 0.5) * lengthMm, 0.0, 0.0);
  return points;
}

} // namespace hasp
