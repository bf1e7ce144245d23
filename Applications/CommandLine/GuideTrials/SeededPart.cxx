#include "SeededPart.h"

#include "SeededDraw.h"

#include "Distance/Csg.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidShapes.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double SpacingMm = 0.5; // of the grid that parts are contoured on

/// What a seed draws, in its own axes: the bone's top at 0, the part lifts off along z.
struct Scene
{
  explicit Scene(Draw& draw)
    : turn(glm::rotate(glm::dmat4(1.0), draw.From(0.0, 3.0), draw.Direction())),
      to(draw.From(-80, 80), draw.From(-80, 80), draw.From(-80, 80)),
      half(draw.From(9.0, 12.0), draw.From(7.0, 9.0), 20.0),
      gapMm(draw.From(0.2, 0.5)),
      thicknessMm(draw.From(2.0, 3.5))
  {
    const double radius = draw.From(25.0, 45.0);
    std::vector<SolidPointer> balls{ this->Ball({ 0.0, 0.0, -radius }, radius) };
    for (int n = 0; n < 3; ++n) // bumps of up to 1.2 mm
    {
      const glm::dvec3 at(draw.From(-8, 8), draw.From(-6, 6), 0.0);
      const double r = draw.From(8.0, 15.0), height = draw.From(0.4, 1.2);
      const glm::dvec3 up = glm::normalize(at + glm::dvec3(0, 0, radius));
      balls.push_back(this->Ball(glm::dvec3(0, 0, -radius) + (radius - r + height) * up, r));
    }
    this->bone = MakeUnion(balls);
  }
  glm::dvec3 Place(const glm::dvec3& p) const { return this->to + this->turn * p; }
  SolidPointer Ball(const glm::dvec3& at, double radius) const
  {
    return MakeCapsule(this->Place(at), this->Place(at), radius);
  }
  /// Straight above or below a place, on the bone.
  glm::dvec3 OnBone(double x, double y) const
  {
    double z = 10.0; // distances do not overshoot
    for (int n = 0; n < 200; ++n)
      z -= this->bone->At(this->Place({ x, y, z }));
    return { x, y, z };
  }

  glm::dmat3 turn;
  glm::dvec3 to, half;
  double gapMm, thicknessMm;
  SolidPointer bone;
};

PartClaims ClaimsOf(const Scene& scene, Draw& draw)
{
  PartClaims claims;
  claims.withdrawal = scene.turn[2];
  ClaimedShell shell;
  shell.gapMm = scene.gapMm;
  shell.thicknessMm = scene.thicknessMm;
  shell.thicknessToleranceMm = 0.4 * SpacingMm; // what SharpContour says of corners
  claims.shell = shell;
  const double turn = draw.From(-0.3, 0.3), tilt = draw.From(-0.17, 0.17);
  const glm::dvec3 along(-std::sin(turn), std::cos(turn), 0.0);
  const glm::dvec3 flat(std::cos(turn), std::sin(turn), 0.0);
  const glm::dvec3 normal = std::cos(tilt) * flat + std::sin(tilt) * glm::dvec3(0, 0, 1);
  claims.slots = { { scene.Place(scene.OnBone(-0.45 * scene.half.x, 0.0)), scene.turn * normal,
    scene.turn * along, draw.From(1.0, 1.8), draw.From(6.0, 8.0) } };
  for (const double y : { 0.45, -0.2 })
  {
    const glm::dvec3 axis =
      glm::normalize(glm::dvec3(draw.From(-0.14, 0.14), draw.From(-0.14, 0.14), 1.0));
    const double x = draw.From(0.35, 0.5);
    claims.holes.push_back({ scene.Place(scene.OnBone(x * scene.half.x, y * scene.half.y)),
      scene.turn * axis, draw.From(1.5, 2.8) });
  }
  return claims;
}

/// The part as a solid, as its claims say; with defects of its shape.
SolidPointer MakeSolid(const Scene& scene, PartClaims claims, SeededDefect defect, Draw& draw)
{
  double gap = scene.gapMm;
  if (defect == SeededDefect::WrongGap)
    gap += draw.From(0.6, 1.0) * (draw.Below(2) == 0 ? 1.0 : -1.0);
  if (defect == SeededDefect::NarrowSlot)
    claims.slots[0].widthMm -= draw.From(0.3, 0.6);
  if (defect == SeededDefect::SmallHole)
    claims.holes[draw.Below(2)].diameterMm -= draw.From(0.3, 0.6);
  std::vector<SolidPointer> tools;
  for (const ClaimedSlot& s : claims.slots)
    tools.push_back(MakeBox(s.point, { s.normal, s.along, glm::cross(s.normal, s.along) },
      { 0.5 * s.widthMm, 0.5 * s.lengthMm, 30.0 }));
  for (const ClaimedHole& h : claims.holes)
    tools.push_back(
      MakeCylinder(h.point - 30.0 * h.axis, h.point + 30.0 * h.axis, 0.5 * h.diameterMm));
  if (defect == SeededDefect::ThinWall)
  {
    // A round dent from outside, clear of slot, holes and rim.
    const glm::dvec3 at =
      scene.Place(scene.OnBone(draw.From(-0.5, 0.5), draw.From(-0.4, -0.25) * scene.half.y));
    const glm::dvec3 out = scene.bone->SampleAt(at).gradient;
    const double r = draw.From(1.5, 2.5), left = draw.From(0.25, 0.6) * scene.thicknessMm;
    const glm::dvec3 center = at + (gap + left + r) * out;
    tools.push_back(MakeCapsule(center, center + 10.0 * out, r));
  }
  const SolidPointer shell = MakeIntersection({ MakeShell(scene.bone, gap, gap + scene.thicknessMm),
    MakeBox(scene.to, scene.turn, scene.half) });
  const SolidPointer part = MakeDifference(shell, MakeUnion(tools));
  if (defect != SeededDefect::LoosePiece)
    return part;
  const double r = draw.From(0.8, 2.0);
  return MakeUnion({ part, scene.Ball({ draw.From(-6, 6), draw.From(-6, 6),
                                        gap + scene.thicknessMm + 1.2 + r + draw.From(1.0, 3.0) },
                             r) });
}

TriangleMesh Contour(const ImplicitSolid& solid, const Scene& scene)
{
  const double reach = glm::length(glm::dvec2(scene.half)) + 8.0;
  GridGeometry grid;
  grid.dims = glm::ivec3(int(2.0 * reach / SpacingMm) + 1);
  grid.spacing = glm::dvec3(SpacingMm);
  // Its axes are the world's; off the planes of the part by what no plane shares with it.
  grid.origin = scene.to - 0.5 * SpacingMm * glm::dvec3(grid.dims - 1) + 0.0137;
  return SharpContour(solid, grid);
}

void SpoilMesh(TriangleMesh& mesh, const Scene& scene, SeededDefect defect, Draw& draw)
{
  const std::size_t n = draw.Below(mesh.triangles.size());
  if (defect == SeededDefect::MeshHole)
    mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(n));
  if (defect == SeededDefect::FlippedTriangle)
    std::swap(mesh.triangles[n].y, mesh.triangles[n].z);
  if (defect == SeededDefect::SelfIntersection)
  {
    // A point of the outer wall pulled through the inner one.
    glm::dvec3& p = *std::max_element(mesh.points.begin(), mesh.points.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::dot(a, scene.turn[2]) < glm::dot(b, scene.turn[2]); });
    p -= (scene.thicknessMm + draw.From(0.1, 1.5)) * scene.turn[2];
  }
  if (defect == SeededDefect::InchForMm)
    for (glm::dvec3& p : mesh.points)
      p /= 25.4;
  if (defect == SeededDefect::Mirrored)
  {
    const auto axis = static_cast<int>(draw.Below(3));
    const double about = draw.Below(2) == 0 ? 0.0
                                            : [&]
    {
      const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
        [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
      return (*low)[axis] + (*high)[axis];
    }();
    for (glm::dvec3& p : mesh.points)
      p[axis] = about - p[axis];
    for (glm::uvec3& t : mesh.triangles)
      std::swap(t.y, t.z);
  }
}

/// A scan of the bone, in axes and of a spacing of its own.
void Scan(const Scene& scene, Draw& draw, SeededPart& part)
{
  part.scan.spacing = { draw.From(0.5, 0.8), 0.0, draw.From(0.5, 1.0) };
  part.scan.spacing.y = part.scan.spacing.x;
  part.scan.direction =
    glm::dmat3(glm::rotate(glm::dmat4(1.0), draw.From(0.0, 0.4), draw.Direction()));
  const double half = glm::length(glm::dvec2(scene.half)) + 6.0;
  part.scan.dims = glm::ivec3(glm::ceil(2.0 * half / part.scan.spacing)) + 1;
  part.scan.origin =
    scene.to - part.scan.direction * (0.5 * part.scan.spacing * glm::dvec3(part.scan.dims - 1));
  part.grey.resize(part.scan.Size());
  ParallelFor(0, part.scan.dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (int k = int(first); k < int(last); ++k)
        for (int j = 0; j < part.scan.dims.y; ++j)
          for (int i = 0; i < part.scan.dims.x; ++i)
          {
            const double mm = scene.bone->At(part.scan.IndexToWorld({ i, j, k }));
            part.grey[(std::size_t(k) * part.scan.dims.y + j) * part.scan.dims.x + i] =
              std::int16_t(std::lround(std::clamp(226.0 - 300.0 * mm, -1000.0, 1800.0)));
          }
    });
}

} // namespace

const char* SeededDefectName(SeededDefect defect)
{
  constexpr const char* names[] = { "none", "hole in the mesh", "flipped triangle",
    "self-intersection", "thin wall", "wrong gap", "narrow slot", "small hole", "mirrored",
    "inch for mm", "loose piece" };
  return names[static_cast<int>(defect)];
}

SeededPart MakeSeededPart(std::uint32_t seed, SeededDefect defect)
{
  Draw draw(seed);
  const Scene scene(draw);
  SeededPart part;
  part.claims = ClaimsOf(scene, draw);
  Scan(scene, draw, part);
  part.mesh = Contour(*MakeSolid(scene, part.claims, defect, draw), scene);
  SpoilMesh(part.mesh, scene, defect, draw);
  for (glm::dvec3& p : part.mesh.points)
    p = glm::dvec3(glm::vec3(p));
  part.mesh = WeldPoints(part.mesh);
  return part;
}

} // namespace hasp
