#pragma once
// Closed-form distances on grids, for the tests and benchmarks of this folder.
#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <functional>
#include <vector>

namespace hasp::testing
{

/// A distance at a world point, mm, negative inside.
using DistanceFunction = std::function<double(const glm::dvec3&)>;

inline DistanceFunction Ball(const glm::dvec3& center, double radius)
{
  return [=](const glm::dvec3& p) { return glm::length(p - center) - radius; };
}
inline DistanceFunction HalfSpace(const glm::dvec3& point, const glm::dvec3& normal)
{
  return [=](const glm::dvec3& p) { return glm::dot(p - point, normal); };
}
inline DistanceFunction Torus(const glm::dvec3& axis, double major, double minor)
{
  const AnalyticVolume torus = AnalyticTorus({}, axis, major, minor);
  return [torus](const glm::dvec3& p) { return -torus.value(p); };
}
/// A ball with bumps: about a distance (its slope is within a fifth of 1 at the surface), and with
/// detail in each direction.
inline DistanceFunction BumpyBall(double radius, double bump)
{
  return [=](const glm::dvec3& p)
  {
    const double f = 6.0 / radius;
    return glm::length(p) - radius -
           bump * std::sin(f * p.x) * std::sin(f * p.y + 1.0) * std::sin(f * p.z + 2.0);
  };
}

/// A distance sampled on a grid; owns the samples.
struct SampledDistance
{
  GridGeometry geometry;
  std::vector<float> samples;

  SampledDistance(const DistanceFunction& distance, const GridGeometry& on)
    : geometry(on),
      samples(SampleAnalytic<float>({ "distance", distance, 1.0 }, on, 1.0, 0.0))
  {
  }
  GridView<const float> View() const { return { this->samples.data(), this->geometry }; }
};

/// n samples an axis, 1 mm apart, the grid's middle at the origin.
inline GridGeometry CubeGrid(int n, double spacing = 1.0)
{
  return { glm::ivec3(n), glm::dvec3(-0.5 * (n - 1) * spacing), glm::dvec3(spacing),
    glm::dmat3(1.0) };
}

/// Anisotropic, turned about a skew axis and mirrored; the grid's middle at the origin.
inline GridGeometry SkewGrid(const glm::ivec3& dims)
{
  GridGeometry g{ dims, glm::dvec3(0.0), { 0.7, 1.1, 1.6 },
    glm::mat3_cast(glm::angleAxis(0.8, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)))) };
  g.direction[2] = -g.direction[2];
  g.origin = -g.IndexToWorld(0.5 * glm::dvec3(dims - 1));
  return g;
}

} // namespace hasp::testing
