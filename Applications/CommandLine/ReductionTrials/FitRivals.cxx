#include "FitRivals.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{
constexpr double LastReachMm = 1.0;
constexpr double StepMm = 1.0;
constexpr double PushMm3 = 15.0; // against contact's area times depth: 0.1 mm deep on 150 mm2

struct Equations
{
  Symmetric6 matrix{};
  Vector6 pull{};
  int pairs = 0;

  void Add(const glm::dvec3& arm, const glm::dvec3& direction, double mm)
  {
    const glm::dvec3 turn = glm::cross(arm, direction);
    const Vector6 j{ direction.x, direction.y, direction.z, turn.x, turn.y, turn.z };
    std::size_t entry = 0;
    for (std::size_t row = 0; row < 6; ++row)
    {
      this->pull[row] -= mm * j[row];
      for (std::size_t column = row; column < 6; ++column)
        this->matrix[entry++] += j[row] * j[column];
    }
    ++this->pairs;
  }
};

double RadiusOf(std::span<const GroupBody> moved)
{
  double radius = 0.0;
  for (const GroupBody& body : moved)
    radius = std::max(radius, glm::length(body.bodyInGroup.position) + body.body->RadiusMm());
  return radius;
}

/// One damped step, at most StepMm at the farthest point; how far, mm. Negative: none.
double Step(Symmetric6 matrix, const Vector6& pull, double radius, RigidPose& pose)
{
  const double mean =
    (matrix[UpperIndex(0, 0)] + matrix[UpperIndex(1, 1)] + matrix[UpperIndex(2, 2)]) / 3.0;
  if (!(mean > 0.0))
    return -1.0;
  for (std::size_t k = 0; k < 6; ++k)
    matrix[UpperIndex(k, k)] += 1e-4 * mean * (k < 3 ? 1.0 : 0.3 * radius * radius);
  Vector6 x;
  if (!Solve6(matrix, pull, radius, x))
    return -1.0;
  glm::dvec3 shift(x[0], x[1], x[2]), turn(x[3], x[4], x[5]);
  const double mm = glm::length(shift) + radius * glm::length(turn);
  const double share = mm > StepMm ? StepMm / mm : 1.0;
  pose.position += share * shift;
  pose.orientation = glm::normalize(TurnBy(share * turn) * pose.orientation);
  return share * mm;
}

/// visit(place in the world, foot, outward in the world, cosine of facing) for each moved point.
template <typename Visit>
void ForFeet(std::span<const GroupBody> moved, const RigidPose& pose, const FitScene& scene,
  std::size_t points, const Visit& visit)
{
  for (const GroupBody& body : moved)
  {
    const RigidPose placed = pose * body.bodyInGroup;
    for (const PlacedBody& other : scene.partners)
    {
      const RigidPose toOther = other.bodyInWorld.Inverse() * placed;
      for (const OrientedPoint& p : body.body->Points(points))
        if (const auto foot = other.body->FootOf(toOther.Place(p.place)))
          visit(placed.Place(p.place), *foot, other.bodyInWorld.Turn(foot->outward),
            -glm::dot(toOther.Turn(p.normal), foot->outward));
    }
  }
}
} // namespace

RigidPose FitByIcp(std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene,
  const IcpSettings& settings)
{
  const double radius = RadiusOf(moved);
  RigidPose pose = start;
  double reach = settings.reachMm;
  for (int n = 0; n < settings.steps; ++n)
  {
    Equations equations;
    ForFeet(moved, pose, scene, settings.points,
      [&](const glm::dvec3& place, const FitBody::Foot& foot, const glm::dvec3& outward,
        double facing)
      {
        if (std::abs(foot.mm) <= reach && facing > settings.leastFacing)
          equations.Add(place - pose.position, outward, foot.mm);
      });
    if (equations.pairs < 6)
      break;
    const double mm = Step(equations.matrix, equations.pull, radius, pose);
    if (mm < 0.0 || (mm < 2e-4 && reach <= LastReachMm))
      break;
    if (n % 10 == 9)
      reach = std::max(LastReachMm, 0.75 * reach);
  }
  return pose;
}

std::string IcpWords()
{
  return "point-to-plane ICP (Chen and Medioni 1992), nearest places by the same distances, "
         "normals "
         "that look at each other, reach 5 to 1 mm, 60 steps";
}

RigidPose FitByContact(
  std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene)
{
  const double radius = RadiusOf(moved);
  glm::dvec3 towards(0.0);
  ForFeet(moved, start, scene, 2048,
    [&](const glm::dvec3&, const FitBody::Foot& foot, const glm::dvec3& outward, double facing)
    {
      if (foot.mm > -1.0 && facing > 0.5)
        towards -= outward;
    });
  if (glm::length(towards) > 0.0)
    towards = glm::normalize(towards);
  FitLaw law;
  law.attraction = 1e-9;
  law.captureMm = 1e-3;
  law.continuity = 0.0;
  law.penetrationMm = 20.0;
  RigidPose pose = start;
  for (int n = 0; n < 200; ++n)
  {
    std::vector<PlacedBody> placed;
    for (const GroupBody& body : moved)
      placed.push_back({ body.body, pose * body.bodyInGroup });
    FitSums sums = SumFit(placed, pose.position, scene, law, 8192);
    for (int k = 0; k < 3; ++k)
      sums.pull[k] += PushMm3 * towards[k];
    // Of contact that is not there yet: the way is walked in steps of a quarter of a millimetre.
    for (std::size_t k = 0; k < 6; ++k)
      sums.matrix[UpperIndex(k, k)] += 4.0 * PushMm3 * (k < 3 ? 1.0 : 0.3 * radius * radius);
    const double mm = Step(sums.matrix, sums.pull, radius, pose);
    if (mm < 0.0 || mm < 2e-4)
      break;
  }
  return pose;
}

std::string ContactWords()
{
  return "contact alone under a constant push towards the faces that were nearest at the start";
}

} // namespace hasp
