#pragma once
#include "IsosurfaceMethods.h"

#include <functional>

namespace hasp
{

/// The true first surface of a pixel's ray.
struct TrueHit
{
  glm::dvec3 position;
  double facing; ///< |cosine| between ray and normal: near 0 the ray grazes
};
using SurfaceTruth = std::vector<std::optional<TrueHit>>;

/// Calls `first(origin, direction)` for every pixel's ray, on all cores.
SurfaceTruth TraceTruth(const IsosurfaceView& view,
  const std::function<std::optional<TrueHit>(const glm::dvec3&, const glm::dvec3&)>& first);

/// How far what is shown lies from the truth, along each pixel's ray, mm; rays that graze (facing <
/// 0.2, where a small error across the ray is a large one along it) are left out. Pixels where only
/// one of the two has a surface, or where they show different sheets (more than 2 mm apart), are
/// `missed`.
struct SurfaceErrors
{
  double rmsMm = 0.0, p99Mm = 0.0, maxMm = 0.0;
  int maxX = 0, maxY = 0; ///< pixel of the largest
  double missed = 0.0;    ///< share of the surface pixels
  int pixels = 0;
};
SurfaceErrors MeasureErrors(
  const IsosurfaceView& view, const SurfaceTruth& truth, const SurfacePoints& shown);

} // namespace hasp
