#pragma once
#include "Distance/CreasePoints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{

/// Keeps shares of corners, which sum up to 1, at least `least` each, on the way to `safe`, whose
/// shares are.
template <class Shares>
Shares KeepInside(const Shares& wanted, const Shares& safe, double least)
{
  double way = 1.0;
  for (int n = 0; n < Shares::length(); ++n)
    if (wanted[n] < least)
      way = std::min(way, (safe[n] - least) / (safe[n] - wanted[n]));
  return safe + way * (wanted - safe);
}

/// What was held in its simplex may stand out of the solid, or deep in it: then where the surface
/// is, on the way there from `safe`.
template <class Shares, std::size_t N>
Shares BackToSurface(const BoundedSolid& solid, const std::array<glm::dvec3, N>& world,
  const Shares& held, const Shares& safe, double far)
{
  const auto place = [&](const Shares& share)
  {
    glm::dvec3 at(0.0);
    for (int n = 0; n < int(N); ++n)
      at += share[n] * world[n];
    return at;
  };
  const glm::dvec3 from = place(safe), to = place(held);
  const double value = solid.At(to), start = solid.At(from);
  if (std::abs(value) < far || (value < 0.0) == (start < 0.0))
    return held;
  return safe + FindCrossing(solid, from, start, to, value).share * (held - safe);
}

} // namespace hasp
