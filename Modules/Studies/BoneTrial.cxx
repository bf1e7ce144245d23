#include "Studies/BoneTrial.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double FaceMm = 1.5;      // faces that meet are no farther apart
constexpr double FaceFacing = 0.6;  // and look at each other
constexpr double SeenShare = 0.5;   // of its faces, or it is not in its place
constexpr double LeastAgreed = 0.4; // length of faces' mean normal from which on it is a way in

/// Of a piece where it belongs, with what stands of its partners, where that belongs.
struct Faces
{
  double mm2 = 0.0;
  glm::dvec3 outward{ 0.0 }; ///< mean, world
  glm::dvec3 middle{ 0.0 };  ///< body axes; without faces the body's own
};

Faces FacesOf(const ReductionCase& broken, std::size_t body, const StandingBodies& standing)
{
  const FitBody& piece = *broken.bodies[body].body;
  const RigidPose& truth = broken.trueBodyInWorld[body];
  const auto points = piece.Points(4096);
  std::size_t count = 0;
  Faces faces;
  for (const std::size_t partner : broken.partners[body])
  {
    if (!standing[partner])
      continue;
    const RigidPose toPartner = broken.trueBodyInWorld[partner].Inverse() * truth;
    for (const OrientedPoint& p : points)
    {
      const auto foot = broken.bodies[partner].body->FootOf(toPartner.Place(p.place));
      if (!foot || std::abs(foot->mm) > FaceMm ||
          glm::dot(foot->outward, toPartner.Turn(p.normal)) > -FaceFacing)
        continue;
      faces.outward += truth.Turn(p.normal);
      faces.middle += p.place;
      ++count;
    }
  }
  faces.mm2 = piece.SurfaceArea() * double(count) / double(points.size());
  if (count > 0)
    faces.outward /= double(count);
  faces.middle = count > 0 ? faces.middle / double(count) : piece.Centroid();
  return faces;
}

glm::dvec3 WayIn(const ReductionCase& broken, std::size_t body, const glm::dvec3& outward)
{
  if (glm::length(outward) >= LeastAgreed)
    return glm::normalize(outward);
  const glm::dvec3& middle = broken.bodies[body].body->Centroid();
  const RigidPose scanned{ broken.bodies[body].origin };
  const glm::dvec3 back = broken.trueBodyInWorld[body].Place(middle) - scanned.Place(middle);
  return glm::length(back) > 0.0 ? glm::normalize(back) : glm::dvec3(0.0, 0.0, -1.0);
}

StandingBodies FixedBodies(const ReductionCase& broken)
{
  StandingBodies standing(broken.bodies.size());
  for (std::size_t n = 0; n < standing.size(); ++n)
    if (broken.fixed[n])
      standing[n] = broken.trueBodyInWorld[n];
  return standing;
}

} // namespace

OperatorTask TaskOf(const ReductionCase& broken, std::size_t body, const StandingBodies& standing)
{
  if (body >= broken.bodies.size() || standing.size() != broken.bodies.size() || standing[body])
    throw std::invalid_argument("bone trial: body " + std::to_string(body) +
                                " must be one of the bone's " +
                                std::to_string(broken.bodies.size()) + " and not stand");
  OperatorTask task;
  const BakedFitBody& moved = broken.bodies[body];
  std::vector<HapticBody> touched;
  for (const std::size_t n : broken.partners[body])
    if (standing[n])
    {
      touched.push_back({ broken.bodies[n].map, *standing[n] });
      task.others.partners.push_back({ broken.bodies[n].body, *standing[n] });
    }
  const Faces faces = FacesOf(broken, body, standing);
  const RigidPose bodyInGroup{ -faces.middle };
  task.touch = [shell = moved.shell, bodyInGroup, touched]
  {
    return std::make_unique<HapticScene>(
      std::vector<HapticShell>{ { shell, bodyInGroup } }, touched);
  };
  task.moved = { { moved.body, bodyInGroup } };
  task.truth = broken.trueBodyInWorld[body] * bodyInGroup.Inverse();
  task.push = WayIn(broken, body, faces.outward);
  task.leastSeen = std::min(task.leastSeen, SeenShare * faces.mm2 / moved.body->SurfaceArea());
  return task;
}

std::vector<std::size_t> OrderOfPieces(const ReductionCase& broken)
{
  StandingBodies standing = FixedBodies(broken);
  std::vector<std::size_t> order;
  while (true)
  {
    std::optional<std::size_t> next;
    double largest = -1.0;
    for (std::size_t n = 0; n < standing.size(); ++n)
      if (!standing[n])
        if (const double mm2 = FacesOf(broken, n, standing).mm2; mm2 > largest)
        {
          largest = mm2;
          next = n;
        }
    if (!next)
      return order;
    order.push_back(*next);
    standing[*next] = broken.trueBodyInWorld[*next];
  }
}

BoneTrial PutBoneTogether(const ReductionCase& broken, const OperatorSettings& who,
  const OperatorHelp& help, std::uint64_t seed, std::size_t most)
{
  if (most < 1)
    throw std::invalid_argument("bone trial: most is 0, must be 1 or more");
  BoneTrial trial;
  trial.pieces = OrderOfPieces(broken);
  trial.pieces.resize(std::min(trial.pieces.size(), most));
  StandingBodies standing = FixedBodies(broken);
  for (const std::size_t piece : trial.pieces)
  {
    const OperatorTask task = TaskOf(broken, piece, standing);
    const std::uint64_t own = 100 * seed + piece;
    const OperatorResult put = PutInPlace(task, StartBefore(task, own), who, help, own);
    const RigidPose placed = put.pose * task.moved.front().bodyInGroup;
    standing[piece] = placed;
    trial.bodyInWorld.push_back(placed);
    trial.seconds += put.seconds;
    trial.content += put.content;
    trial.faults += put.overLimit + put.notFinite;
  }
  return trial;
}

} // namespace hasp
