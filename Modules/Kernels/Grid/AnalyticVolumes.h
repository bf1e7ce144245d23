#pragma once
#include "Grid/GridView.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// A scalar field with a known surface: the truth that isosurfaces are tested against.
///
/// value      at a world position in mm; the surface is value == 0, inside is value > 0 (bone is
/// bright) lipschitz  bound of |value(a) - value(b)| / |a - b|, per mm: what makes FirstSurface
/// exact For sphere and torus the value is minus the signed distance, so it is also a distance
/// truth.
struct AnalyticVolume
{
  std::string name;
  std::function<double(const glm::dvec3&)> value;
  double lipschitz = 1.0;
};

AnalyticVolume AnalyticSphere(const glm::dvec3& center, double radius);
/// A torus around the unit axis: `major` to the middle of the tube, `minor` the tube's radius.
AnalyticVolume AnalyticTorus(
  const glm::dvec3& center, const glm::dvec3& axis, double major, double minor);
/// sin x cos y + sin y cos z + sin z cos x with the period in mm, scaled to about 1 per mm at the
/// surface.
AnalyticVolume AnalyticGyroid(double period);
/// Spongy bone: a ball of the given radius around the origin, solid down to `shell` below its
/// surface and a network of struts further in (the part of a gyroid of the given period that is
/// about a quarter of space). mm. Many surfaces lie behind each other. Throws std::invalid_argument
/// unless 0 < shell < radius and period > 0.
AnalyticVolume AnalyticTrabecular(double radius, double shell, double period);

/// The first point where the field turns from outside to inside along origin + t * direction,
/// t in [tMin, tMax] in units of |direction|; nothing if there is none. Steps of |value| /
/// lipschitz cannot jump over the surface; the root is bisected to 1e-12 of the range. Double
/// precision, a few microseconds.
std::optional<double> FirstSurface(const AnalyticVolume& volume, const glm::dvec3& origin,
  const glm::dvec3& direction, double tMin, double tMax);

/// The field sampled on a grid, times scale plus offset. Integers are rounded and saturated.
/// T is float, int16, uint16 or uint8. Uses all threads.
template <typename T>
std::vector<T> SampleAnalytic(
  const AnalyticVolume& volume, const GridGeometry& geometry, double scale, double offset);

} // namespace hasp
