#pragma once
// Closed meshes whose walls, slots and holes are known.
#include "Evaluation/MeshCheck.h"
#include "Grid/TriangleMesh.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace parttest
{

/// A rigid motion of a part made at the origin.
struct Motion
{
  glm::dmat3 turn{ 1.0 };
  glm::dvec3 to{ 0.0 };

  glm::dvec3 Place(const glm::dvec3& p) const { return this->to + this->turn * p; }
  glm::dvec3 Turn(const glm::dvec3& d) const { return this->turn * d; }
  hasp::TriangleMesh operator()(hasp::TriangleMesh mesh) const
  {
    for (glm::dvec3& p : mesh.points)
      p = this->Place(p);
    return mesh;
  }
};

inline Motion AnyMotion(int seed)
{
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0 + seed, 2.0 - seed, 0.7 * seed - 1.3));
  return { glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4 + 1.1 * seed, axis)),
    { 12.5 * seed, -90.0 + seed, 140.0 - 31.0 * seed } };
}

/// The boxes between the lines x, y, z that `filled` names by their numbers, as one closed mesh.
inline hasp::TriangleMesh Blocks(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<double>& z, const std::function<bool(int, int, int)>& filled)
{
  const glm::ivec3 count(int(x.size()) - 1, int(y.size()) - 1, int(z.size()) - 1);
  const auto in = [&](const glm::ivec3& c)
  {
    for (int a = 0; a < 3; ++a)
      if (c[a] < 0 || c[a] >= count[a])
        return false;
    return filled(c.x, c.y, c.z);
  };
  hasp::TriangleMesh mesh;
  const auto face = [&](const glm::ivec3& cell, int axis, int side)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::ivec3 corners[4] = { cell, cell, cell, cell };
    corners[1][u] += 1, corners[2][u] += 1, corners[2][v] += 1, corners[3][v] += 1;
    const auto base = static_cast<std::uint32_t>(mesh.points.size());
    for (glm::ivec3& c : corners)
    {
      c[axis] += side;
      mesh.points.emplace_back(x[c.x], y[c.y], z[c.z]);
    }
    const std::uint32_t b = side ? base + 1 : base + 3, d = side ? base + 3 : base + 1;
    mesh.triangles.emplace_back(base, b, base + 2);
    mesh.triangles.emplace_back(base, base + 2, d);
  };
  for (int k = 0; k < count.z; ++k)
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i)
        for (int axis = 0; in({ i, j, k }) && axis < 3; ++axis)
          for (int side = 0; side < 2; ++side)
          {
            glm::ivec3 next(i, j, k);
            next[axis] += 2 * side - 1;
            if (!in(next))
              face({ i, j, k }, axis, side);
          }
  return hasp::WeldPoints(mesh);
}

/// A tube around z from -height / 2 to height / 2, of `sides` flat sides whose middles lie on the
/// circles of these radii.
inline hasp::TriangleMesh Tube(double inner, double outer, double height, int sides)
{
  const double widen = 1.0 / std::cos(glm::pi<double>() / sides);
  hasp::TriangleMesh mesh;
  for (int n = 0; n < sides; ++n)
  {
    const double angle = n * glm::two_pi<double>() / sides;
    for (const double r : { inner * widen, outer * widen })
      for (const double z : { -0.5 * height, 0.5 * height })
        mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  };
  for (std::uint32_t n = 0; n < std::uint32_t(sides); ++n)
  {
    const std::uint32_t p = 4 * n, q = 4 * ((n + 1) % std::uint32_t(sides));
    quad(p, p + 1, q + 1, q);         // the hole's wall
    quad(p + 2, q + 2, q + 3, p + 3); // the outer wall
    quad(p + 1, p + 3, q + 3, q + 1); // top
    quad(p, q, q + 2, p + 2);         // bottom
  }
  return mesh;
}

/// A ball of flat triangles, its points on the sphere.
inline hasp::TriangleMesh Ball(double radius, int rings)
{
  hasp::TriangleMesh mesh;
  const int around = 2 * rings;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < around; ++i)
    {
      const double polar = j * glm::pi<double>() / rings, turn = i * glm::pi<double>() / rings;
      mesh.points.push_back(j == 0 || j == rings
                              ? glm::dvec3(0, 0, j == 0 ? radius : -radius)
                              : radius * glm::dvec3(std::sin(polar) * std::cos(turn),
                                           std::sin(polar) * std::sin(turn), std::cos(polar)));
    }
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i)
    {
      const auto at = [&](int r, int c) { return std::uint32_t(r * around + c % around); };
      if (j > 0)
        mesh.triangles.emplace_back(at(j, i), at(j + 1, i), at(j, i + 1));
      if (j + 1 < rings)
        mesh.triangles.emplace_back(at(j, i + 1), at(j + 1, i), at(j + 1, i + 1));
    }
  return hasp::WeldPoints(mesh);
}

} // namespace parttest
