#include "Devices/HeadMotionFit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace hasp
{

namespace
{
constexpr double OutlierMedians = 6.0;
constexpr double LeastApartS = 1e-6;

double Median(std::span<double> values) noexcept
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1)
    return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// The line by medians, axis by axis.
EvenMotion MedianLine(std::span<const double> t, std::span<const glm::dvec3> values) noexcept
{
  std::array<double, MostMotionSamples*(MostMotionSamples - 1) / 2> buffer;
  EvenMotion line{ values.back(), glm::dvec3(0.0) };
  for (int axis = 0; axis < 3; ++axis)
  {
    std::size_t count = 0;
    for (std::size_t a = 0; a < t.size(); ++a)
      for (std::size_t b = a + 1; b < t.size(); ++b)
        if (t[b] - t[a] >= LeastApartS)
          buffer[count++] = (values[b][axis] - values[a][axis]) / (t[b] - t[a]);
    if (count > 0)
      line.rate[axis] = Median(std::span(buffer).first(count));
    for (std::size_t n = 0; n < t.size(); ++n)
      buffer[n] = values[n][axis] - line.rate[axis] * t[n];
    line.value[axis] = Median(std::span(buffer).first(t.size()));
  }
  return line;
}
} // namespace

EvenMotion FitEvenMotion(std::span<const double> t, std::span<const glm::dvec3> values,
  double noiseFloor, double leastSpanS) noexcept
{
  const std::size_t n = t.size();
  if (n < 3 || !(t.back() - t.front() >= leastSpanS))
    return { values.back(), glm::dvec3(0.0) };
  const EvenMotion rough = MedianLine(t, values);
  std::array<double, MostMotionSamples> off, sorted;
  for (std::size_t k = 0; k < n; ++k)
    off[k] = glm::length(values[k] - rough.value - rough.rate * t[k]);
  sorted = off;
  const double most = std::max(noiseFloor, OutlierMedians * Median(std::span(sorted).first(n)));

  double count = 0.0, meanT = 0.0, squares = 0.0;
  glm::dvec3 mean(0.0), product(0.0);
  for (std::size_t k = 0; k < n; ++k)
    if (off[k] <= most)
      ++count, meanT += t[k], mean += values[k];
  meanT /= count; // half of the samples at least are within the median
  mean /= count;
  for (std::size_t k = 0; k < n; ++k)
    if (off[k] <= most)
    {
      squares += (t[k] - meanT) * (t[k] - meanT);
      product += (t[k] - meanT) * (values[k] - mean);
    }
  if (count < 3 || squares < LeastApartS * LeastApartS)
    return rough;
  glm::dvec3 rate = product / squares;

  double residual = 0.0; // summed over samples and axes
  for (std::size_t k = 0; k < n; ++k)
    if (off[k] <= most)
    {
      const glm::dvec3 r = values[k] - mean - rate * (t[k] - meanT);
      residual += glm::dot(r, r);
    }
  const double variance = residual / (count - 2.0) / squares; // of the rate's three axes together
  const glm::dvec3 atNewest = mean - rate * meanT;
  if (const double r2 = glm::dot(rate, rate); r2 > 0.0)
    rate *= r2 / (r2 + variance);
  return { atNewest, rate };
}

} // namespace hasp
