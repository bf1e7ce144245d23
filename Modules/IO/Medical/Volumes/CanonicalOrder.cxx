#include "Volumes/CanonicalOrder.h"
#include "vtkHaspVolumeHash.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hasp
{

CanonicalOrder CanonicalOrderOf(const GridGeometry& geometry)
{
  const glm::dvec3 turn(0.014, 0.028, 0.042); // radians, about an axis that no scan is turned about
  glm::dmat3 frame(1.0);
  for (int a = 0; a < 3; ++a)
    frame[a] += glm::cross(turn, frame[a]);
  CanonicalOrder best;
  double nearest = -1.0;
  int axis[3] = { 0, 1, 2 };
  do
  {
    double near = 0.0;
    for (int a = 0; a < 3; ++a)
      near += std::abs(glm::dot(frame[a], geometry.direction[axis[a]]));
    if (near > nearest)
    {
      nearest = near;
      std::copy(axis, axis + 3, best.axis);
    }
  } while (std::next_permutation(axis, axis + 3));
  for (int a = 0; a < 3; ++a)
    best.turned[a] = glm::dot(frame[a], geometry.direction[best.axis[a]]) < 0.0;
  return best;
}

GridGeometry Reordered(const GridGeometry& geometry, const CanonicalOrder& order)
{
  GridGeometry g;
  glm::dvec3 first(0.0);
  for (int a = 0; a < 3; ++a)
  {
    const int from = order.axis[a];
    g.dims[a] = geometry.dims[from];
    g.spacing[a] = geometry.spacing[from];
    g.direction[a] = geometry.direction[from] * (order.turned[a] ? -1.0 : 1.0);
    first[from] = order.turned[a] ? geometry.dims[from] - 1.0 : 0.0;
  }
  g.origin = geometry.IndexToWorld(first);
  return g;
}

std::array<double, 16> CanonicalPlace(const GridGeometry& geometry)
{
  geometry.Validate();
  const GridGeometry g = Reordered(geometry, CanonicalOrderOf(geometry));
  std::array<double, 16> place{};
  auto* next = place.data();
  const auto put = [&](double steps) { *next++ = std::round(steps) + 0.0; }; // + 0.0: no -0.0
  const double spacingStep = std::log1p(5e-4);
  double smallest = INFINITY;
  for (int a = 0; a < 3; ++a)
  {
    put(g.dims[a]);
    put(std::log(g.spacing[a]) / spacingStep);
    smallest = std::min(smallest, next[-1]);
  }
  // The third direction follows from the other two, up to its side.
  for (int a = 0; a < 2; ++a)
    for (int row = 0; row < 3; ++row)
      put(1024.0 * g.direction[a][row]);
  put(glm::dot(glm::cross(g.direction[0], g.direction[1]), g.direction[2]));
  const glm::dvec3 centre = g.IndexToWorld(0.5 * glm::dvec3(g.dims - 1));
  const double step = 0.25 * std::exp(smallest * spacingStep); // not the exact spacing: see above
  for (int row = 0; row < 3; ++row)
    put(centre[row] / step + 0.3127); // round numbers at spacing 1 are then off the middle
  return place;
}

} // namespace hasp
