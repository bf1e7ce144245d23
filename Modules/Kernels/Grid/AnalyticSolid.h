#pragma once
#include "Grid/AnalyticShapes.h"

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

namespace hasp
{

/// The distance of a point to a solid's surface, with what is proven about it.
struct SolidDistance
{
  double mm = 0.0;      ///< signed, NEGATIVE INSIDE; its size is never less than the true distance
  double errorMm = 0.0; ///< the true distance is at most this much smaller; 0: it is proven
  glm::dvec3 nearest{ 0.0 }; ///< the surface point that lies |mm| away
};

/// Solids put together from shapes by union, intersection and complement, their distance known.
///
/// Bound is the usual minimum and maximum of distances: its sign is right, it is 1-Lipschitz and
/// never larger in size than the true distance, but short of it near edges where parts meet.
/// Distance is the true one. The surface of the solid is made of pieces of the shapes' surfaces:
///  - The nearest point of a shape's surface, if it lies on the solid's, bounds the distance above.
///  - If it is hidden (inside another part, or cut away), no surface lies within |Bound| of it, and
///    so the shape's visible piece bounds the distance below.
///  - The smallest of all is the distance; it is proven where the bounds meet (errorMm 0). Else the
///    nearest points of the curves where two shapes' surfaces meet are found by Newton steps.
/// Limit: no two shapes' surfaces may coincide over an area.
/// Immutable, cheap to copy; any thread.
class AnalyticSolid
{
public:
  /// A shape is a solid: meant to convert.
  AnalyticSolid(AnalyticShape shape);
  template <typename Shape>
  requires std::constructible_from<AnalyticShape, Shape> AnalyticSolid(Shape shape)
    : AnalyticSolid(AnalyticShape(std::move(shape)))
  {
  }
  static AnalyticSolid Union(const std::vector<AnalyticSolid>& parts);        ///< of at least one
  static AnalyticSolid Intersection(const std::vector<AnalyticSolid>& parts); ///< of at least one
  AnalyticSolid Complement() const;
  /// This without the other.
  AnalyticSolid Without(const AnalyticSolid& other) const;

  /// O(shapes).
  Foot Bound(const glm::dvec3& point) const;
  /// O(shapes) where the nearest point is on the surface, up to O(shapes^2) at hidden ones.
  SolidDistance Distance(const glm::dvec3& point) const;

  /// A smaller solid with the very same Bound, bit for bit, at all points of a ball.
  AnalyticSolid Near(const glm::dvec3& center, double radius) const;

  /// mm^3, by cells of that side along the surface: the error falls with its square (a ball of
  /// radius 5 mm: 0.8 % at 1 mm, 0.06 % at 0.25 mm). Throws std::invalid_argument if the solid has
  /// no bounds or cellMm <= 0.
  double Volume(double cellMm) const;

  /// An upright box around it, infinite where no shape bounds it; not always the smallest.
  Box Bounds() const;
  std::size_t ShapeCount() const;

private:
  struct Node;
  using NodePointer = std::shared_ptr<const Node>;
  struct Leaf
  {
    const Node* node;
    Foot foot;
    glm::dvec3 nearest;
  };
  explicit AnalyticSolid(NodePointer root) : Root(std::move(root)) {}
  static NodePointer Join(bool isUnion, std::vector<NodePointer> parts);
  static NodePointer Complement(const NodePointer& node);
  static Foot FootOnLeaf(const Node& node, const glm::dvec3& point);
  static Foot Bound(const Node& node, const glm::dvec3& point);
  static NodePointer Near(
    const NodePointer& node, const glm::dvec3& center, double radius, double& bound);
  static Box Bounds(const Node& node);
  static void Gather(const Node& node, const glm::dvec3& point, std::vector<Leaf>& leaves);
  void TryEdge(const Leaf& a, const Leaf& b, const glm::dvec3& point, SolidDistance& best) const;

  NodePointer Root;
};

} // namespace hasp
