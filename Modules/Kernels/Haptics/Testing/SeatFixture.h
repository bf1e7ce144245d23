#pragma once
#include "Dice.h"
#include "Grid/Stopwatch.h"
#include "Haptics/SeatByContact.h"
#include "SampledDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp::testing
{

using Points = std::vector<glm::dvec3>;
using Map = std::shared_ptr<const DistanceMap>;

constexpr double FoundMm = 1e-3; ///< of way, as the header promises

inline Map MapOf(const DistanceFunction& bone, const GridGeometry& grid, double rangeMm = 0.0)
{
  return std::make_shared<const DistanceMap>(
    SampledDistance(bone, grid).View(), DistanceMapSettings{ .rangeMm = rangeMm });
}

/// Rounded to what a shell keeps.
inline Points Kept(const Points& points)
{
  Points kept;
  for (const glm::dvec3& p : points)
    kept.emplace_back(glm::vec3(p));
  return kept;
}

inline std::shared_ptr<const PointShell> ShellOf(const Points& points, int coarsest = 16)
{
  std::vector<SurfacePoint> surface;
  for (const glm::dvec3& p : points)
    surface.push_back({ glm::vec3(p), { 0, 0, -1 } });
  const int count = std::max<int>(1, static_cast<int>(points.size()));
  return PointShell::OfPoints(surface, 100.0, glm::dvec3(0.0), { count, coarsest, 1 });
}

inline Seat Push(const Points& part, const std::vector<HapticBody>& bones,
  const SeatSettings& settings, const RigidPose& at = {})
{
  return SeatByContact(*ShellOf(part), at, bones, settings);
}
inline Seat Push(const Points& part, const Map& bone, const SeatSettings& settings = {})
{
  return Push(part, { { bone, {} } }, settings);
}

/// Within `angle` of +z, mm of `radius`: evenly spread.
inline Points Cap(double radius, double angle, int n)
{
  Points points;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i)
  {
    const double z = 1.0 - (i + 0.5) / n * (1.0 - std::cos(angle)), across = std::sqrt(1.0 - z * z);
    points.push_back(
      radius * glm::dvec3(across * std::cos(golden * i), across * std::sin(golden * i), z));
  }
  return Kept(points);
}

inline Points Ring(double radius, double z, int n = 64)
{
  Points points;
  for (int i = 0; i < n; ++i)
  {
    const double a = 2.0 * std::numbers::pi * i / n;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
  }
  return Kept(points);
}

/// n x n points, `side` mm.
inline Points Plate(double side, double z, int n = 24)
{
  Points points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      points.emplace_back(side * ((i + 0.5) / n - 0.5), side * ((j + 0.5) / n - 0.5), z);
  return Kept(points);
}

/// A ball at 0 stops a point p, pushed along -z, where |p - t z| is its radius.
inline double DepthOnBall(const Points& points, double radius)
{
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points)
    if (const double across2 = p.x * p.x + p.y * p.y; across2 < radius * radius)
      least = std::min(least, p.z - std::sqrt(radius * radius - across2));
  return least;
}

/// By steps of a field that is no steeper than 2, the points of the part one after the other.
inline double MarchedDepth(const Points& world, const DistanceFunction& bone,
  const SeatSettings& settings, double stepMm, double touchMm)
{
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : world)
    for (double depth = -settings.liftMm; depth < std::min(settings.pressMm, least);)
    {
      const double above = bone(p - depth * settings.withdrawal) - touchMm;
      if (above < 0.0)
      {
        least = depth;
        break;
      }
      depth += std::max(0.5 * above, stepMm);
    }
  return least;
}

inline RigidPose AnyPose(Dice& dice, double mm)
{
  const glm::dvec3 at = dice.InBox(mm), turn = dice.InBox(1.7);
  return { at, TurnBy(turn) };
}
inline glm::dvec3 AnyDirection(Dice& dice)
{
  return AnyPose(dice, 1.0).Turn({ 0, 0, 1 });
}

} // namespace hasp::testing
