#include "Grid/AnalyticShapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Any unit vector at right angles to a unit vector.
glm::dvec3 Across(const glm::dvec3& unit)
{
  const glm::dvec3 other = std::abs(unit.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(unit, other));
}

Foot FootOnBall(const glm::dvec3& fromCenter, double radius)
{
  const double length = glm::length(fromCenter);
  return { length - radius, length > 0.0 ? fromCenter / length : glm::dvec3(0, 0, 1) };
}

/// The root u of sum (r_i z_i / (u + r_i - 1))^2 = 1, after D. Eberly, "Distance from a point to an
/// ellipse, an ellipsoid, or a hyperellipsoid": z = |p| / radii, r = (radii / smallest)^2, u > 0.
/// The sum is convex and falls, so Newton from the left climbs to the root without a miss.
double EllipsoidRoot(const glm::dvec3& r, const glm::dvec3& z)
{
  const glm::dvec3 rz = r * z, more = r - 1.0; // exactly 0 on the smallest axis: no digit is lost
  const glm::dvec3 least = rz - more;
  double u =
    std::max({ least.x, least.y, least.z, glm::length(rz) - std::max({ more.x, more.y, more.z }) });
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 below = u + more;
    const glm::dvec3 q = rz / below, squares = q * q;
    const double g = squares.x + squares.y + squares.z - 1.0;
    const glm::dvec3 slope = squares / below;
    const double next = u + 0.5 * g / (slope.x + slope.y + slope.z);
    if (!(next > u * (1.0 + 1e-16)))
      break;
    u = next;
  }
  return u;
}

Foot FootOnShape(const EllipsoidShape& e, const glm::dvec3& point)
{
  const glm::dvec3 p = point - e.center;
  const double smallest = std::min({ e.radii.x, e.radii.y, e.radii.z });
  // On a plane of symmetry the root would be lost inside the evolute. 1e-14 of the size off it,
  // it is not, and the distance changes by no more than that.
  const glm::dvec3 y = glm::max(glm::abs(p), 1e-14 * smallest);
  const glm::dvec3 z = y / e.radii;
  const glm::dvec3 r = (e.radii / smallest) * (e.radii / smallest);
  const double u = EllipsoidRoot(r, z);
  const glm::dvec3 side(p.x < 0 ? -1 : 1, p.y < 0 ? -1 : 1, p.z < 0 ? -1 : 1);
  const glm::dvec3 nearest = r * y / (u + (r - 1.0));
  const double away = glm::length(y * ((u - 1.0) / (u + (r - 1.0))));
  return { std::copysign(away, u - 1.0), side * glm::normalize(nearest / (e.radii * e.radii)) };
}

Foot FootOnShape(const RoundConeShape& c, const glm::dvec3& point)
{
  const glm::dvec3 axis = c.b - c.a, d = point - c.a;
  const double length = glm::length(axis);
  if (length <= std::abs(c.radiusA - c.radiusB))
    return c.radiusA >= c.radiusB ? FootOnBall(d, c.radiusA) : FootOnBall(point - c.b, c.radiusB);
  // In the plane through the axis: x off the axis, y along it; (cosine, sine) is normal to the
  // side.
  const glm::dvec3 unit = axis / length;
  const double y = glm::dot(d, unit);
  const glm::dvec3 off = d - y * unit;
  const double x = glm::length(off);
  const double sine = (c.radiusA - c.radiusB) / length, cosine = std::sqrt(1.0 - sine * sine);
  const double along = cosine * y - sine * x;
  if (along <= 0.0)
    return FootOnBall(d, c.radiusA);
  if (along >= length * cosine)
    return FootOnBall(point - c.b, c.radiusB);
  const glm::dvec3 radial = x > 0.0 ? off / x : Across(unit);
  return { cosine * x + sine * y - c.radiusA, cosine * radial + sine * unit };
}

Foot FootOnShape(const HalfSpaceShape& h, const glm::dvec3& point)
{
  return { glm::dot(point - h.point, h.outward), h.outward };
}

Foot FootOnShape(const BarShape& bar, const glm::dvec3& point)
{
  const glm::dvec3 d = point - bar.center;
  const glm::dvec2 p(glm::dot(d, bar.along), glm::dot(d, bar.across));
  const glm::dvec2 q = glm::abs(p) - bar.half + bar.corner;
  glm::dvec2 n = glm::max(q, glm::dvec2(0.0));
  const double outside = glm::length(n);
  if (outside > 0.0)
    n /= outside;
  else
    n = q.x > q.y ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
  n = glm::dvec2(std::copysign(n.x, p.x), std::copysign(n.y, p.y));
  return { outside + std::min(std::max(q.x, q.y), 0.0) - bar.corner,
    n.x * bar.along + n.y * bar.across };
}

Foot FootOnShape(const HorseshoeShape& h, const glm::dvec3& point)
{
  const glm::dvec3 d = point - h.center;
  const double side = d.x < 0.0 ? -1.0 : 1.0;
  const glm::dvec2 p(std::abs(d.x), d.y);
  const double sine = std::sin(h.halfAngle), cosine = std::cos(h.halfAngle);
  const glm::dvec2 start = h.arc * glm::dvec2(sine, -cosine), forth(cosine, sine);
  glm::dvec2 nearest = start + std::clamp(glm::dot(p - start, forth), 0.0, h.arm) * forth;
  glm::dvec2 normal(sine, -cosine);
  const double angle = std::atan2(p.x, -p.y), reach = glm::length(p);
  if (angle < h.halfAngle && std::abs(reach - h.arc) < glm::length(p - nearest))
  {
    normal = reach > 0.0 ? p / reach : glm::dvec2(0, -1);
    nearest = h.arc * normal;
  }
  const glm::dvec3 v(
    side * (p.x - nearest.x), p.y - nearest.y, d.z - std::clamp(d.z, -h.halfHeight, h.halfHeight));
  const double away = glm::length(v);
  return { away - h.tube, away > 0.0 ? v / away : glm::dvec3(side * normal.x, normal.y, 0.0) };
}

/// The nearest point of a convex polygon in its plane or off it.
glm::dvec3 NearestOnFace(const PolyhedronShape::Face& face, const glm::dvec3& p, double height)
{
  const glm::dvec3 foot = p - height * face.outward;
  glm::dvec3 nearest = foot;
  double least = Infinity;
  bool within = true;
  for (std::size_t n = 0; n < face.corners.size(); ++n)
  {
    const glm::dvec3& a = face.corners[n];
    const glm::dvec3 edge = face.corners[(n + 1) % face.corners.size()] - a;
    if (glm::dot(glm::cross(edge, foot - a), face.outward) >= 0.0)
      continue;
    within = false;
    const double t = std::clamp(glm::dot(p - a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    const glm::dvec3 onEdge = a + t * edge;
    const double away = glm::dot(p - onEdge, p - onEdge);
    if (away < least)
    {
      least = away;
      nearest = onEdge;
    }
  }
  return within ? foot : nearest;
}

Foot FootOnShape(const PolyhedronShape& shape, const glm::dvec3& point)
{
  double highest = -Infinity, least = Infinity;
  glm::dvec3 outward(0.0), nearest(0.0);
  for (const PolyhedronShape::Face& face : shape.faces)
  {
    const double height = glm::dot(point - face.corners[0], face.outward);
    if (height > highest)
    {
      highest = height;
      outward = face.outward;
    }
    if (height <= 0.0)
      continue;
    const glm::dvec3 q = NearestOnFace(face, point, height);
    const double away = glm::length(point - q);
    if (away < least)
    {
      least = away;
      nearest = q;
    }
  }
  if (highest <= 0.0)
    return { highest - shape.rounding, outward };
  return { least - shape.rounding, (point - nearest) / least };
}

Box BoundsOfShape(const EllipsoidShape& e)
{
  return { e.center - e.radii, e.center + e.radii };
}
Box BoundsOfShape(const RoundConeShape& c)
{
  return { glm::min(c.a - c.radiusA, c.b - c.radiusB), glm::max(c.a + c.radiusA, c.b + c.radiusB) };
}
Box BoundsOfShape(const HalfSpaceShape&)
{
  return { glm::dvec3(-Infinity), glm::dvec3(Infinity) };
}
Box BoundsOfShape(const BarShape&)
{
  return { glm::dvec3(-Infinity), glm::dvec3(Infinity) };
}
Box BoundsOfShape(const HorseshoeShape& h)
{
  const glm::dvec3 end = h.PointAt(h.arc * h.halfAngle + h.arm) - h.center;
  const double wide = end.x + h.tube; // the arms point outwards
  return { h.center - glm::dvec3(wide, h.arc + h.tube, h.halfHeight + h.tube),
    h.center + glm::dvec3(wide, end.y + h.tube, h.halfHeight + h.tube) };
}
Box BoundsOfShape(const PolyhedronShape& shape)
{
  Box box{ glm::dvec3(Infinity), glm::dvec3(-Infinity) };
  for (const PolyhedronShape::Face& face : shape.faces)
    for (const glm::dvec3& corner : face.corners)
      box = { glm::min(box.low, corner - shape.rounding),
        glm::max(box.high, corner + shape.rounding) };
  return box;
}

} // namespace

glm::dvec3 HorseshoeShape::PointAt(double s) const
{
  const double bend = std::min(std::abs(s) / this->arc, this->halfAngle);
  const double straight = std::abs(s) - bend * this->arc;
  const double sine = std::sin(bend), cosine = std::cos(bend);
  return this->center + glm::dvec3(std::copysign(this->arc * sine + straight * cosine, s),
                          -this->arc * cosine + straight * sine, 0.0);
}

PolyhedronShape Frustum(
  const std::vector<glm::dvec3>& lower, const std::vector<glm::dvec3>& upper, double rounding)
{
  const std::size_t sides = lower.size();
  if (sides < 3 || upper.size() != sides)
    throw std::invalid_argument("Frustum: two polygons of " + std::to_string(sides) + " and " +
                                std::to_string(upper.size()) + " corners, must be >= 3 and equal");
  PolyhedronShape shape;
  shape.rounding = rounding;
  shape.faces = { { {}, lower }, { {}, upper } };
  glm::dvec3 middle(0.0);
  for (std::size_t n = 0; n < sides; ++n)
  {
    const std::size_t next = (n + 1) % sides;
    shape.faces.push_back({ {}, { lower[n], lower[next], upper[next], upper[n] } });
    middle += (lower[n] + upper[n]) / (2.0 * static_cast<double>(sides));
  }
  for (PolyhedronShape::Face& face : shape.faces)
  {
    const glm::dvec3& a = face.corners[0];
    glm::dvec3 normal = glm::cross(face.corners[1] - a, face.corners[2] - a);
    if (!(glm::length(normal) > 0.0 && glm::dot(normal, a - middle) != 0.0))
      throw std::invalid_argument("Frustum: the polygons span no volume");
    if (glm::dot(normal, a - middle) < 0.0)
    {
      std::reverse(face.corners.begin(), face.corners.end());
      normal = -normal;
    }
    face.outward = glm::normalize(normal);
  }
  return shape;
}

Foot FootOn(const AnalyticShape& shape, const glm::dvec3& point)
{
  return std::visit([&](const auto& s) { return FootOnShape(s, point); }, shape);
}

bool IsConvex(const AnalyticShape& shape)
{
  return !std::holds_alternative<HorseshoeShape>(shape);
}

Box BoundsOf(const AnalyticShape& shape)
{
  return std::visit([](const auto& s) { return BoundsOfShape(s); }, shape);
}

} // namespace hasp
