#include "LensModel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// r' / r as a polynomial of t = r^2.
double Stretch(const glm::dvec3& k, double t)
{
  return 1.0 + t * (k.x + t * (k.y + t * k.z));
}

/// dr' / dr as a polynomial of t = r^2.
double Growth(const glm::dvec3& k, double t)
{
  return 1.0 + t * (3.0 * k.x + t * (5.0 * k.y + t * 7.0 * k.z));
}

/// Where Growth has its extremes, in order: roots of 3 k1 + 10 k2 t + 21 k3 t^2.
std::array<double, 2> Extremes(const glm::dvec3& k)
{
  const double none = -1.0, a = 21.0 * k.z, b = 10.0 * k.y, c = 3.0 * k.x;
  if (a == 0.0)
    return { none, b == 0.0 ? none : -c / b };
  const double under = b * b - 4.0 * a * c;
  if (under < 0.0)
    return { none, none };
  const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
  const double first = q / a, second = q == 0.0 ? first : c / q;
  return { std::min(first, second), std::max(first, second) };
}

/// The least t in (0, last] where the lens stops growing; none if it grows all the way. Between
/// extremes Growth is monotonic, and it is 1 at 0.
std::optional<double> Fold(const glm::dvec3& k, double last)
{
  double from = 0.0;
  const auto extremes = Extremes(k);
  for (const double end : { extremes[0], extremes[1], last })
  {
    const double to = std::min(end, last);
    if (!(to > from))
      continue;
    if (Growth(k, to) <= 0.0)
    {
      double low = from, high = to;
      for (int halving = 0; halving < 60; ++halving)
        (Growth(k, 0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
      return high;
    }
    from = to;
  }
  return std::nullopt;
}

double FarthestCorner(const glm::dvec2& center, double aspect)
{
  return glm::length(glm::abs(center) + glm::dvec2(aspect, 1.0));
}

} // namespace

void ValidateLens(const LensModel& lens, double aspect)
{
  if (!(aspect > 0.0) || !std::isfinite(aspect))
    throw std::invalid_argument(
      "lens: the picture's aspect is " + std::to_string(aspect) + ", must be > 0");
  for (int n = 0; n < 3; ++n)
  {
    if (!std::isfinite(lens.coefficients[n]))
      throw std::invalid_argument("lens: k" + std::to_string(n + 1) + " is not finite");
    if (!(lens.colorScale[n] > 0.0) || !std::isfinite(lens.colorScale[n]))
      throw std::invalid_argument("lens: the scale of colour " + std::to_string(n + 1) + " is " +
                                  std::to_string(lens.colorScale[n]) + ", must be > 0");
  }
  for (const glm::dvec2& center : lens.centers)
  {
    const double farthest = FarthestCorner(center, aspect);
    if (!std::isfinite(farthest))
      throw std::invalid_argument("lens: a centre is not finite");
    if (const auto fold = Fold(lens.coefficients, farthest * farthest))
      throw std::invalid_argument("lens: it folds over " + std::to_string(std::sqrt(*fold)) +
                                  " half heights from its centre, and the picture reaches " +
                                  std::to_string(farthest) +
                                  "; r (1 + k1 r^2 + k2 r^4 + k3 r^6) must grow up to there");
  }
}

glm::dvec2 SeenThroughLens(const LensModel& lens, StereoEye eye, int channel, glm::dvec2 panel)
{
  const glm::dvec2& center = lens.centers[eye == StereoEye::Right];
  const glm::dvec2 off = panel - center;
  return center + lens.colorScale[channel] * Stretch(lens.coefficients, glm::dot(off, off)) * off;
}

std::optional<glm::dvec2> PanelBehindLens(
  const LensModel& lens, StereoEye eye, int channel, glm::dvec2 seen, double aspect)
{
  const glm::dvec2& center = lens.centers[eye == StereoEye::Right];
  const glm::dvec2 off = (seen - center) / lens.colorScale[channel];
  const double distance = glm::length(off);
  double low = 0.0, high = FarthestCorner(center, aspect);
  constexpr double rounding = 1.0 + 1e-12; // the corner itself is shown
  if (distance > rounding * high * Stretch(lens.coefficients, high * high))
    return std::nullopt;
  if (distance == 0.0)
    return center;
  for (int halving = 0; halving < 60; ++halving) // growing: there is one root
  {
    const double middle = 0.5 * (low + high);
    (middle * Stretch(lens.coefficients, middle * middle) < distance ? low : high) = middle;
  }
  return center + off * (0.5 * (low + high) / distance);
}

} // namespace hasp
