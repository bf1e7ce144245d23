#pragma once
// A block with a slot and a hole, and how sharp a mesh of it is. Tests and the benchmark share it.
#include "Distance/Csg.h"
#include "Distance/ImplicitShapes.h"
#include "Distance/SolidShapes.h"
#include "Grid/GridGeometry.h"
#include "Grid/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace hasp
{

/// A grid of cubes that is at least as large as the cube of this half side.
inline GridGeometry GridAround(const glm::dvec3& center, double half, double spacing)
{
  const int n = int(std::ceil(2 * half / spacing)) + 1;
  return { glm::ivec3(n), center - 0.5 * spacing * (n - 1), glm::dvec3(spacing), glm::dmat3(1) };
}

/// From a point to a triangle, mm.
inline double DistanceToTriangle(
  const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const auto beside = [&](const glm::dvec3& p, const glm::dvec3& q)
  { return glm::dot(glm::cross(q - p, x - p), n) < 0; };
  if (!beside(a, b) && !beside(b, c) && !beside(c, a))
    return std::abs(glm::dot(x - a, glm::normalize(n)));
  return std::min(
    { CapsuleDistance(x, a, b, 0), CapsuleDistance(x, b, c, 0), CapsuleDistance(x, c, a, 0) });
}

/// From a point to a mesh, by all of its triangles, mm; at most 1.
inline double DistanceToMesh(const glm::dvec3& x, const TriangleMesh& mesh)
{
  double least = 1.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 out =
      glm::max(glm::min(a, glm::min(b, c)) - x, x - glm::max(a, glm::max(b, c)));
    if (std::max({ out.x, out.y, out.z }) < least)
      least = std::min(least, DistanceToTriangle(x, a, b, c));
  }
  return least;
}

inline glm::dmat3 AnyAxes(std::mt19937& random)
{
  const auto any = [&] { return 2.0 * double(random()) / double(std::mt19937::max()) - 1.0; };
  const auto direction = [&]
  {
    const double x = any(), y = any(), z = any();
    return glm::dvec3(x, y, z);
  };
  const glm::dvec3 x = glm::normalize(direction()), y = glm::normalize(glm::cross(x, direction()));
  return { x, y, glm::cross(x, y) };
}

/// A block of 12 x 10 x 6 mm with a slot of 1 mm, 4 mm deep, and a hole of 2 mm.
struct SlottedBlock
{
  glm::dvec3 at{ 0.0 };
  glm::dmat3 axes{ 1.0 };

  glm::dvec3 World(double x, double y, double z) const { return at + axes * glm::dvec3(x, y, z); }
  glm::dvec3 Local(const glm::dvec3& world) const { return (world - at) * axes; }
  SolidPointer Solid() const
  {
    return MakeDifference(
      MakeDifference(MakeBox(at, axes, { 6, 5, 3 }), MakeBox(World(2, 0, 2), axes, { 0.5, 8, 3 })),
      MakeCylinder(World(-2, 0, -8), World(-2, 0, 8), 1.0));
  }
  /// Where two planes meet at 90 degrees, inwards or outwards.
  std::vector<std::pair<glm::dvec3, glm::dvec3>> Edges() const
  {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> lines;
    for (const double a : { -1.0, 1.0 })
      for (const double b : { -1.0, 1.0 })
      {
        lines.emplace_back(World(-6, 5 * a, 3 * b), World(1, 5 * a, 3 * b));
        lines.emplace_back(World(6 * a, -5, 3 * b), World(6 * a, 5, 3 * b));
        lines.emplace_back(World(6 * a, 5 * b, -3), World(6 * a, 5 * b, 3));
        lines.emplace_back(World(2 + 0.5 * a, -5, 1 + b), World(2 + 0.5 * a, 5, 1 + b));
      }
    return lines;
  }
};

/// All in mm. Radii are those of a fillet that is as far from its edge as the mesh is.
struct Sharpness
{
  double flat = 0;   ///< the walls of the slot off their planes, at most
  double edge = 0;   ///< radius of edges, 0.4 mm and more from their ends, at most
  double edge95 = 0; ///< the same, 95 of 100
  double corner = 0; ///< radius nearer to the ends
  double rim = 0;    ///< radius of the hole's rims
  double hole = 0;   ///< the fitted cylinder's diameter off 2 mm

  void KeepMost(const Sharpness& other)
  {
    for (double Sharpness::*figure : { &Sharpness::flat, &Sharpness::edge, &Sharpness::edge95,
           &Sharpness::corner, &Sharpness::rim, &Sharpness::hole })
      this->*figure = std::max(this->*figure, other.*figure);
  }
};

inline Sharpness MeasureSharpness(const SlottedBlock& block, const TriangleMesh& mesh)
{
  Sharpness most;
  double area = 0, radius = 0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    for (const glm::dvec3& world : { a, b, c, (a + b + c) / 3.0 })
    {
      const glm::dvec3 x = block.Local(world);
      const double wall = std::abs(std::abs(x.x - 2) - 0.5);
      if (wall < 0.2 && x.z > -0.8 && x.z < 2.8 && std::abs(x.y) < 4.8)
        most.flat = std::max(most.flat, wall);
    }
    const glm::dvec3 middle = block.Local((a + b + c) / 3.0);
    const double r = std::hypot(middle.x + 2, middle.y);
    if (std::abs(r - 1) < 0.2 && std::abs(middle.z) < 2.8)
    {
      const double weight = glm::length(glm::cross(b - a, c - a));
      area += weight, radius += weight * r;
    }
  }
  most.hole = 2 * std::abs(radius / area - 1);
  const double fillet = std::sqrt(2.0) - 1; // of 1 mm: how far it is from the edge
  std::vector<double> edges;
  for (const auto& [a, b] : block.Edges())
    for (int n = 0; n <= 60; ++n)
    {
      const double off = DistanceToMesh(a + (n / 60.0) * (b - a), mesh) / fillet;
      if (std::min(n, 60 - n) / 60.0 * glm::distance(a, b) < 0.4)
        most.corner = std::max(most.corner, off);
      else
        edges.push_back(off);
    }
  std::sort(edges.begin(), edges.end());
  most.edge = edges.back(), most.edge95 = edges[edges.size() * 95 / 100];
  for (int n = 0; n < 100; ++n)
    for (const double z : { -3.0, 3.0 })
      most.rim = std::max(most.rim,
        DistanceToMesh(block.World(-2 + std::cos(0.0628 * n), std::sin(0.0628 * n), z), mesh) /
          fillet);
  return most;
}

} // namespace hasp
