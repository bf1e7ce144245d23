#include "FragmentPieces.h"
#include "TransplantSegments.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double ColumnMm = 0.25;
constexpr double DeepestMm = 3.0; ///< beyond, along a column, it is not the joint
constexpr double ContactMm = 0.1; ///< bones closer than this meet
/// Of the angle between the joint's normal and a face's: the sides of bones, which joints cut at up
/// to 60 degrees off a square, are not how they meet.
constexpr double LeastCosine = 0.9;
constexpr double None = std::numeric_limits<double>::infinity();

/// What of a mesh lies around a joint, in its own frame: x along the normal, 0 in the plane.
TriangleMesh Around(const TriangleMesh& mesh, const TransplantJoint& joint, double reachMm)
{
  const glm::dvec3 x = glm::normalize(joint.normal);
  const glm::dvec3 side = std::abs(x.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 y = glm::normalize(glm::cross(side, x));
  const glm::dmat3 toFrame = glm::transpose(glm::dmat3(x, y, glm::cross(x, y)));
  TriangleMesh around;
  for (const glm::dvec3& p : mesh.points)
    around.points.push_back(toFrame * (p - joint.point));
  const auto beyond = [&](const glm::uvec3& t, int axis, double most)
  {
    const double a = around.points[t.x][axis], b = around.points[t.y][axis],
                 c = around.points[t.z][axis];
    return std::min({ a, b, c }) > most || std::max({ a, b, c }) < -most;
  };
  for (const glm::uvec3& t : mesh.triangles)
    if (!beyond(t, 0, DeepestMm) && !beyond(t, 1, reachMm) && !beyond(t, 2, reachMm))
      around.triangles.push_back(t);
  return around;
}

/// Where a column meets faces that look along it (sign +1: the last one) or against it (-1: the
/// first), within DeepestMm; infinite if nowhere.
double FaceIn(const TriangleMesh& mesh, const MeshRays& rays, double y, double z, int sign)
{
  double found = None;
  for (const std::uint32_t n : rays.Hits({ -1e3, y, z }))
  {
    const glm::uvec3& t = mesh.triangles[n];
    const glm::dvec3& a = mesh.points[t.x];
    const glm::dvec3 normal = glm::cross(mesh.points[t.y] - a, mesh.points[t.z] - a);
    if (normal.x * sign < LeastCosine * glm::length(normal))
      continue;
    const double x = a.x - (normal.y * (y - a.y) + normal.z * (z - a.z)) / normal.x;
    if (std::abs(x) <= DeepestMm && (found == None || sign * x > sign * found))
      found = x;
  }
  return found;
}
} // namespace

JointFit MeasureJoint(const TransplantJoint& joint, const TriangleMesh& before,
  const TriangleMesh& after, double reachMm)
{
  if (!(reachMm > 0.0 && reachMm <= 100.0))
  {
    std::ostringstream text;
    text << "joint: reachMm is " << reachMm << ", must be in (0, 100]";
    throw std::invalid_argument(text.str());
  }
  const TriangleMesh a = Around(before, joint, reachMm), b = Around(after, joint, reachMm);
  const MeshRays raysA(a), raysB(b);
  const int columns = int(std::ceil(reachMm / ColumnMm));
  constexpr double Area = ColumnMm * ColumnMm;
  JointFit fit;
  for (int j = -columns; j < columns; ++j)
    for (int i = -columns; i < columns; ++i)
    {
      // Off the middle by a little: columns through edges of triangles would count twice.
      const double y = (i + 0.5) * ColumnMm + 3.1e-7, z = (j + 0.5) * ColumnMm + 1.7e-7;
      const double end = FaceIn(a, raysA, y, z, 1), begin = FaceIn(b, raysB, y, z, -1);
      if (end == None && begin == None)
        continue;
      if (end == None || begin == None)
      {
        fit.stepMm2 += Area;
        continue;
      }
      const double gap = begin - end;
      if (std::abs(gap) <= ContactMm)
        fit.contactMm2 += Area;
      else
      {
        (gap > 0.0 ? fit.gapMm2 : fit.overlapMm2) += Area;
        (gap > 0.0 ? fit.gapMm3 : fit.overlapMm3) += Area * std::abs(gap);
      }
    }
  return fit;
}

} // namespace hasp
