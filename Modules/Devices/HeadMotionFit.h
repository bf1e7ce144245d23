#pragma once
#include <glm/vec3.hpp>

#include <span>

namespace hasp
{

/// A value that moves evenly: at time 0 (the newest sample's), and by how much a second.
struct EvenMotion
{
  glm::dvec3 value{ 0.0 };
  glm::dvec3 rate{ 0.0 };
};

/// The straight line through noisy samples, of which some may be far off: the median of all slopes
/// between two samples (Theil 1950, Sen 1968), then least squares through those within six medians
/// of that line's residuals, or within `noiseFloor`. The rate is shrunk by r^2 / (r^2 + s^2), s its
/// standard error from the residuals: a head that keeps still is not sent about by its tracker's
/// noise.
///
/// timesS      increasing, the last is 0, at most MostMotionSamples; samples less than a
/// microsecond
///             apart do not make a slope
/// values      as many, any unit
/// noiseFloor  > 0, same unit
/// Fewer than three samples, or less than `leastSpanS` between the first and the last: the newest
/// value and no rate. Any thread; never throws, takes no memory. O(n^2), 0.4 us for five, 6 us
/// for 24.
EvenMotion FitEvenMotion(std::span<const double> timesS, std::span<const glm::dvec3> values,
  double noiseFloor, double leastSpanS) noexcept;

constexpr std::size_t MostMotionSamples = 24;

} // namespace hasp
