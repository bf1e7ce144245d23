#pragma once
#include "Distance/BoundedSolid.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <span>

namespace hasp
{

/// Where an edge meets the surface.
struct EdgeCrossing
{
  double share = 0.5; ///< of the way from a to b, in (0, 1)
  glm::dvec3 at{};
  ImplicitSolid::Sample sample{};
};
/// The values at a and b have different sides. At most 40 samples, 1 or 2 where one plane crosses.
EdgeCrossing FindCrossing(const BoundedSolid& solid, const glm::dvec3& a, double valueA,
  const glm::dvec3& b, double valueB) noexcept;

/// What counts as a tip.
struct TipLimits
{
  double margin; ///< share that a place in it keeps from each corner; above 0.3 there is no room
  double depth;  ///< mm: it is deeper than that, and than 0.7 % of its edge
};

/// Between a and b, of one side, the solid may come through the edge and go again, with the tip of
/// a wedge, say. The middle of such a tip, as a share of the edge; nothing if none is deep enough,
/// or there is no room.
std::optional<double> FindTip(const BoundedSolid& solid, const glm::dvec3& a,
  const ImplicitSolid::Sample& sampleA, const glm::dvec3& b, const ImplicitSolid::Sample& sampleB,
  const TipLimits& limits) noexcept;

/// The same on an edge that is crossed, before the crossing or behind: it is crossed three times.
std::optional<double> FindTip(const BoundedSolid& solid, const glm::dvec3& a,
  const ImplicitSolid::Sample& sampleA, const glm::dvec3& b, const ImplicitSolid::Sample& sampleB,
  const EdgeCrossing& crossing, const TipLimits& limits) noexcept;

/// The same in a triangle, for corners that come through it between its sides: shares of its
/// corners.
std::optional<glm::dvec3> FindTip(const BoundedSolid& solid,
  const std::array<glm::dvec3, 3>& triangle, bool inside, const TipLimits& limits) noexcept;

/// A place in a simplex where the surface bends between the crossings of its edges.
struct BendPoint
{
  glm::dvec3 at{};
  std::uint32_t faces[2]{}; ///< that meet here; twice the same where one only curves

  bool Crease() const { return this->faces[0] != this->faces[1]; }
};
/// None, one or two of them, on the way from p to q.
struct Bends
{
  int count = 0;
  BendPoint point[2];
};
/// In the plane of a triangle whose sides are crossed at p and q: where the faces at p and q,
/// continued, meet in that plane, or both meet a third one that cuts that corner off, or where the
/// one face is half way. Nothing if that is no further than `tolerance` from the straight line, mm.
/// It may lie outside of the triangle.
Bends FindBends(const BoundedSolid& solid, const glm::dvec3& planeNormal, const EdgeCrossing& p,
  const EdgeCrossing& q, double tolerance) noexcept;

/// A face of the solid at a place of its surface.
struct FacePlace
{
  glm::dvec3 at{};
  std::uint32_t face = 0;
};
/// In a tetrahedron on whose edges and triangles the surface has these: the corner of three faces
/// if it lies there, else a place on the crease of two or on the one face, near to `start`, maybe
/// outside of it.
glm::dvec3 FindCorner(const BoundedSolid& solid, const std::array<glm::dvec3, 4>& tetrahedron,
  std::span<const FacePlace> places, const glm::dvec3& start, double tolerance) noexcept;

/// Shares of the corners that make up a point, in the plane of a triangle or in space.
glm::dvec3 Barycentric(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& point) noexcept;
glm::dvec4 Barycentric(
  const std::array<glm::dvec3, 4>& tetrahedron, const glm::dvec3& point) noexcept;

} // namespace hasp
