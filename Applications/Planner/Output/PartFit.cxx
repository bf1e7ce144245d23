#include "Output/PartFit.h"

#include "BoneAround.h"
#include "Failure.h"
#include "InnerWall.h"
#include "Output/PartWork.h"
#include "VerbWork.h"
#include "View/BlobFile.h"
#include "vtkHaspVolumeView.h"

#include "Distance/BodyDistance.h"
#include "Evaluation/MeshSamples.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"
#include "Planning/PlanLists.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{
namespace
{

constexpr double AroundMm = 10.0; // of bone beside the part and its way: what a hand goes astray
constexpr double PointMm = 0.5;   // between points: 0.006 mm too late on bone of 5 mm radius
constexpr double MapMm = 0.5;
constexpr double PressMm = 3.0; // as SeatSettings'
constexpr int MostPoints = 1 << 18;

/// Where the part lifts off: as it claims, or away from the bone that its inner wall faces.
glm::dvec3 WayOff(const RebuiltPart& part, const std::string& called)
{
  const PartClaims& claims = part.check->claims;
  if (claims.withdrawal)
    return glm::normalize(*claims.withdrawal);
  glm::dvec3 away(0.0);
  if (claims.shell)
    away = FindInnerWall(part.mesh, part.check->bone, claims).away;
  if (!(glm::length(away) > 0.0))
    throw Failure(ExitCode::BadInput,
      called + ": it is not known which way it lifts off; give it a withdrawal");
  return glm::normalize(away);
}

/// The part's triangles, halved until they are PointMm apart, and their corners.
std::vector<SurfacePoint> PointsOf(const TriangleMesh& mesh)
{
  std::vector<SurfacePoint> points;
  std::vector<bool> taken(mesh.points.size());
  for (const MeshSample& sample : SampleMesh(mesh, PointMm))
  {
    points.push_back({ sample.point, sample.normal });
    const glm::uvec3& triangle = mesh.triangles[sample.triangle];
    for (int corner = 0; corner < 3; ++corner)
      if (const glm::uint point = triangle[corner]; !taken[point])
      {
        taken[point] = true;
        points.push_back({ mesh.points[point], sample.normal });
      }
  }
  return points;
}

} // namespace

std::shared_ptr<const PartOnBone> MakePartOnBone(
  PartWork& work, PlanId object, const ProgressFunction& progress)
{
  const std::string called = CalledObject(work.Now(), object);
  const RebuiltPart part = work.Rebuild(object, progress);
  if (!part.check)
    throw Failure(
      ExitCode::BadInput, called + ": it is put on no bone, so that nothing can be tried");
  const PartClaims& claims = part.check->claims;
  PartOnBone body;
  body.object = object;
  body.called = called;
  body.part = WithNormals(MakePolyData(part.mesh), true); // as one: haptics takes closed meshes
  body.isovalue = claims.isovalue;
  body.withdrawal = WayOff(part, called);
  glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
  for (const glm::dvec3& point : part.mesh.points)
    for (const glm::dvec3& at : { point, point + PartOnBone::LiftMm * body.withdrawal })
    {
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
  body.bone = BoneAround(part.check->bone, claims, low, high, AroundMm);
  if (!body.bone)
    throw Failure(ExitCode::BadInput, called + ": it lies beside its scan");
  return std::make_shared<const PartOnBone>(std::move(body));
}

PartSeat SeatPart(const PartOnBone& body, const ProgressFunction& progress)
{
  const AnyGridView bone = ViewImage(body.bone);
  const auto sharing = [&](double from, double to) -> ProgressFunction
  {
    return [&progress, from, to](double share)
    { return !progress || progress(from + share * (to - from)); };
  };
  BodyDistanceSettings sampled;
  const glm::dvec3 spacing = GeometryOf(bone).spacing;
  sampled.spacingMm = std::min({ MapMm, spacing.x, spacing.y, spacing.z });
  const BodyDistance distance = DistanceOfVolume(bone, body.isovalue, sampled, sharing(0.0, 0.7));
  const auto map =
    std::make_shared<const DistanceMap>(distance.View(), DistanceMapSettings{}, sharing(0.7, 0.8));
  const TriangleMesh mesh = MakeTriangleMesh(body.part);
  std::vector<SurfacePoint> points = PointsOf(mesh);
  const auto shell = PointShell::OfPoints(points, 1.0, glm::dvec3(0.0),
    { .points = int(std::min<std::size_t>(points.size(), MostPoints)) });
  SeatSettings settings;
  settings.withdrawal = body.withdrawal;
  settings.liftMm = PartOnBone::LiftMm;
  settings.pressMm = PressMm;
  const HapticBody bones[] = { { map, {} } };
  return { SeatByContact(*shell, {}, bones, settings, sharing(0.9, 1.0)), PointMm };
}

} // namespace hasp
