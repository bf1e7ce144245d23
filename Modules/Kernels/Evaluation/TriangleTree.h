#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace hasp
{

/// Rays against the triangles of a mesh, and the places of it that are nearest to others, whatever
/// its faults: a tree of boxes, halved at the median. Double precision; a ray through an edge or a
/// point meets one of its triangles (a sum of areas within 1e-9 counts as inside). Triangles
/// without an area are never met by a ray; they are near as the lines and points that they are.
///
/// Immutable; any thread may ask. O(n log n) to make, 100 ms for 100,000 triangles, 120 bytes each;
/// about 1 us a ray, 2.5 us a nearest place within 1.5 mm of 100,000 triangles, one core of two
/// that were busy (NearestTriangle.ManyAskedForArePrinted). Throws std::invalid_argument on a
/// triangle whose points are not there.
class TriangleTree
{
public:
  explicit TriangleTree(const TriangleMesh& mesh);

  struct Hit
  {
    double t;               ///< hit = origin + t * direction
    std::uint32_t triangle; ///< of the mesh
    glm::dvec3 normal;      ///< unit, of that triangle, out of the solid
  };
  /// The first triangle with from < t < to; `direction` need not be unit.
  std::optional<Hit> First(const glm::dvec3& origin, const glm::dvec3& direction, double from = 0.0,
    double to = std::numeric_limits<double>::infinity()) const;

  struct Near
  {
    glm::dvec3 point;       ///< of the triangle, nearest to the place
    double distanceMm;      ///< >= 0
    std::uint32_t triangle; ///< of the mesh; one of those that are equally near
    glm::dvec3 normal;      ///< unit, of that triangle, out of the solid; 0 without an area
  };
  /// The nearest place of the mesh, if it is nearer than reachMm. Exact but for rounding; where a
  /// triangle is lower than 1e-4 of its longest side, to 1e-7 of that side (NearestTriangle.cxx).
  /// Nothing for a place that is not finite.
  std::optional<Near> Nearest(
    const glm::dvec3& place, double reachMm = std::numeric_limits<double>::infinity()) const;

  /// Is the place in the solid? By what side the first triangle towards `direction` shows: the mesh
  /// must be closed, and turned outwards.
  bool Inside(const glm::dvec3& place, const glm::dvec3& direction) const;

  ///@{
  /// Box of all triangles; low > high if there are none.
  const glm::dvec3& Low() const { return this->Lowest; }
  const glm::dvec3& High() const { return this->Highest; }
  ///@}
  /// Half the lengths of the box's sides along `direction`, about its middle.
  double Reach(const glm::dvec3& direction) const;
  glm::dvec3 Middle() const { return 0.5 * (this->Lowest + this->Highest); }

private:
  struct Corners
  {
    glm::dvec3 a, ab, ac;
    std::uint32_t triangle;
  };
  struct Node
  {
    glm::dvec3 low, high;
    std::uint32_t first, count; ///< count 0: children at first and first + 1
  };
  void Split(std::size_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Corners> Triangles;
  std::vector<Node> Nodes;
  glm::dvec3 Lowest{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Highest{ -std::numeric_limits<double>::infinity() };
};

} // namespace hasp
