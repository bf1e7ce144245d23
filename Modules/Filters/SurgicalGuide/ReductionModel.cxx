#include "ReductionModel.h"

#include "FragmentPieces.h"
#include "Grid/ProgressPart.h"
#include "PosedBone.h"

#include "Distance/BodyDistance.h"
#include "Distance/GridSolid.h"
#include "Distance/SharpContour.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double MostSpacingMm = 5.0;
constexpr std::size_t MostSamples = 200'000'000;
constexpr double BandSteps = 3.0; // of air around all

[[noreturn]] void Refuse(std::size_t n, const std::string& what)
{
  throw std::invalid_argument("fragments[" + std::to_string(n) + "] " + what);
}

void CheckPose(const RigidPose& pose)
{
  const glm::dquat& q = pose.orientation;
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(std::abs(length - 1.0) <= 1e-3) || !std::isfinite(glm::length(pose.position)))
    throw std::invalid_argument("has a pose that is none: its orientation has the length " +
                                std::to_string(length) + ", must be 1");
}

/// Throws what the header says of fragment n.
TriangleMesh Checked(const PosedMesh& fragment, std::size_t n)
{
  if (!fragment.mesh || fragment.mesh->triangles.empty())
    Refuse(n, "has no triangles");
  for (const glm::uvec3& t : fragment.mesh->triangles)
    if (std::max({ t.x, t.y, t.z }) >= fragment.mesh->points.size())
      Refuse(n, "has a triangle that names a point that is not there");
  TriangleMesh placed;
  try
  {
    placed = PlacedMesh(fragment);
  }
  catch (const std::invalid_argument& error)
  {
    Refuse(n, error.what());
  }
  if (!(VolumeOf(placed) > 0.0))
    Refuse(n, "encloses no volume, or is inside out");
  return placed;
}

void Append(TriangleMesh& all, const TriangleMesh& mesh)
{
  const auto first = static_cast<glm::uint>(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  for (const glm::uvec3& t : mesh.triangles)
    all.triangles.push_back(t + first);
}

} // namespace

TriangleMesh PlacedMesh(const PosedMesh& fragment)
{
  CheckPose(fragment.pose);
  RigidPose pose = fragment.pose;
  pose.orientation = glm::normalize(pose.orientation);
  TriangleMesh placed = *fragment.mesh;
  for (glm::dvec3& point : placed.points)
    point = glm::dvec3(glm::vec3(pose.Place(point)));
  return placed;
}

TriangleMesh UniteFragments(
  std::span<const PosedMesh> fragments, double spacingMm, const ProgressFunction& progress)
{
  if (!(spacingMm > 0.0 && spacingMm <= MostSpacingMm))
  {
    std::ostringstream text;
    text << "spacingMm is " << spacingMm << ", must be in (0, " << MostSpacingMm << "]";
    throw std::invalid_argument(text.str());
  }
  if (fragments.empty())
    throw std::invalid_argument("there are no fragments to be united");
  TriangleMesh all;
  for (std::size_t n = 0; n < fragments.size(); ++n)
    Append(all, Checked(fragments[n], n));
  BodyDistance body = DistanceOfMesh(
    all, { spacingMm, BandSteps * spacingMm, MostSamples }, PartOf(progress, 0.0, 0.7));
  const SolidPointer solid = MakeGridSolid(
    std::make_shared<const std::vector<float>>(std::move(body.distances)), body.geometry);
  TriangleMesh united =
    SharpContour(*solid, body.geometry, {}, nullptr, PartOf(progress, 0.7, 1.0));
  if (united.triangles.empty())
    throw std::runtime_error("nothing of the fragments is as thick as spacingMm; lower it");
  return united;
}

} // namespace hasp
