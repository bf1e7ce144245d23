#include "Haptics/PointProxy.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace hasp
{
namespace
{

constexpr double Parallel = 1e-9; // of a Gram matrix of unit normals: its determinant

/// x = goal + sum of lambda n for the planes of `subset`, all touched. False if they are parallel,
/// or if one would have to pull.
bool OnPlanes(const glm::dvec3& goal, const glm::dvec3* at, const glm::dvec3* normals, int planes,
  int subset, glm::dvec3& x) noexcept
{
  int chosen[3], count = 0;
  for (int i = 0; i < planes; ++i)
    if (subset & (1 << i))
      chosen[count++] = i;
  glm::dmat3 gram(1.0);
  glm::dvec3 below(0.0);
  for (int i = 0; i < count; ++i)
  {
    below[i] = glm::dot(at[chosen[i]] - goal, normals[chosen[i]]);
    for (int j = 0; j < count; ++j)
      gram[i][j] = glm::dot(normals[chosen[i]], normals[chosen[j]]);
  }
  if (!(std::abs(glm::determinant(gram)) > Parallel))
    return false;
  const glm::dvec3 lambda = glm::inverse(gram) * below;
  x = goal;
  for (int i = 0; i < count; ++i)
  {
    if (lambda[i] < 0.0)
      return false;
    x += lambda[i] * normals[chosen[i]];
  }
  return true;
}

} // namespace

glm::dvec3 NearestAbove(
  const glm::dvec3& goal, const glm::dvec3* at, const glm::dvec3* normals, int planes) noexcept
{
  glm::dvec3 best = goal;
  double nearest = std::numeric_limits<double>::infinity();
  for (int subset = 0; subset < (1 << planes); ++subset)
  {
    glm::dvec3 x;
    if (!OnPlanes(goal, at, normals, planes, subset, x))
      continue;
    bool above = true;
    const double slack = 1e-9 * (1.0 + glm::length(x - goal)); // rounding of what lies on a plane
    for (int i = 0; i < planes; ++i)
      above = above && glm::dot(x - at[i], normals[i]) >= -slack;
    const double way = glm::length(x - goal);
    if (above && way < nearest)
    {
      nearest = way;
      best = x;
    }
  }
  return best;
}

} // namespace hasp
