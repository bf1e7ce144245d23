#pragma once
#include "Haptics/ImplicitField.h"

#include <glm/geometric.hpp>

#include <cmath>

/// Bodies in closed form; distances negative inside.
namespace hasp::test
{

/// z < height is solid.
struct HalfSpace : ImplicitField
{
  double height = 0.0;
  Sample At(const glm::dvec3& p) const noexcept override
  {
    return { p.z - this->height, { 0, 0, 1 } };
  }
};

/// |z| < half is solid: from its middle it pushes out to either side.
struct Plate : ImplicitField
{
  double half;
  explicit Plate(double half) : half(half) {}
  Sample At(const glm::dvec3& p) const noexcept override
  {
    return { std::abs(p.z) - this->half, { 0, 0, p.z < 0.0 ? -1.0 : 1.0 } };
  }
};

struct Ball : ImplicitField
{
  double radius;
  explicit Ball(double radius) : radius(radius) {}
  Sample At(const glm::dvec3& p) const noexcept override
  {
    const double length = glm::length(p);
    return { length - this->radius, length > 0.0 ? p / length : glm::dvec3(0, 0, 1) };
  }
};

} // namespace hasp::test
