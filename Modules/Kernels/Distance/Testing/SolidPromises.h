#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace hasp
{

/// Places within `spread` of `middle` along each axis, seeded.
inline std::vector<glm::dvec3> RandomPlaces(
  int count, double spread, const glm::dvec3& middle = glm::dvec3(0.0), unsigned seed = 5)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-spread, spread);
  std::vector<glm::dvec3> places;
  for (int n = 0; n < count; ++n)
  {
    const double x = any(random), y = any(random), z = any(random);
    places.push_back(middle + glm::dvec3(x, y, z));
  }
  return places;
}

/// What At and SampleAt promise of each other, of faces and of bounds.
inline void ExpectSamplesAgree(const ImplicitSolid& solid, const std::vector<glm::dvec3>& places)
{
  const ImplicitSolid::Box box = solid.Bounds();
  for (const glm::dvec3& x : places)
  {
    const double at = solid.At(x);
    const ImplicitSolid::Sample s = solid.SampleAt(x);
    // Rounding: a few last digits of coordinates of some tens of mm.
    ASSERT_NEAR(s.value, at, 1e-8);
    ASSERT_GE(at, box.Excess(x) - 1e-10);
    ASSERT_LT(s.face, solid.Faces());
    ASSERT_LE(glm::length(s.gradient), solid.Steepness() + 1e-9);
    const ImplicitSolid::Sample f = solid.FaceAt(s.face, x);
    ASSERT_EQ(f.face, s.face);
    ASSERT_NEAR(f.value, s.value, 1e-8);
    ASSERT_LT(glm::distance(f.gradient, s.gradient), 1e-6) << "face " << s.face;
  }
}

/// The gradient of each of `faces` against differences of its value.
inline void ExpectGradientsOfFaces(const ImplicitSolid& solid,
  const std::vector<glm::dvec3>& places, const std::vector<std::uint32_t>& faces,
  double tolerance = 1e-6)
{
  const double h = 1e-5;
  for (const glm::dvec3& x : places)
    for (const std::uint32_t face : faces)
    {
      const glm::dvec3 gradient = solid.FaceAt(face, x).gradient;
      for (int a = 0; a < 3; ++a)
      {
        glm::dvec3 e(0.0);
        e[a] = h;
        const double slope =
          (solid.FaceAt(face, x + e).value - solid.FaceAt(face, x - e).value) / (2 * h);
        ASSERT_NEAR(gradient[a], slope, tolerance) << "face " << face << " axis " << a;
      }
    }
}

inline std::vector<std::uint32_t> AllFaces(const ImplicitSolid& solid)
{
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < solid.Faces(); ++f)
    faces.push_back(f);
  return faces;
}

/// No two places whose values differ by more than their distance times the steepness: far pairs,
/// and near ones, which see a jump.
inline void ExpectNoSteeperThanPromised(
  const ImplicitSolid& solid, const std::vector<glm::dvec3>& places)
{
  std::mt19937 random(7);
  std::normal_distribution<double> any;
  for (std::size_t n = 0; n + 1 < places.size(); ++n)
  {
    const glm::dvec3& x = places[n];
    const double step = std::pow(10.0, -double(n % 6));
    const double u = any(random), v = any(random), w = any(random);
    for (const glm::dvec3& y : { places[n + 1], x + step * glm::dvec3(u, v, w) })
      ASSERT_LE(std::abs(solid.At(x) - solid.At(y)),
        solid.Steepness() * glm::distance(x, y) * (1.0 + 1e-9) + 1e-12);
  }
}

/// The value is the distance: the foot point is on the surface, and since nothing is steeper than
/// promised, no surface is nearer. `band`: within this much inside, too, but for ridges.
inline void ExpectFootPointsOnSurface(
  const ImplicitSolid& solid, const std::vector<glm::dvec3>& places, double inside = 0.0)
{
  for (const glm::dvec3& x : places)
  {
    const ImplicitSolid::Sample s = solid.SampleAt(x);
    if (s.value < -inside)
      continue;
    ASSERT_NEAR(glm::length(s.gradient), 1.0, 1e-9);
    ASSERT_NEAR(solid.At(x - s.value * s.gradient), 0.0, 1e-9);
  }
}

} // namespace hasp
