#include "Grid/ScannerFaults.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{
namespace
{

/// A number in (0,1) that depends on the key alone: splitmix64.
double Uniform(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return (double((x ^ (x >> 31)) >> 11) + 0.5) * 0x1p-53;
}

/// Noise that depends on the sample's number alone, so that threads do not matter: Box-Muller.
double Normal(std::uint64_t seed, std::uint64_t sample)
{
  const std::uint64_t key = seed * 0xd1342543de82ef95U + 2 * sample;
  return std::sqrt(-2.0 * std::log(Uniform(key))) *
         std::cos(glm::two_pi<double>() * Uniform(key + 1));
}

} // namespace

ScannerFaults::ScannerFaults(const GridGeometry& grid, const PhantomSettings& settings,
  const glm::dvec3& axis, std::vector<RoundConeShape> crowns)
  : Grid(grid),
    Settings(settings),
    Axis(axis),
    Crowns(std::move(crowns))
{
}

bool ScannerFaults::Any() const
{
  return this->Settings.noiseHU > 0.0 || !this->Crowns.empty() || this->Settings.coneBeam.on ||
         this->Settings.fieldRadiusMm > 0.0;
}

double ScannerFaults::FromAxis(const glm::dvec3& point) const
{
  return glm::length(glm::dvec2(point - this->Axis));
}

bool ScannerFaults::Sees(const glm::ivec3& index) const
{
  return !(this->Settings.fieldRadiusMm > 0.0 &&
           this->FromAxis(this->Grid.IndexToWorld(index)) > this->Settings.fieldRadiusMm);
}

double ScannerFaults::operator()(double value, const glm::ivec3& index) const
{
  if (!this->Any())
    return value;
  const PhantomSettings& s = this->Settings;
  if (!this->Sees(index))
    return s.coneBeam.on ? s.coneBeam.scale * s.airHU + s.coneBeam.offset : s.airHU;
  const glm::dvec3 point = this->Grid.IndexToWorld(index);
  value += this->Streaks(point);
  if (s.coneBeam.on)
  {
    const double out = std::min(this->FromAxis(point) / s.coneBeam.cupRadiusMm, 1.0);
    const double cupped = (value + 1000.0) * (1.0 - s.coneBeam.cupping * (1.0 - out * out));
    value = s.coneBeam.scale * (cupped - 1000.0) + s.coneBeam.offset;
  }
  return s.noiseHU > 0.0 ? value + s.noiseHU * this->Noise(index) : value;
}

double ScannerFaults::Noise(const glm::ivec3& at) const
{
  const std::uint64_t row = this->Grid.dims.x;
  const std::uint64_t sample =
    (std::uint64_t(at.z) * this->Grid.dims.y + at.y) * row + std::uint64_t(at.x);
  if (!this->Settings.grain)
    return Normal(this->Settings.seed, sample);
  // Weights 1 2 1 both ways, scaled so that the variance stays 1: 36 = (1 + 4 + 1)^2.
  double sum = 0.0;
  for (int b = -1; b <= 1; ++b)
    for (int a = -1; a <= 1; ++a)
      sum += (2 - a * a) * (2 - b * b) *
             Normal(this->Settings.seed, sample + std::uint64_t(b) * row + std::uint64_t(a));
  return sum / 6.0;
}

/// Rays that leave a crown at distance `out` from its middle, in a pattern of its own.
double ScannerFaults::Rays(const glm::dvec2& out, double crownRadius, std::uint64_t crown) const
{
  const MetalModel& m = this->Settings.metal;
  const double away = glm::length(out), angle = std::atan2(out.y, out.x);
  double pattern = 0.0;
  for (std::uint64_t n = 0; n < 3; ++n)
    pattern += std::cos(double(5 + 6 * n) * angle +
                        glm::two_pi<double>() * Uniform(this->Settings.seed * 31 + 3 * crown + n)) /
               3.0;
  const double ramp = std::min(away / crownRadius, 1.0); // the angle has no meaning in the middle
  return m.streakHU * pattern * ramp * std::exp(-std::max(away - crownRadius, 0.0) / m.decayMm);
}

double ScannerFaults::Streaks(const glm::dvec3& point) const
{
  const MetalModel& m = this->Settings.metal;
  double sum = 0.0;
  for (std::size_t n = 0; n < this->Crowns.size(); ++n)
  {
    const RoundConeShape& crown = this->Crowns[n];
    const glm::dvec3 d = point - 0.5 * (crown.a + crown.b);
    const double off = d.z / m.sliceMm;
    if (std::abs(off) > 4.0)
      continue;
    const double slice = std::exp(-0.5 * off * off);
    sum += slice * this->Rays(glm::dvec2(d), crown.radiusB, n);
    for (std::size_t k = 0; k < n; ++k)
    {
      const glm::dvec2 way(this->Crowns[k].b - crown.b);
      const double t = glm::dot(glm::dvec2(d), way) / glm::dot(way, way);
      const double across = glm::length(glm::dvec2(d) - t * way) / crown.radiusB;
      const double between = std::clamp(8.0 * std::min(t, 1.0 - t), 0.0, 1.0);
      sum -= slice * m.bandHU * between * std::exp(-0.5 * across * across);
    }
  }
  return sum;
}

std::int16_t RoundedSample(double value)
{
  return static_cast<std::int16_t>(std::clamp(std::round(value), -32768.0, 32767.0));
}

} // namespace hasp
