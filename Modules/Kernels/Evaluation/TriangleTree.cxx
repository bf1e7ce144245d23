#include "Evaluation/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr std::uint32_t LeafSize = 4;

/// t of a ray in a triangle, if it is met (Moeller and Trumbore 1997).
std::optional<double> Meet(const glm::dvec3& a, const glm::dvec3& ab, const glm::dvec3& ac,
  const glm::dvec3& origin, const glm::dvec3& direction)
{
  constexpr double slack = 1e-9; // so that no ray slips between neighbours
  const glm::dvec3 p = glm::cross(direction, ac);
  const double det = glm::dot(ab, p);
  if (det == 0.0)
    return std::nullopt;
  const glm::dvec3 s = origin - a;
  const double u = glm::dot(s, p) / det;
  if (!(u >= -slack && u <= 1.0 + slack))
    return std::nullopt;
  const glm::dvec3 q = glm::cross(s, ab);
  const double v = glm::dot(direction, q) / det;
  if (!(v >= -slack && u + v <= 1.0 + slack))
    return std::nullopt;
  return glm::dot(ac, q) / det;
}

/// Where a ray enters a box, within [from, to]; infinity if it does not.
double Enter(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& origin,
  const glm::dvec3& inverse, double from, double to)
{
  // A place on a face of the box and a direction along it give NaN: min and max below drop it.
  for (int a = 0; a < 3; ++a)
  {
    const double t0 = (low[a] - origin[a]) * inverse[a], t1 = (high[a] - origin[a]) * inverse[a];
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  return from <= to ? from : std::numeric_limits<double>::infinity();
}
} // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh)
{
  this->Triangles.reserve(mesh.triangles.size());
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n)
  {
    const glm::uvec3& t = mesh.triangles[n];
    if (const std::uint32_t most = std::max({ t.x, t.y, t.z }); most >= mesh.points.size())
      throw std::invalid_argument("mesh: a triangle names point " + std::to_string(most) + " of " +
                                  std::to_string(mesh.points.size()));
    const glm::dvec3& a = mesh.points[t.x];
    this->Triangles.push_back({ a, mesh.points[t.y] - a, mesh.points[t.z] - a, n });
  }
  if (this->Triangles.empty())
    return;
  this->Nodes.reserve(this->Triangles.size());
  this->Nodes.emplace_back();
  this->Split(0, 0, static_cast<std::uint32_t>(this->Triangles.size()));
  this->Lowest = this->Nodes[0].low;
  this->Highest = this->Nodes[0].high;
}

void TriangleTree::Split(std::size_t node, std::uint32_t first, std::uint32_t count)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  glm::dvec3 lowMiddle = low, highMiddle = high;
  const auto middle = [](const Corners& c) { return c.a + (c.ab + c.ac) / 3.0; };
  for (std::uint32_t n = first; n < first + count; ++n)
  {
    const Corners& c = this->Triangles[n];
    low = glm::min(low, glm::min(c.a, glm::min(c.a + c.ab, c.a + c.ac)));
    high = glm::max(high, glm::max(c.a, glm::max(c.a + c.ab, c.a + c.ac)));
    lowMiddle = glm::min(lowMiddle, middle(c));
    highMiddle = glm::max(highMiddle, middle(c));
  }
  // Wider by more than rounding: a box without a thickness would lose its own triangles.
  const glm::dvec3 slack = 1e-9 + 1e-12 * glm::max(glm::abs(low), glm::abs(high));
  this->Nodes[node] = { low - slack, high + slack, first, count };
  if (count <= LeafSize)
    return;
  const glm::dvec3 side = highMiddle - lowMiddle;
  const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  const auto begin = this->Triangles.begin() + first;
  std::nth_element(begin, begin + half, begin + count,
    [&](const Corners& l, const Corners& r) { return middle(l)[axis] < middle(r)[axis]; });
  const std::size_t child = this->Nodes.size();
  this->Nodes.resize(child + 2);
  this->Nodes[node].first = static_cast<std::uint32_t>(child);
  this->Nodes[node].count = 0;
  this->Split(child, first, half);
  this->Split(child + 1, first + half, count - half);
}

std::optional<TriangleTree::Hit> TriangleTree::First(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const
{
  if (this->Nodes.empty())
    return std::nullopt;
  const glm::dvec3 inverse = 1.0 / direction;
  struct Waiting
  {
    std::uint32_t node;
    double entered;
  };
  std::array<Waiting, 64> stack; // halved at the median: 2^32 triangles are 30 levels
  int depth = 0;
  const Corners* met = nullptr;
  double best = std::min(to, std::numeric_limits<double>::max()); // less than what a miss gives
  const auto push = [&](std::uint32_t node, double entered)
  {
    if (entered <= best)
      stack[depth++] = { node, entered };
  };
  push(0, Enter(this->Nodes[0].low, this->Nodes[0].high, origin, inverse, from, best));
  while (depth > 0)
  {
    const Waiting next = stack[--depth];
    if (next.entered > best)
      continue;
    const Node& node = this->Nodes[next.node];
    for (std::uint32_t n = 0; n < node.count; ++n)
    {
      const Corners& c = this->Triangles[node.first + n];
      if (const auto t = Meet(c.a, c.ab, c.ac, origin, direction); t && *t > from && *t < best)
      {
        best = *t;
        met = &c;
      }
    }
    if (node.count > 0)
      continue;
    const Node &left = this->Nodes[node.first], &right = this->Nodes[node.first + 1];
    const double l = Enter(left.low, left.high, origin, inverse, from, best);
    const double r = Enter(right.low, right.high, origin, inverse, from, best);
    const std::uint32_t near = l <= r ? 0 : 1; // the nearer child is asked first
    push(node.first + 1 - near, std::max(l, r));
    push(node.first + near, std::min(l, r));
  }
  if (!met)
    return std::nullopt;
  return Hit{ best, met->triangle, glm::normalize(glm::cross(met->ab, met->ac)) };
}

bool TriangleTree::Inside(const glm::dvec3& place, const glm::dvec3& direction) const
{
  const auto hit = this->First(place, direction);
  return hit && glm::dot(hit->normal, direction) > 0.0;
}

double TriangleTree::Reach(const glm::dvec3& direction) const
{
  return this->Nodes.empty() ? 0.0
                             : 0.5 * glm::dot(glm::abs(direction), this->Highest - this->Lowest);
}

} // namespace hasp
