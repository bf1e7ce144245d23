#include "Grid/AnalyticSolid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
/// A nearest point this close to the solid's surface is on it: feet are good to 1e-12 mm.
constexpr double OnSurfaceMm = 1e-9;

/// Volume of the solid in a box: halved until the surface is away or the box is a cell.
double VolumeIn(const AnalyticSolid& solid, const Box& box, double cellMm)
{
  const glm::dvec3 size = box.high - box.low, middle = 0.5 * (box.low + box.high);
  const double all = size.x * size.y * size.z, radius = 0.5 * glm::length(size);
  const AnalyticSolid near = solid.Near(middle, radius);
  const Foot foot = near.Bound(middle);
  if (std::abs(foot.mm) >= radius)
    return foot.mm < 0.0 ? all : 0.0;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (size[axis] <= cellMm) // a plane cuts it
    return all * std::clamp(0.5 - foot.mm / glm::dot(size, glm::abs(foot.outward)), 0.0, 1.0);
  Box below = box, above = box;
  below.high[axis] = above.low[axis] = middle[axis];
  return VolumeIn(near, below, cellMm) + VolumeIn(near, above, cellMm);
}

} // namespace

/// A leaf has a shape and no parts. Complements are pushed down to the leaves.
struct AnalyticSolid::Node
{
  bool isUnion = true;
  bool flipped = false;
  AnalyticShape shape;
  std::vector<NodePointer> parts;
};

AnalyticSolid::AnalyticSolid(AnalyticShape shape)
  : Root(std::make_shared<Node>(Node{ true, false, std::move(shape), {} }))
{
}

AnalyticSolid::NodePointer AnalyticSolid::Join(bool isUnion, std::vector<NodePointer> parts)
{
  if (parts.empty())
    throw std::invalid_argument("AnalyticSolid: a union or intersection of 0 parts, needs >= 1");
  if (parts.size() == 1)
    return parts[0];
  return std::make_shared<Node>(Node{ isUnion, false, {}, std::move(parts) });
}

AnalyticSolid AnalyticSolid::Union(const std::vector<AnalyticSolid>& parts)
{
  std::vector<NodePointer> nodes;
  for (const AnalyticSolid& part : parts)
    nodes.push_back(part.Root);
  return AnalyticSolid(Join(true, std::move(nodes)));
}

AnalyticSolid AnalyticSolid::Intersection(const std::vector<AnalyticSolid>& parts)
{
  std::vector<NodePointer> nodes;
  for (const AnalyticSolid& part : parts)
    nodes.push_back(part.Root);
  return AnalyticSolid(Join(false, std::move(nodes)));
}

AnalyticSolid::NodePointer AnalyticSolid::Complement(const NodePointer& node)
{
  Node flipped = *node;
  if (node->parts.empty())
    flipped.flipped = !node->flipped;
  else
    flipped.isUnion = !node->isUnion;
  for (NodePointer& part : flipped.parts)
    part = Complement(part);
  return std::make_shared<Node>(std::move(flipped));
}

AnalyticSolid AnalyticSolid::Complement() const
{
  return AnalyticSolid(Complement(this->Root));
}

AnalyticSolid AnalyticSolid::Without(const AnalyticSolid& other) const
{
  return Intersection({ *this, other.Complement() });
}

Foot AnalyticSolid::FootOnLeaf(const Node& node, const glm::dvec3& point)
{
  const Foot foot = FootOn(node.shape, point);
  return node.flipped ? Foot{ -foot.mm, -foot.outward } : foot;
}

Foot AnalyticSolid::Bound(const Node& node, const glm::dvec3& point)
{
  if (node.parts.empty())
    return FootOnLeaf(node, point);
  Foot best = Bound(*node.parts[0], point);
  for (std::size_t n = 1; n < node.parts.size(); ++n)
  {
    const Foot foot = Bound(*node.parts[n], point);
    if (node.isUnion ? foot.mm < best.mm : foot.mm > best.mm)
      best = foot;
  }
  return best;
}

Foot AnalyticSolid::Bound(const glm::dvec3& point) const
{
  return Bound(*this->Root, point);
}

AnalyticSolid::NodePointer AnalyticSolid::Near(
  const NodePointer& node, const glm::dvec3& center, double radius, double& bound)
{
  if (node->parts.empty())
  {
    bound = FootOnLeaf(*node, center).mm;
    return node;
  }
  const double sign = node->isUnion ? 1.0 : -1.0; // both are minima of sign * value
  std::vector<NodePointer> near(node->parts.size());
  std::vector<double> bounds(node->parts.size());
  double least = Infinity;
  for (std::size_t n = 0; n < near.size(); ++n)
  {
    near[n] = Near(node->parts[n], center, radius, bounds[n]);
    least = std::min(least, sign * bounds[n]);
  }
  bound = sign * least;
  // Each value changes by at most `radius` within the ball (and feet are good to 1e-12 mm).
  const double most = least + 2.0 * radius + OnSurfaceMm;
  std::vector<NodePointer> kept;
  for (std::size_t n = 0; n < near.size(); ++n)
    if (sign * bounds[n] <= most)
      kept.push_back(std::move(near[n]));
  if (kept.size() == node->parts.size() && kept == node->parts)
    return node;
  return Join(node->isUnion, std::move(kept));
}

AnalyticSolid AnalyticSolid::Near(const glm::dvec3& center, double radius) const
{
  double bound = 0.0;
  return AnalyticSolid(Near(this->Root, center, radius, bound));
}

Box AnalyticSolid::Bounds(const Node& node)
{
  if (node.parts.empty())
    return node.flipped ? Box{ glm::dvec3(-Infinity), glm::dvec3(Infinity) } : BoundsOf(node.shape);
  Box box = Bounds(*node.parts[0]);
  for (const NodePointer& part : node.parts)
  {
    const Box other = Bounds(*part);
    if (node.isUnion)
      box = { glm::min(box.low, other.low), glm::max(box.high, other.high) };
    else
      box = { glm::max(box.low, other.low), glm::min(box.high, other.high) };
  }
  return box;
}

Box AnalyticSolid::Bounds() const
{
  return Bounds(*this->Root);
}

double AnalyticSolid::Volume(double cellMm) const
{
  const Box box = this->Bounds();
  const glm::dvec3 size = box.high - box.low;
  if (!(cellMm > 0.0 && std::isfinite(size.x + size.y + size.z)))
    throw std::invalid_argument(
      "AnalyticSolid: the volume of a solid without bounds, or cells of " + std::to_string(cellMm) +
      " mm; must be > 0");
  return VolumeIn(*this, box, cellMm);
}

void AnalyticSolid::Gather(const Node& node, const glm::dvec3& point, std::vector<Leaf>& leaves)
{
  if (node.parts.empty())
  {
    const Foot foot = FootOnLeaf(node, point);
    leaves.push_back({ &node, foot, point - foot.mm * foot.outward });
  }
  for (const NodePointer& part : node.parts)
    Gather(*part, point, leaves);
}

std::size_t AnalyticSolid::ShapeCount() const
{
  std::vector<Leaf> leaves;
  Gather(*this->Root, glm::dvec3(0.0), leaves);
  return leaves.size();
}

/// Newton's steps for the point nearest to `point` on the curve where two shapes' surfaces meet:
/// in each, the nearest point of the line where their tangent planes meet.
void AnalyticSolid::TryEdge(
  const Leaf& a, const Leaf& b, const glm::dvec3& point, SolidDistance& best) const
{
  glm::dvec3 x = a.nearest;
  for (int n = 0; n < 60; ++n)
  {
    const Foot fa = FootOnLeaf(*a.node, x), fb = FootOnLeaf(*b.node, x);
    const double c = glm::dot(fa.outward, fb.outward), det = 1.0 - c * c;
    if (det < 1e-8) // tangent: no curve
      return;
    const glm::dvec3 d = point - x;
    const double ra = -fa.mm - glm::dot(fa.outward, d), rb = -fb.mm - glm::dot(fb.outward, d);
    const glm::dvec3 step =
      d + ((ra - c * rb) / det) * fa.outward + ((rb - c * ra) / det) * fb.outward;
    x += step;
    if (glm::dot(step, step) < 1e-24)
      break;
  }
  const double away = glm::length(point - x);
  if (away < std::abs(best.mm) && std::abs(this->Bound(x).mm) < OnSurfaceMm)
  {
    best.mm = away;
    best.nearest = x;
  }
}

SolidDistance AnalyticSolid::Distance(const glm::dvec3& point) const
{
  std::vector<Leaf> leaves, hidden;
  Gather(*this->Root, point, leaves);
  std::sort(leaves.begin(), leaves.end(),
    [](const Leaf& a, const Leaf& b) { return std::abs(a.foot.mm) < std::abs(b.foot.mm); });
  SolidDistance best{ Infinity, 0.0, point };
  double least = Infinity; // no surface is nearer
  for (const Leaf& leaf : leaves)
  {
    const double away = std::abs(leaf.foot.mm);
    if (away >= std::abs(best.mm))
      break;
    const double clear = std::abs(this->Bound(leaf.nearest).mm);
    if (clear < OnSurfaceMm)
    {
      best.mm = away;
      best.nearest = leaf.nearest;
      continue;
    }
    // What is visible of this surface is at least `clear` from its nearest point to us; and behind
    // the tangent plane there, if the shape is convex and we are outside.
    const bool outside = (leaf.foot.mm > 0.0) != leaf.node->flipped && IsConvex(leaf.node->shape);
    least = std::min(least, std::max(away, outside ? std::hypot(away, clear) : clear - away));
    hidden.push_back(leaf);
  }
  const double bound = this->Bound(point).mm;
  least = std::max(least, std::abs(bound));
  if (least < best.mm)
    for (const Leaf& a : hidden)
      for (const Leaf& b : leaves)
        if (a.node != b.node && std::abs(b.foot.mm) < best.mm)
          this->TryEdge(a, b, point, best);
  best.errorMm = std::max(0.0, best.mm - std::min(best.mm, least));
  best.mm = std::copysign(best.mm, bound);
  return best;
}

} // namespace hasp
