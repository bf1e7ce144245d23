// Implants for the phantom's hole, against the bone that is missing there.
#include "Distance/ImplicitSolid.h"
#include "Evaluation/MeshSamples.h"
#include "ImplantFixture.h"

#include <algorithm>

using namespace implanttest;

namespace
{

const Scan& Head()
{
  static const Scan scan(0.75);
  return scan;
}

const hasp::BuiltImplant& Implant()
{
  static const hasp::BuiltImplant implant =
    hasp::BuildImplant(Head().View(), AroundTheHole(Head()));
  return implant;
}

/// Distance to the hole's wall, seen along its axis, positive inside: it is a rounded rectangle.
double ToWall(const glm::dvec3& p)
{
  const hasp::PhantomDefect hole = Head().Hole();
  constexpr double roundMm = 6.0;
  const glm::dvec2 at(std::abs(glm::dot(p - hole.center, hole.along)),
    std::abs(glm::dot(p - hole.center, hole.across)));
  const glm::dvec2 q = at - glm::dvec2(0.5 * hole.lengthMm, 0.5 * hole.widthMm) + roundMm;
  return roundMm - glm::length(glm::max(q, glm::dvec2(0.0))) - std::min(std::max(q.x, q.y), 0.0);
}

/// Places of the mesh by where they must be, whichever way they look: outer and inner face but for
/// 0.3 mm at the wall, the edge but for 0.5 mm at its ends.
enum class Face
{
  Outer,
  Edge,
  Inner
};
std::vector<hasp::MeshSample> SamplesOf(const hasp::BuiltImplant& implant, Face face)
{
  const hasp::AnalyticSolid outer = Head().Outer();
  const hasp::ImplantRecipe recipe = AroundTheHole(Head());
  std::vector<hasp::MeshSample> samples = hasp::SampleMesh(implant.mesh, 0.5);
  std::erase_if(samples,
    [&](const hasp::MeshSample& s)
    {
      const double depth = -outer.Distance(s.point).mm, t = recipe.thicknessMm;
      if (face == Face::Edge)
        return depth < 0.5 || depth > t - 0.5;
      return ToWall(s.point) < recipe.clearanceMm + 0.3 ||
             (face == Face::Outer) != (depth < 0.5 * t);
    });
  return samples;
}

/// Share of the area whose value is within a bound of what it should be.
double ShareWithin(
  const std::vector<hasp::MeshSample>& samples, const std::vector<double>& values, double bound)
{
  double within = 0.0, all = 0.0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    all += samples[n].areaMm2;
    within += std::abs(values[n]) <= bound ? samples[n].areaMm2 : 0.0;
  }
  return within / all;
}

double Most(const std::vector<double>& values)
{
  double most = 0.0;
  for (const double v : values)
    most = std::max(most, std::abs(v));
  return most;
}

TEST(ImplantBuilder, IsOneClosedPiece)
{
  const auto check = hasp::CheckMesh(Implant().mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
}

TEST(ImplantBuilder, TheOuterFaceGoesOnWhereTheOuterTableEnds)
{
  const hasp::AnalyticSolid outer = Head().Outer();
  const auto samples = SamplesOf(Implant(), Face::Outer);
  std::vector<double> steps;
  double squares = 0.0;
  for (const auto& s : samples)
  {
    steps.push_back(outer.Distance(s.point).mm);
    squares += steps.back() * steps.back() / double(samples.size());
  }
  RecordProperty("rmsMm", std::to_string(std::sqrt(squares)));
  RecordProperty("mostMm", std::to_string(Most(steps)));
  EXPECT_GT(samples.size(), 2000U);
  EXPECT_LT(std::sqrt(squares), 0.1);
  EXPECT_LT(Most(steps), 0.5);
}

TEST(ImplantBuilder, TheInnerFaceIsAThicknessBelow)
{
  const hasp::AnalyticSolid outer = Head().Outer();
  const auto samples = SamplesOf(Implant(), Face::Inner);
  std::vector<double> off;
  for (const auto& s : samples)
    off.push_back(outer.Distance(s.point).mm + AroundTheHole(Head()).thicknessMm);
  EXPECT_GT(samples.size(), 2000U);
  EXPECT_GT(ShareWithin(samples, off, 0.1), 0.95);
  EXPECT_LT(Most(off), 0.5);
}

TEST(ImplantBuilder, TheEdgeKeepsItsClearanceAndStaysOutOfBone)
{
  const double clearance = AroundTheHole(Head()).clearanceMm;
  const auto edge = SamplesOf(Implant(), Face::Edge);
  std::vector<double> off;
  for (const auto& s : edge)
    off.push_back(ToWall(s.point) - clearance);
  EXPECT_GT(edge.size(), 2000U);
  EXPECT_GT(ShareWithin(edge, off, 0.1), 0.95);
  EXPECT_LT(Most(off), 0.25);
  // By the scan itself, wherever on the implant.
  std::vector<glm::dvec3> places;
  for (const auto& s : hasp::SampleMesh(Implant().mesh, 0.5))
    places.push_back(s.point);
  double nearest = 1e30;
  for (const auto& found : hasp::DistanceToIsosurface(Head().View(), HalfWayHU, places, 2.0))
    nearest = std::min(nearest, found ? found->distance : 1e30);
  EXPECT_GT(nearest, clearance - 0.1);
  EXPECT_LT(nearest, clearance + 0.1);
}

TEST(ImplantBuilder, FillsAllOfTheHoleButItsClearance)
{
  const hasp::AnalyticSolid outer = Head().Outer();
  const hasp::PhantomDefect hole = Head().Hole();
  const hasp::ImplantRecipe recipe = AroundTheHole(Head());
  double missing = 0.0, filled = 0.0, beyond = 0.0;
  for (double x = -28; x <= 28; x += 0.5)
    for (double y = -16; y <= 16; y += 0.5)
      for (double z = -14; z <= 3; z += 0.5)
      {
        const glm::dvec3 p = hole.center + x * hole.along + y * hole.across + z * hole.outward;
        const double height = outer.Distance(p).mm, inside = ToWall(p) - recipe.clearanceMm;
        const bool there = Implant().made.solid->At(p) < 0.0;
        const bool asked = height < 0.0 && height > -recipe.thicknessMm && inside > 0.0;
        missing += asked;
        filled += asked && there;
        beyond += !asked && there;
      }
  EXPECT_GT(missing, 20000.0);
  EXPECT_GT(filled, 0.98 * missing);
  EXPECT_LT(beyond, 0.02 * missing);
}

TEST(ImplantBuilder, TheMirroredSideIsLaidOnTheBoneAroundTheHole)
{
  // A plane that is off by a millimetre, and tilted.
  auto recipe = AroundTheHole(Head());
  recipe.spacingMm = 0.8;
  recipe.mirror = hasp::MirrorPlane{ { 1.0, 0, 0 }, glm::normalize(glm::dvec3(1.0, 0.02, -0.02)) };
  const hasp::BuiltImplant implant = hasp::BuildImplant(Head().View(), recipe);
  EXPECT_GT(std::abs(implant.made.laid.shiftMm), 0.5);
  EXPECT_LT(implant.made.laid.p95Mm, 0.3);
  const hasp::AnalyticSolid outer = Head().Outer();
  std::vector<double> steps;
  for (const auto& s : SamplesOf(implant, Face::Outer))
    steps.push_back(outer.Distance(s.point).mm);
  EXPECT_LT(Most(steps), 0.5);
}

TEST(ImplantBuilder, HolesAreAtTheirPitchAndAwayFromTheEdge)
{
  auto recipe = AroundTheHole(Head());
  recipe.holeDiameterMm = 2.4;
  recipe.holePitchMm = 9.0;
  const hasp::BuiltImplant implant = hasp::BuildImplant(Head().View(), recipe);
  const auto check = hasp::CheckMesh(implant.mesh);
  EXPECT_TRUE(check.Sound());
  const auto& holes = implant.made.holes;
  EXPECT_GT(holes.size(), 8U);
  EXPECT_EQ(1 - (int(check.points) - int(check.triangles / 2)) / 2, int(holes.size()));
  const hasp::AnalyticSolid outer = Head().Outer();
  for (std::size_t n = 0; n < holes.size(); ++n)
  {
    EXPECT_NEAR(outer.Distance(holes[n]).mm, 0.0, 0.2);
    EXPECT_GT(
      ToWall(holes[n]) - recipe.clearanceMm, recipe.holeEdgeMm + 0.5 * recipe.holeDiameterMm - 0.1);
    double nearest = 1e30;
    for (std::size_t m = 0; m < holes.size(); ++m)
    {
      const glm::dvec3 v = holes[n] - holes[m];
      if (m != n)
        nearest = std::min(nearest, glm::length(v - glm::dot(v, *recipe.axis) * *recipe.axis));
    }
    EXPECT_NEAR(nearest, recipe.holePitchMm, 0.01);
  }
}

} // namespace
