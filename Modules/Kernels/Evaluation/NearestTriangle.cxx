#include "Evaluation/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{

namespace
{

double Square(const glm::dvec3& v)
{
  return glm::dot(v, v);
}

/// Of the line from a to a + ab, its ends included, nearest to a + ap; relative to a.
glm::dvec3 OnLine(const glm::dvec3& ab, const glm::dvec3& ap)
{
  const double length = Square(ab);
  const double t = length > 0.0 ? glm::dot(ap, ab) / length : 0.0;
  return std::clamp(t, 0.0, 1.0) * ab;
}

/// Nearest of a triangle that has hardly an area: of its three sides, or of what is within them.
/// The latter is a place of the triangle even where its share of each corner is mostly rounding.
glm::dvec3 OnSliver(const glm::dvec3& ab, const glm::dvec3& ac, const glm::dvec3& ap)
{
  const std::array<glm::dvec3, 3> sides{ OnLine(ab, ap), OnLine(ac, ap),
    ab + OnLine(ac - ab, ap - ab) };
  glm::dvec3 best = sides[0];
  const auto take = [&](const glm::dvec3& place)
  {
    if (Square(place - ap) < Square(best - ap))
      best = place;
  };
  take(sides[1]);
  take(sides[2]);
  const glm::dvec3 n = glm::cross(ab, ac);
  const double v = glm::dot(glm::cross(ap, ac), n), w = glm::dot(glm::cross(ab, ap), n);
  if (const double all = Square(n); all > 0.0 && v > 0.0 && w > 0.0 && v + w < all)
    take(v / all * ab + w / all * ac);
  return best;
}

/// Nearest of a triangle with corners 0, ab and ac, to ap: by the corner, side or face that it
/// belongs to (Ericson 2005, Real-Time Collision Detection, 5.1.5).
glm::dvec3 OnTriangle(const glm::dvec3& ab, const glm::dvec3& ac, const glm::dvec3& ap)
{
  constexpr double sliver = 1e-4; // height over longest side
  const double longest = std::max({ Square(ab), Square(ac), Square(ac - ab) });
  if (!(Square(glm::cross(ab, ac)) > sliver * sliver * longest * longest))
    return OnSliver(ab, ac, ap);
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0)
    return glm::dvec3(0.0);
  const glm::dvec3 bp = ap - ab;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3)
    return ab;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
    return d1 / (d1 - d3) * ab;
  const glm::dvec3 cp = ap - ac;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6)
    return ac;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
    return d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return ab + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (ac - ab);
  const double all = va + vb + vc;
  return vb / all * ab + vc / all * ac;
}

/// Squared distance of a place from a box, 0 within it.
double Away(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& place)
{
  return Square(glm::max(glm::max(low - place, place - high), glm::dvec3(0.0)));
}

} // namespace

std::optional<TriangleTree::Near> TriangleTree::Nearest(
  const glm::dvec3& place, double reachMm) const
{
  if (this->Nodes.empty() || !(reachMm > 0.0) || !std::isfinite(place.x + place.y + place.z))
    return std::nullopt;
  struct Waiting
  {
    std::uint32_t node;
    double away;
  };
  std::array<Waiting, 64> stack; // halved at the median: 2^32 triangles are 30 levels
  int depth = 0;
  const Corners* near = nullptr;
  glm::dvec3 point(0.0);
  double best = reachMm * reachMm;
  const auto push = [&](std::uint32_t node, double away)
  {
    if (away < best)
      stack[depth++] = { node, away };
  };
  push(0, Away(this->Nodes[0].low, this->Nodes[0].high, place));
  while (depth > 0)
  {
    const Waiting next = stack[--depth];
    if (next.away >= best)
      continue;
    const Node& node = this->Nodes[next.node];
    for (std::uint32_t n = 0; n < node.count; ++n)
    {
      const Corners& c = this->Triangles[node.first + n];
      const glm::dvec3 ap = place - c.a, on = OnTriangle(c.ab, c.ac, ap);
      if (const double away = Square(on - ap); away < best)
      {
        best = away;
        near = &c;
        point = c.a + on;
      }
    }
    if (node.count > 0)
      continue;
    const Node &left = this->Nodes[node.first], &right = this->Nodes[node.first + 1];
    const double l = Away(left.low, left.high, place), r = Away(right.low, right.high, place);
    const std::uint32_t first = l <= r ? 0 : 1; // the nearer child is asked first
    push(node.first + 1 - first, std::max(l, r));
    push(node.first + first, std::min(l, r));
  }
  if (!near)
    return std::nullopt;
  const glm::dvec3 normal = glm::cross(near->ab, near->ac);
  const double length = glm::length(normal);
  return Near{ point, std::sqrt(best), near->triangle,
    length > 0.0 ? normal / length : glm::dvec3(0.0) };
}

} // namespace hasp
