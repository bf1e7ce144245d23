#include "Planning/BladeHandles.h"

#include "Planning/BladePlacing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double LeastCosine = 0.1; // of what is seen from its edge

/// Where a ray passes the plane through a point; the cosine between them is not 0.
glm::dvec3 OnPlane(const PointerRay& ray, const glm::dvec3& point, const glm::dvec3& normal)
{
  const double way = glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal);
  return ray.origin + way * ray.direction;
}

/// As far as the pointer has gone in the plane through a place that faces the viewer.
glm::dvec3 SeenWay(const PointerRay& from, const PointerRay& to, const glm::dvec3& place)
{
  return OnPlane(to, place, from.direction) - OnPlane(from, place, from.direction);
}

glm::dvec3 WayInPlane(
  const Osteotomy& start, const glm::dvec3& normal, const PointerRay& from, const PointerRay& to)
{
  const auto faces = [&](const PointerRay& ray)
  { return std::abs(glm::dot(ray.direction, normal)) >= LeastCosine; };
  if (faces(from) && faces(to))
    return OnPlane(to, start.point, normal) - OnPlane(from, start.point, normal);
  const glm::dvec3 way = SeenWay(from, to, start.point);
  return way - glm::dot(way, normal) * normal;
}

/// How far along a line its point is that a ray comes nearest to.
double NearestOnLine(const PointerRay& ray, const glm::dvec3& point, const glm::dvec3& along)
{
  const double cosine = glm::dot(ray.direction, along);
  const glm::dvec3 from = ray.origin - point;
  return (glm::dot(from, along) - cosine * glm::dot(from, ray.direction)) / (1.0 - cosine * cosine);
}

double WayAlong(
  const Osteotomy& start, const glm::dvec3& normal, const PointerRay& from, const PointerRay& to)
{
  const auto crosses = [&](const PointerRay& ray)
  { return glm::length(glm::cross(ray.direction, normal)) >= LeastCosine; };
  if (crosses(from) && crosses(to))
    return NearestOnLine(to, start.point, normal) - NearestOnLine(from, start.point, normal);
  return glm::dot(SeenWay(from, to, start.point), normal);
}

/// On the ball around the middle that the corner is on, from the middle: of the two places under
/// the ray the one next to `near`; beyond the rim the rim's.
glm::dvec3 OnBall(
  const PointerRay& ray, const glm::dvec3& middle, double radius, const glm::dvec3& near)
{
  const double way = glm::dot(middle - ray.origin, ray.direction);
  const glm::dvec3 closest = ray.origin + way * ray.direction - middle;
  const double away = glm::length(closest);
  if (away >= radius)
    return radius / away * closest;
  const double half = std::sqrt(radius * radius - away * away);
  const glm::dvec3 before = closest - half * ray.direction, behind = closest + half * ray.direction;
  return glm::distance(before, near) <= glm::distance(behind, near) ? before : behind;
}

/// The shortest turn that brings one direction to another.
glm::dquat ShortestTurn(const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 from = glm::normalize(a), to = glm::normalize(b);
  const double cosine = glm::dot(from, to);
  if (cosine < -1.0 + 1e-9) // any axis: a drag does not get there in one event
    return { 1.0, 0.0, 0.0, 0.0 };
  return glm::normalize(glm::dquat(1.0 + cosine, glm::cross(from, to)));
}
} // namespace

glm::dvec3 HandlePlace(const Osteotomy& blade, BladeHandle handle)
{
  const glm::dmat3 axes = BladeAxes(blade);
  const auto corner = [&](double x, double y)
  { return blade.point + 0.5 * x * blade.widthMm * axes[0] + 0.5 * y * blade.depthMm * axes[1]; };
  switch (handle)
  {
    case BladeHandle::Normal:
      return blade.point + std::max(5.0, 0.25 * std::min(blade.widthMm, blade.depthMm)) * axes[2];
    case BladeHandle::Corner0:
      return corner(-1, -1);
    case BladeHandle::Corner1:
      return corner(1, -1);
    case BladeHandle::Corner2:
      return corner(1, 1);
    case BladeHandle::Corner3:
      return corner(-1, 1);
    default:
      return blade.point;
  }
}

Osteotomy DraggedBlade(
  const Osteotomy& start, BladeHandle handle, const PointerRay& from, const PointerRay& to)
{
  Osteotomy blade = start;
  const glm::dvec3 normal = BladeAxes(start)[2];
  if (handle == BladeHandle::Middle)
    blade.point += WayInPlane(start, normal, from, to);
  else if (handle == BladeHandle::Normal)
    blade.point += WayAlong(start, normal, from, to) * normal;
  else
  {
    const glm::dvec3 corner = HandlePlace(start, handle) - start.point;
    const double radius = glm::length(corner);
    const glm::dvec3 pressed = OnBall(from, start.point, radius, corner);
    blade = TurnedBlade(start, ShortestTurn(pressed, OnBall(to, start.point, radius, pressed)));
  }
  return blade;
}

} // namespace hasp
