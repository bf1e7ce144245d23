#pragma once
// Truth for rays through a whole volume, in long double: every cell on the way, none skipped, its
// cubic through four values, split where it turns, and bisection. Shares nothing with the walks it
// judges.
#include "Grid/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace hasp::testing
{

struct TruthHit
{
  std::optional<double> t;
  /// Least |value| / largest |corner| at a turning point, or at an end of the ray, up to the hit:
  /// in a band around 0 float cannot decide whether the ray touches the surface.
  double tangency = std::numeric_limits<double>::infinity();
};

class CubicTruth
{
public:
  using Real = long double;

  /// Values at s = 0, 1/3, 2/3 and 1.
  explicit CubicTruth(const std::array<Real, 4>& f)
    : D(f[0]),
      C((-11 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 2),
      B((18 * f[0] - 45 * f[1] + 36 * f[2] - 9 * f[3]) / 2),
      A((-9 * f[0] + 27 * f[1] - 27 * f[2] + 9 * f[3]) / 2)
  {
  }
  Real operator()(Real s) const { return ((A * s + B) * s + C) * s + D; }

  /// 0, the turning points between 0 and 1, and 1.
  std::vector<Real> Pieces() const
  {
    std::vector<Real> ends{ 0 };
    const Real disc = B * B - 3 * A * C;
    if (disc > 0)
    {
      const Real q = -(B + std::copysign(std::sqrt(disc), B));
      for (const Real s : { q / (3 * A), C / q })
        if (s > 0 && s < 1)
          ends.push_back(s);
    }
    std::sort(ends.begin(), ends.end());
    ends.push_back(1);
    return ends;
  }

  Real Bisect(Real low, Real high) const
  {
    const bool inside = (*this)(low) >= 0;
    for (int i = 0; i < 70; ++i)
    {
      const Real middle = (low + high) / 2;
      (((*this)(middle) >= 0) == inside ? low : high) = middle;
    }
    return high;
  }

private:
  Real D, C, B, A;
};

/// origin and direction in index coordinates, direction of about unit length.
template <typename T>
TruthHit TraceTruth(const GridView<const T>& grid, float isovalue, const glm::dvec3& origin,
  const glm::dvec3& direction, double tMin, double tMax)
{
  using Real = CubicTruth::Real;
  const glm::ivec3 cells = grid.geometry.Cells();
  Real t0 = tMin, t1 = tMax;
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] == 0)
    {
      if (origin[a] < 0 || origin[a] > cells[a])
        return {};
      continue;
    }
    const Real u = -Real(origin[a]) / direction[a], v = (Real(cells[a]) - origin[a]) / direction[a];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (!(t0 <= t1))
    return {};
  std::vector<Real> ways{ t0, t1 };
  for (int a = 0; a < 3; ++a)
    for (int face = 0; direction[a] != 0 && face <= cells[a]; ++face)
      if (const Real t = (Real(face) - origin[a]) / direction[a]; t > t0 && t < t1)
        ways.push_back(t);
  std::sort(ways.begin(), ways.end());

  TruthHit truth;
  for (std::size_t n = 0; n + 1 < ways.size(); ++n)
  {
    const auto at = [&](int a, Real t) { return origin[a] + t * Real(direction[a]); };
    glm::ivec3 cell;
    for (int a = 0; a < 3; ++a)
      cell[a] = std::clamp(
        static_cast<int>(std::floor(at(a, (ways[n] + ways[n + 1]) / 2))), 0, cells[a] - 1);
    const auto corners = CellCorners(grid, cell);
    Real largest = 0;
    for (const double c : corners)
      largest = std::max(largest, std::abs(Real(c) - isovalue));
    std::array<Real, 4> f{};
    for (int k = 0; k < 4; ++k)
    {
      const Real t = ways[n] + (ways[n + 1] - ways[n]) * k / 3;
      for (int c = 0; c < 8; ++c)
      {
        Real weight = 1;
        for (int a = 0; a < 3; ++a)
          weight *= c >> a & 1 ? at(a, t) - cell[a] : 1 - (at(a, t) - cell[a]);
        f[k] += weight * (Real(corners[c]) - isovalue);
      }
    }
    const CubicTruth cubic(f);
    const auto pieces = cubic.Pieces();
    const auto decides = [&](Real s)
    { truth.tangency = std::min(truth.tangency, double(std::abs(cubic(s)) / largest)); };
    if (n == 0)
      decides(0);
    for (std::size_t p = 0; p + 1 < pieces.size(); ++p)
    {
      decides(pieces[p + 1]); // also if the root lies before it: two roots, or none
      if ((cubic(pieces[p]) >= 0) != (cubic(pieces[p + 1]) >= 0))
      {
        truth.t =
          double(ways[n] + cubic.Bisect(pieces[p], pieces[p + 1]) * (ways[n + 1] - ways[n]));
        return truth;
      }
    }
  }
  return truth;
}

} // namespace hasp::testing
