#include "Grid/GridGeometry.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

std::size_t GridGeometry::Size() const
{
  return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) *
         static_cast<std::size_t>(dims.z);
}

glm::ivec3 GridGeometry::Cells() const
{
  return { std::max(dims.x - 1, 0), std::max(dims.y - 1, 0), std::max(dims.z - 1, 0) };
}

glm::dvec3 GridGeometry::IndexToWorld(const glm::dvec3& index) const
{
  return origin + direction * (spacing * index);
}

glm::dvec3 GridGeometry::WorldToIndex(const glm::dvec3& world) const
{
  return (glm::transpose(direction) * (world - origin)) / spacing;
}

glm::dmat3 GridGeometry::IndexToWorldMatrix() const
{
  return { direction[0] * spacing.x, direction[1] * spacing.y, direction[2] * spacing.z };
}

glm::dvec3 GridGeometry::GradientToWorld(const glm::dvec3& perIndexStep) const
{
  return direction * (perIndexStep / spacing);
}

void GridGeometry::Validate() const
{
  std::ostringstream fault;
  for (int a = 0; a < 3; ++a)
  {
    if (dims[a] < 1)
      fault << "dims[" << a << "] is " << dims[a] << ", must be >= 1. ";
    if (!(std::isfinite(spacing[a]) && spacing[a] > 0))
      fault << "spacing[" << a << "] is " << spacing[a] << " mm, must be finite and > 0. ";
    if (!std::isfinite(origin[a]))
      fault << "origin[" << a << "] is " << origin[a] << ", must be finite. ";
    for (int b = a; b < 3; ++b)
    {
      const double dot = glm::dot(direction[a], direction[b]);
      if (!(std::abs(dot - (a == b ? 1.0 : 0.0)) < 1e-4))
        fault << "direction axes " << a << " and " << b << " have dot product " << dot
              << ", must be orthonormal. ";
    }
  }
  if (double(dims.x) * dims.y * dims.z > 0x1p62)
    fault << "dims are " << dims.x << " x " << dims.y << " x " << dims.z
          << ", more samples than 64 bits can count. ";
  if (!fault.str().empty())
    throw std::invalid_argument("volume geometry: " + fault.str());
}

} // namespace hasp
