#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"
#include "Reduction/SmoothPoints.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hasp
{

struct FitBodySettings
{
  double pointMm2 = 0.5;       ///< of surface for each point of the shell, about, [0.01, 100]
  int mostPoints = 131'072;    ///< of the shell, whatever the surface, [64, 10^6]
  double smoothMm = 2.0;       ///< normals are averaged so far around a point, in (0, 20]
  double flatness = 0.95;      ///< length of an averaged normal from which on it is smooth, (0, 1)
  double smoothPointMm2 = 2.5; ///< of smooth surface for each smooth point, [0.01, 100]
};

/// A fragment as fits read it: the distances around it, points all over its surface, and of these
/// the ones where the surface is smooth, with averaged normals. All in the body's own axes, those
/// of its shell and map, mm. Immutable; any thread, once made. About 56 bytes a point; O(points
/// times their neighbours within smoothMm).
class FitBody
{
public:
  /// Both were baked of one fragment with one origin. Throws std::invalid_argument where one of
  /// them is null, the shell has no points, it reaches beyond the map, or a setting is out of
  /// range.
  FitBody(std::shared_ptr<const DistanceMap> map, std::shared_ptr<const PointShell> shell,
    const FitBodySettings& settings = {});

  struct Foot
  {
    double mm;          ///< NEGATIVE INSIDE
    glm::dvec3 outward; ///< unit
  };
  /// The surface before a place; nothing where it is farther than the map's range, or the place is
  /// where distances have no direction.
  std::optional<Foot> FootOf(const glm::dvec3& place) const noexcept;
  double RangeMm() const noexcept { return this->Range; } ///< of FootOf

  /// Evenly over the surface: the first of the shell's whole levels that are no more than `most`,
  /// but the coarsest in any case. Each stands for SurfaceArea() / size.
  std::span<const OrientedPoint> Points(std::size_t most) const noexcept;
  /// visit(point) for those of Points(count) that are in a ball, and for some beside it.
  template <typename Visit>
  void ForPointsNear(
    std::size_t count, const glm::dvec3& center, double radiusMm, const Visit& visit) const
  {
    this->Boxes->NearTo(center, radiusMm,
      [&](std::uint32_t n)
      {
        if (n < count)
          visit(this->Shell[n]);
      });
  }
  double SurfaceArea() const noexcept { return this->Area; } ///< mm^2
  const SmoothPoints& Smooth() const noexcept { return *this->SmoothOnes; }

  double RadiusMm() const noexcept { return this->Radius; } ///< of the ball around the origin
  const glm::dvec3& Centroid() const noexcept { return this->Middle; } ///< of the surface
  /// Mean of outer products of the points' places about the centroid, mm^2: what a turn does.
  const glm::dmat3& Spread() const noexcept { return this->SpreadOut; }

private:
  std::shared_ptr<const DistanceMap> Map;
  glm::dvec3 MapOrigin;
  double Range;
  std::vector<OrientedPoint> Shell;
  std::vector<std::size_t> LevelEnds;
  std::shared_ptr<const PointBoxes> Boxes; ///< of all of the shell
  std::shared_ptr<const SmoothPoints> SmoothOnes;
  double Area, Radius;
  glm::dvec3 Middle{ 0.0 };
  glm::dmat3 SpreadOut{ 0.0 };
};

/// A body, and where it stands.
struct PlacedBody
{
  std::shared_ptr<const FitBody> body;
  RigidPose bodyInWorld;
};

} // namespace hasp
