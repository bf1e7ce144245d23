#include "Grid/AnalyticVolumes.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

AnalyticVolume AnalyticSphere(const glm::dvec3& center, double radius)
{
  return { "sphere", [=](const glm::dvec3& p) { return radius - glm::length(p - center); }, 1.0 };
}

AnalyticVolume AnalyticTorus(
  const glm::dvec3& center, const glm::dvec3& axis, double major, double minor)
{
  const auto value = [=](const glm::dvec3& p)
  {
    const glm::dvec3 d = p - center;
    const double along = glm::dot(d, axis);
    const double ring = glm::length(d - along * axis) - major;
    return minor - std::hypot(ring, along);
  };
  return { "torus", value, 1.0 };
}

AnalyticVolume AnalyticGyroid(double period)
{
  const double k = glm::two_pi<double>() / period;
  const auto value = [k](const glm::dvec3& p)
  {
    const glm::dvec3 s = glm::sin(k * p), c = glm::cos(k * p);
    return (s.x * c.y + s.y * c.z + s.z * c.x) / (1.5 * k);
  };
  // |gradient| of the plain sum is at most k * sqrt(3): each component is a difference of two
  // products of sines and cosines, at most 1 in size. It is about 1.5 k on the surface.
  return { "gyroid", value, glm::root_three<double>() / 1.5 };
}

AnalyticVolume AnalyticTrabecular(double radius, double shell, double period)
{
  if (!(shell > 0.0 && shell < radius && period > 0.0))
    throw std::invalid_argument("trabecular bone: radius " + std::to_string(radius) + ", shell " +
                                std::to_string(shell) + ", period " + std::to_string(period) +
                                " mm; needed are 0 < shell < radius and period > 0");
  const AnalyticVolume gyroid = AnalyticGyroid(period);
  // The gyroid's sum, of values up to 1.5, lies above 0.75 in about a quarter of space.
  const double thinner = 0.75 / (1.5 * glm::two_pi<double>() / period);
  const auto value = [=](const glm::dvec3& p)
  {
    const double depth = radius - glm::length(p);
    return std::min(depth, std::max(shell - depth, gyroid.value(p) - thinner));
  };
  return { "trabecular", value, gyroid.lipschitz };
}

std::optional<double> FirstSurface(const AnalyticVolume& volume, const glm::dvec3& origin,
  const glm::dvec3& direction, double tMin, double tMax)
{
  const double perT = volume.lipschitz * glm::length(direction);
  const double smallest = (tMax - tMin) * 1e-7; // grazing rays stall without a least step
  double before = tMin, valueBefore = volume.value(origin + tMin * direction);
  for (double t = tMin; t < tMax;)
  {
    t = std::min(tMax, t + std::max(std::abs(valueBefore) / perT, smallest));
    const double value = volume.value(origin + t * direction);
    if (valueBefore <= 0.0 && value > 0.0)
    {
      double low = before, high = t;
      while (high - low > 1e-12 * (tMax - tMin))
      {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high)
          break;
        (volume.value(origin + middle * direction) > 0.0 ? high : low) = middle;
      }
      return 0.5 * (low + high);
    }
    before = t;
    valueBefore = value;
  }
  return std::nullopt;
}

template <typename T>
std::vector<T> SampleAnalytic(
  const AnalyticVolume& volume, const GridGeometry& geometry, double scale, double offset)
{
  geometry.Validate();
  std::vector<T> samples(geometry.Size());
  const auto slices = [&](std::int64_t first, std::int64_t last)
  {
    for (std::int64_t k = first; k < last; ++k)
      for (int j = 0; j < geometry.dims.y; ++j)
        for (int i = 0; i < geometry.dims.x; ++i)
        {
          const double value =
            scale * volume.value(geometry.IndexToWorld({ i, j, double(k) })) + offset;
          T& sample = samples[(k * geometry.dims.y + j) * geometry.dims.x + i];
          if constexpr (std::numeric_limits<T>::is_integer)
            sample = static_cast<T>(std::clamp<double>(
              std::round(value), std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
          else
            sample = static_cast<T>(value);
        }
  };
  ParallelFor(0, geometry.dims.z, 4, slices);
  return samples;
}

template std::vector<float> SampleAnalytic(
  const AnalyticVolume&, const GridGeometry&, double, double);
template std::vector<std::int16_t> SampleAnalytic(
  const AnalyticVolume&, const GridGeometry&, double, double);
template std::vector<std::uint16_t> SampleAnalytic(
  const AnalyticVolume&, const GridGeometry&, double, double);
template std::vector<std::uint8_t> SampleAnalytic(
  const AnalyticVolume&, const GridGeometry&, double, double);

} // namespace hasp
