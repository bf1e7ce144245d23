#pragma once
// Brute-force truth for ray-cell roots, in double precision: dense samples and bisection. It shares
// no formula with glsl/RayRoot.glsl beyond the trilinear polynomial itself.
#include "Grid/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hasp::testing
{

struct TrueRoot
{
  std::optional<double> first; ///< smallest s in [0,1] where the sign changes
  double tangency;             ///< smallest |f| at a turning point: below it float cannot decide
};

inline TrueRoot BruteForceRoot(
  const std::array<double, 8>& corners, const glm::dvec3& a, const glm::dvec3& b)
{
  constexpr int steps = 2000;
  const auto f = [&](double s) { return TrilinearValue(corners, (1 - s) * a + s * b); };
  TrueRoot truth{ std::nullopt, 1e30 };
  double previous = f(0), beforeThat = previous;
  for (int n = 1; n <= steps; ++n)
  {
    const double s = double(n) / steps, value = f(s);
    if ((value - previous) * (previous - beforeThat) <= 0)
      truth.tangency = std::min(truth.tangency, std::abs(previous));
    if (!truth.first && (value >= 0) != (previous >= 0))
    {
      double low = s - 1.0 / steps, high = s;
      for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        ((f(middle) >= 0) == (value >= 0) ? high : low) = middle;
      }
      truth.first = 0.5 * (low + high);
    }
    beforeThat = previous;
    previous = value;
  }
  // Ends near zero are as undecidable as turning points.
  truth.tangency = std::min({ truth.tangency, std::abs(f(0)), std::abs(f(1)) });
  return truth;
}

} // namespace hasp::testing
