#pragma once
#include "Grid/Phantom.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// What a scanner does to values besides blurring them: streaks of metal, a field of view that
/// ends, cone beam's cupping and scale, noise. Depends on the settings and the sample's place
/// alone, so that threads and order do not matter. Immutable; any thread; nothing throws.
class ScannerFaults
{
public:
  /// settings   checked; metal, coneBeam, fieldRadiusMm, noiseHU, grain, seed and airHU count
  /// axis       a point of the scanner's axis (along S), world mm: of cupping and field
  /// crowns     where metal is; empty: no streaks
  ScannerFaults(const GridGeometry& grid, const PhantomSettings& settings, const glm::dvec3& axis,
    std::vector<RoundConeShape> crowns);

  /// Whether anything is changed at all.
  bool Any() const;
  /// Whether the sample is within the field of view.
  bool Sees(const glm::ivec3& index) const;
  /// HU of the scene in, the scanner's grey value out.
  double operator()(double value, const glm::ivec3& index) const;

private:
  double Noise(const glm::ivec3& at) const;
  double Rays(const glm::dvec2& out, double crownRadius, std::uint64_t crown) const;
  double Streaks(const glm::dvec3& point) const;
  double FromAxis(const glm::dvec3& point) const;

  GridGeometry Grid;
  PhantomSettings Settings;
  glm::dvec3 Axis;
  std::vector<RoundConeShape> Crowns;
};

/// The nearest integer that a sample holds.
std::int16_t RoundedSample(double value);

} // namespace hasp
