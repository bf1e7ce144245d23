#pragma once
#include "Haptics/ContactForce.h"
#include "Testing/BakedMap.h"
#include "Testing/ShellOfPoints.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdint>

namespace hasp
{

/// Turned, bottom up in its slices' order, and with three spacings: what scanners deliver.
inline GridGeometry OddGrid(int samples)
{
  GridGeometry grid;
  grid.dims = { samples, samples - 3, samples - 9 };
  grid.spacing = { 0.7, 0.9, 1.1 };
  grid.direction = glm::mat3_cast(TurnBy({ 0.3, -0.5, 0.4 }));
  grid.direction[2] = -grid.direction[2];
  grid.origin = -(grid.direction * (grid.spacing * glm::dvec3(grid.dims - 1) * 0.5));
  return grid;
}

/// n points on a ball, each for the same area: z evenly spaced, turned by the golden angle.
inline void AddBall(
  ShellOfPoints& shell, int n, double radius, const glm::dvec3& center = glm::dvec3(0.0))
{
  const double golden = glm::pi<double>() * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / n, across = std::sqrt(1.0 - z * z);
    const glm::dvec3 normal(across * std::cos(golden * i), across * std::sin(golden * i), z);
    shell.Add(center + radius * normal, normal);
  }
}

/// About the signed distance to a ball with dents and bumps: |gradient| within a few percent of 1.
inline double BumpyBall(const glm::dvec3& p, double radius, double bump)
{
  const double r = glm::length(p);
  if (r < 1e-9)
    return -radius;
  const glm::dvec3 n = p / r;
  return r - radius - bump * std::sin(5.0 * n.x) * std::sin(6.0 * n.y + 1.0) * std::cos(4.0 * n.z);
}

/// Deterministic, in [0, 1).
class Dice
{
public:
  explicit Dice(std::uint32_t seed) : State(seed) {}
  double operator()()
  {
    this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }
  glm::dvec3 InBox(double half)
  {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return half * (2.0 * glm::dvec3(x, y, z) - 1.0);
  }

private:
  std::uint64_t State;
};

} // namespace hasp
