#include "Realtime/ForceLimiter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

glm::dvec3 Shortened(const glm::dvec3& v, double longest) noexcept
{
  // Finite vectors may have a length that is not: then by the largest component first.
  const double largest = std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  if (largest == 0.0)
    return v;
  const glm::dvec3 unit = glm::normalize(v / largest);
  const double length = largest * glm::length(v / largest);
  return length > longest ? longest * unit : v;
}

/// From last towards wanted: shrinks freely, else by the slew.
glm::dvec3 Slewed(
  const glm::dvec3& last, const glm::dvec3& wanted, double seconds, double slew) noexcept
{
  const double reach = seconds > 0.0 ? seconds * slew : 0.0; // a slew may be infinite
  const double length = glm::length(last);
  glm::dvec3 base = last;
  if (length > 0.0)
  {
    const glm::dvec3 along = last / length;
    base = along * std::clamp(glm::dot(wanted, along), 0.0, length);
  }
  return base + Shortened(wanted - base, reach);
}

} // namespace

ForceLimiter::ForceLimiter(const ForceLimits& limits) : Settings(limits)
{
  for (const double value : { limits.force, limits.torque, limits.rampInS })
    if (!(value >= 0.0) || !std::isfinite(value))
      throw std::invalid_argument("A limit of force, torque or its ramp is " +
                                  std::to_string(value) + "; it must be finite and not negative");
  for (const double value : { limits.forceSlew, limits.torqueSlew })
    if (!(value > 0.0))
      throw std::invalid_argument(
        "A slew of force or torque is " + std::to_string(value) + "; it must be positive");
}

void ForceLimiter::Restart() noexcept
{
  this->Last = {};
  this->SinceS = 0.0;
}

Wrench ForceLimiter::Limit(const Wrench& wanted, double seconds) noexcept
{
  const ForceLimits& s = this->Settings;
  const double passed = std::isfinite(seconds) ? std::max(0.0, seconds) : 0.0;
  this->SinceS = std::min(this->SinceS + passed, s.rampInS);
  const double ramp = s.rampInS > 0.0 ? this->SinceS / s.rampInS : 1.0;
  const Wrench asked = IsFinite(wanted) ? wanted : Wrench{};
  const Wrench slewed{ Slewed(this->Last.force, Shortened(asked.force, ramp * s.force), passed,
                         s.forceSlew),
    Slewed(this->Last.torque, Shortened(asked.torque, ramp * s.torque), passed, s.torqueSlew) };
  // Both ends of a slew are within the ball; rounding is not.
  this->Last = { Shortened(slewed.force, s.force), Shortened(slewed.torque, s.torque) };
  return this->Last;
}

} // namespace hasp
