// Plates on bone that has a closed form: their sections, holes and gaps; and what is refused.
#include "Distance/Csg.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidMoves.h"
#include "Distance/SolidShapes.h"
#include "Evaluation/MeshCheck.h"
#include "MeshSection.h"
#include "PlateBuilder.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace
{

using parttest::RadiiOf;
using parttest::SectionOf;

/// A table: bone below z = 0.
hasp::SolidPointer Table()
{
  return hasp::MakeBox({ 0, 0, -15 }, glm::dmat3(1), { 60, 60, 15 });
}

hasp::PlateRecipe OnTable()
{
  hasp::PlateRecipe r;
  r.landmarks = { { -15, 0, 0 }, { 0, 0, 0.2 }, { 15, 0, -0.1 } };
  r.screws = { { { -12, 0, 0 } }, { { 0, 0.3, 0 } }, { { 12, 0, 0 } } };
  return r;
}

/// What the work throws; empty if nothing.
template <typename Work>
std::string Refused(const Work& work)
{
  try
  {
    work();
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

std::string Fault(const hasp::SolidPointer& bone, const hasp::PlateRecipe& recipe)
{
  return Refused([&] { hasp::MakePlateOn(bone, bone, recipe); });
}

/// A round bone of 20 mm along y.
hasp::SolidPointer RoundBone()
{
  return hasp::MakeCylinder({ 0, -60, 0 }, { 0, 60, 0 }, 20);
}

glm::dvec3 OnRound(double angle, double y)
{
  return { 20 * std::sin(angle), y, 20 * std::cos(angle) };
}

struct Plate
{
  hasp::PlateSolid made;
  hasp::TriangleMesh mesh;

  Plate(const hasp::SolidPointer& bone, const hasp::PlateRecipe& recipe)
    : made(hasp::MakePlateOn(bone, bone, recipe)),
      mesh(hasp::SharpContour(*made.solid, made.grid))
  {
  }
};

// A bevelled rectangle.
double SectionArea(const hasp::PlateRecipe& r)
{
  return r.widthMm * r.thicknessMm - r.bevelMm * r.bevelMm;
}

void ExpectSound(const hasp::TriangleMesh& mesh)
{
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
}

TEST(PlateBuilder, OnAPlaneTheSectionIsTheSameEverywhere)
{
  auto recipe = OnTable();
  recipe.screws.clear();
  const Plate plate(Table(), recipe);
  ExpectSound(plate.mesh);
  for (double x = -14.9; x < 15.0; x += 1.37)
  {
    const auto section =
      SectionOf(plate.mesh, { x, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, parttest::Everywhere);
    // Flat faces lie within 1 % of a cell of where they are; edges within 8 %.
    EXPECT_NEAR(section.high.x - section.low.x, 7.0, 0.01) << x;
    EXPECT_NEAR(section.low.y, 0.2, 0.005) << x;
    EXPECT_NEAR(section.high.y, 2.7, 0.005) << x;
    EXPECT_NEAR(section.area, SectionArea(recipe), 0.05) << x;
  }
  // Round ends: half a disc more at each, less the bevel around it (its section's middle is 0.25 mm
  // inside the rim).
  const double disc = 3.14159265 * 3.5 * 3.5 * 2.5 - 0.5 * 0.75 * 0.75 * 6.2831853 * 3.25;
  EXPECT_NEAR(hasp::CheckMesh(plate.mesh).volumeMm3, 30 * SectionArea(recipe) + disc, 1.0);
}

TEST(PlateBuilder, AroundAndAlongARoundBoneTheSectionIsTheSame)
{
  auto recipe = OnTable();
  recipe.screws.clear();
  recipe.landmarks = { OnRound(-0.7, 0), OnRound(0, 0), OnRound(0.7, 0) };
  const Plate around(RoundBone(), recipe);
  ExpectSound(around.mesh);
  for (double angle = -0.69; angle < 0.7; angle += 0.067)
  {
    const glm::dvec3 out(std::sin(angle), 0, std::cos(angle));
    const auto section = SectionOf(around.mesh, {}, { 0, 1, 0 }, out,
      [&](const glm::dvec3& at) { return glm::dot(at, out) > 0.0; });
    EXPECT_NEAR(section.high.x - section.low.x, 7.0, 0.02) << angle;
    // Chords of 1.16 mm: 0.008 mm within an arc of 20 mm; that of triangles comes to 0.004 more.
    EXPECT_NEAR(section.low.y, 20.2, 0.02) << angle;
    EXPECT_NEAR(section.high.y, 22.7, 0.02) << angle;
    EXPECT_NEAR(section.area, SectionArea(recipe), 0.07) << angle;
  }
  recipe.landmarks = { OnRound(0, -15), OnRound(0, 15) };
  const Plate along(RoundBone(), recipe);
  ExpectSound(along.mesh);
  for (double y = -14.9; y < 15.0; y += 2.13)
  {
    const auto section =
      SectionOf(along.mesh, { 0, y, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, parttest::Everywhere);
    EXPECT_NEAR(section.high.x - section.low.x, 7.0, 0.02) << y;
    EXPECT_NEAR(section.high.y, 22.7, 0.01) << y;
  }
}

TEST(PlateBuilder, GapToTheBoneIsTheSameOnTheWholeInnerFace)
{
  auto recipe = OnTable();
  recipe.landmarks = { OnRound(-0.6, -8), OnRound(0, 0), OnRound(0.6, 8) };
  recipe.screws = { { OnRound(-0.5, -7) } };
  recipe.gapMm = 0.3;
  const auto bone = RoundBone();
  const Plate plate(bone, recipe);
  ExpectSound(plate.mesh);
  double least = 1e9, most = 0.0;
  for (const glm::uvec3& t : plate.mesh.triangles)
  {
    const glm::dvec3 a = plate.mesh.points[t[0]], b = plate.mesh.points[t[1]],
                     c = plate.mesh.points[t[2]], at = (a + b + c) / 3.0;
    const auto s = bone->SampleAt(at);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (s.value > 1.0 || glm::dot(normal, s.gradient) > -0.9 * glm::length(normal))
      continue; // no inner face
    least = std::min(least, s.value);
    most = std::max(most, s.value);
  }
  // The face's rim is part of it: edges are true to 8 % of a cell.
  EXPECT_NEAR(least, 0.3, 0.08 * recipe.spacingMm + 0.003);
  EXPECT_NEAR(most, 0.3, 0.08 * recipe.spacingMm + 0.003);
}

TEST(PlateBuilder, HolesAreBoredAndCountersunkTrue)
{
  auto recipe = OnTable();
  recipe.screws[1].axis = glm::normalize(glm::dvec3(0.3, 0, 1)); // 16.7 degrees
  const Plate plate(Table(), recipe);
  ExpectSound(plate.mesh);
  // Three rings.
  const auto check = hasp::CheckMesh(plate.mesh);
  EXPECT_EQ(1 - (int(check.points) - int(check.triangles / 2)) / 2, 3);
  for (std::size_t n = 0; n < 3; ++n)
  {
    const hasp::PlacedScrew& screw = plate.made.screws[n];
    EXPECT_NEAR(screw.outer.z, 2.7, 1e-5);
    EXPECT_NEAR(screw.inner.z, 0.2, 1e-5);
    // Between the inner face and the cone, which ends 1.1 mm below the outer one.
    const double lean = n == 1 ? 0.6 : 0.05; // so far the inner face comes up beside it
    const auto bore = RadiiOf(plate.mesh, screw.inner, screw.axis, lean, 1.35 - lean, 1.5);
    EXPECT_NEAR(bore.first, 1.2, 0.01) << n;
    EXPECT_NEAR(bore.second, 1.2, 0.01) << n;
    if (n == 1)
      continue; // it leans: its head's rim is no circle about the axis
    const auto head = RadiiOf(plate.mesh, screw.outer, screw.axis, -0.25, -0.02, 2.05);
    EXPECT_NEAR(head.second, 2.0, 0.01) << n;
  }
  EXPECT_LT(glm::distance(plate.made.screws[0].axis, glm::dvec3(0, 0, 1)), 1e-9);
}

TEST(PlateBuilder, ABoneThatWasMovedHasItsPlateMovedWithIt)
{
  const hasp::RigidPose pose{ { 3, -40, 12 }, hasp::TurnBy({ 0.4, 0.2, -0.7 }) };
  auto recipe = OnTable();
  recipe.screws = { { { 0, 0.3, 0 } } };
  const Plate still(Table(), recipe);
  for (glm::dvec3& p : recipe.landmarks)
    p = pose.Place(p);
  recipe.screws[0].point = pose.Place(recipe.screws[0].point);
  const Plate moved(hasp::MakeMoved(Table(), pose), recipe);
  ExpectSound(moved.mesh);
  EXPECT_NEAR(hasp::CheckMesh(moved.mesh).volumeMm3, hasp::CheckMesh(still.mesh).volumeMm3, 0.5);
  EXPECT_LT(
    glm::distance(moved.made.screws[0].outer, pose.Place(still.made.screws[0].outer)), 1e-6);
}

TEST(PlateBuilder, ABridgedFractureLeavesTheInnerFaceFlat)
{
  // Two tables 1.2 mm apart.
  const auto bone =
    hasp::MakeUnion({ hasp::MakeBox({ -30.6, 0, -10 }, glm::dmat3(1), { 30, 20, 10 }),
      hasp::MakeBox({ 30.6, 0, -10 }, glm::dmat3(1), { 30, 20, 10 }) });
  auto recipe = OnTable();
  recipe.screws = { { { -12, 0, 0 } }, { { 12, 0, 0 } } };
  recipe.bridgeMm = 3.0;
  const auto region = hasp::BoxAround(recipe.landmarks, 22.0);
  const auto bridged = hasp::BridgedSolid(*bone, recipe.bridgeMm, region, recipe.spacingMm, {});
  hasp::PlateSolid made = hasp::MakePlateOn(bone, bridged, recipe);
  const auto mesh = hasp::SharpContour(*made.solid, made.grid);
  ExpectSound(mesh);
  // A ball of 3 mm sinks 3 - sqrt(9 - 0.36) = 0.06 mm into the line.
  for (const double x : { -6.0, -0.5, 0.0, 0.5, 6.0 })
  {
    const auto section =
      SectionOf(mesh, { x, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, parttest::Everywhere);
    EXPECT_NEAR(section.low.y, 0.2, 0.1) << x;
    EXPECT_NEAR(section.high.y, 2.7, 0.1) << x;
  }
  // A screw in the line itself holds nothing.
  recipe.screws.push_back({ { 0, 0, 0 } });
  recipe.screws[2].diameterMm = 1.0;
  try
  {
    hasp::MakePlateOn(bone, bridged, recipe);
    FAIL() << "not refused";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("screws[2] meets no bone"), std::string::npos)
      << error.what();
  }
}

#define EXPECT_NAMES(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)

TEST(PlateBuilder, WhatCannotBeMadeIsNamed)
{
  const auto fault = [](auto change)
  {
    auto recipe = OnTable();
    change(recipe);
    return Fault(Table(), recipe);
  };
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_EQ(fault([](auto& r) { r.landmarks[1].z = 4; }),
    "plate: landmarks[1] is 4 mm from bone, must be within 3");
  EXPECT_EQ(fault([](auto& r) { r.landmarks[1] = r.landmarks[0] + glm::dvec3(0, 0, 0.5); }),
    "plate: landmarks[0] and landmarks[1] come to lie on one place of bone");
  EXPECT_EQ(fault([](auto& r) { r.screws[2].point.z = -7; }),
    "plate: screws[2] is 7 mm from bone, must be within 3");
  EXPECT_EQ(fault(
              [](auto& r)
              {
                r.screws[1].point.y = 0.0;
                r.screws[2].point.y = 1.4;
                r.edgeDistanceMm = 1.5;
                r.screws[2].headDiameterMm = 2.4;
              }),
    "plate: screws[2] is 0.9 mm from the plate's edge, must be 1.5");
  EXPECT_EQ(fault([](auto& r) { r.screws[1].headDiameterMm = 5.2; }),
    "plate: screws[1] is 0.6 mm from the plate's edge, must be 1");
  EXPECT_EQ(fault([](auto& r) { r.screws[2].point.x = 4.4; }),
    "plate: screws[1] and screws[2] clash: their holes are 0.41 mm apart, must be 1");
  EXPECT_NAMES(fault([](auto& r) { r.screws[0].axis = glm::dvec3(0, 0.8, 0.6); }),
    "screws[0].axis leans on the plate by 53.1 degrees, at most 45");
  EXPECT_NAMES(fault(
                 [](auto& r)
                 {
                   // Towards each other below the plate.
                   r.edgeDistanceMm = 0.5;
                   r.screws[0].axis = glm::normalize(glm::dvec3(-0.45, 0, 1));
                   r.screws[1].axis = glm::normalize(glm::dvec3(0.45, 0, 1));
                   r.screws[0].point = { -4, 0, 0 };
                   r.screws[1].point = { 4, 0, 0 };
                 }),
    "screws[0] and screws[1] clash: their shafts overlap by");
  auto recipe = OnTable();
  recipe.screws.clear();
  recipe.landmarks = { OnRound(-1.2, 0), OnRound(1.2, 0) };
  EXPECT_NAMES(
    Fault(RoundBone(), recipe), "the curve between landmarks[0] and landmarks[1] leaves bone by");
  // A wall of 0.3 mm that bends away by 1.1 mm under half the width.
  recipe.landmarks = { { 0, -10, 6 }, { 0, 10, 6 } };
  const auto pipe = hasp::MakeDifference(hasp::MakeCylinder({ 0, -60, 0 }, { 0, 60, 0 }, 6),
    hasp::MakeCylinder({ 0, -61, 0 }, { 0, 61, 0 }, 5.7));
  EXPECT_NAMES(Fault(pipe, recipe), "plate: it cannot lie along these landmarks");
}

TEST(PlateBuilder, LiesOnlyWhereBoneIsBelowAllOfIt)
{
  auto recipe = OnTable();
  recipe.screws.clear();
  const auto half = [](double y, double top) {
    return hasp::MakeBox({ 0, y, -15 + top }, glm::dmat3(1), { 60, 30, 15 });
  };
  // The table's edge 2 mm beside the middle line: a fin would hang over it.
  EXPECT_NAMES(Fault(half(-28, 0), recipe), "higher or lower than the middle line");
  // A step of 2 mm, 1.5 mm beside it.
  EXPECT_NAMES(Fault(hasp::MakeUnion({ half(-28.5, 0), half(31.5, -2) }), recipe),
    "plate: near landmarks[0], at (");
  EXPECT_NAMES(Fault(hasp::MakeUnion({ half(-28.5, 0), half(31.5, -2) }), recipe), "slopes by ");
  // Beyond its edge it does not matter.
  EXPECT_EQ(Fault(half(-26.2, 0), recipe), "");
  // The table's end under its own.
  recipe.landmarks.back().x = 58;
  EXPECT_NAMES(Fault(Table(), recipe), "near landmarks[2]");
}

TEST(PlateBuilder, AHeadSitsInThePlate)
{
  auto recipe = OnTable();
  recipe.edgeDistanceMm = 0.5;
  const auto leaning = [&](double degrees)
  {
    const double lean = glm::radians(degrees);
    recipe.screws[1].axis = { std::sin(lean), 0, std::cos(lean) };
    return Fault(Table(), recipe);
  };
  EXPECT_EQ(leaning(28), "");
  // The outer face falls by 2 mm * tan(35) beside the axis; the cone ends 1.1 mm below it.
  EXPECT_NAMES(leaning(35), "screws[1]'s head stands out of the plate");
  recipe.screws[1].headDepthMm = 1.6; // the bore is 0.1 mm long where it does not lean
  EXPECT_EQ(leaning(0), "");
  EXPECT_NAMES(leaning(15), "screws[1]'s head leaves a bore of");
}

TEST(PlateBuilder, AScrewIsUprightOnThePlateAsAWhole)
{
  // A table with waves of 2 mm, 0.15 mm high: its own normals lean by 25 degrees.
  class Waves : public hasp::ImplicitSolid
  {
  public:
    double At(const glm::dvec3& x) const noexcept override { return this->SampleAt(x).value; }
    Sample SampleAt(const glm::dvec3& x) const noexcept override
    {
      const double k = 3.14159265;
      return { 0.9 * (x.z - 0.15 * std::sin(k * x.x)),
        0.9 * glm::dvec3(-0.15 * k * std::cos(k * x.x), 0, 1), 0 };
    }
    Sample FaceAt(std::uint32_t, const glm::dvec3& x) const noexcept override
    {
      return this->SampleAt(x);
    }
    std::uint32_t Faces() const noexcept override { return 1; }
    Box Bounds() const noexcept override { return {}; }
  };
  auto recipe = OnTable();
  recipe.screws.resize(1);
  recipe.screws[0].point.x = -11;
  const auto bone = std::make_shared<const Waves>();
  const auto made = hasp::MakePlateOn(bone, bone, recipe);
  EXPECT_GT(made.screws[0].axis.z, std::cos(glm::radians(2.0)));
}

TEST(PlateBuilder, FragmentsOfAScanArePosedAndNeedLabels)
{
  // One table, parted at x = 0 in labels, its right half pulled 1 mm away to the right.
  const hasp::GridGeometry grid{ { 81, 41, 31 }, { -40, -20, -25 }, glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> grey(grid.Size());
  std::vector<std::uint8_t> label(grid.Size());
  for (std::size_t n = 0; n < grey.size(); ++n)
  {
    const glm::dvec3 p =
      grid.IndexToWorld({ double(n % 81), double(n / 81 % 41), double(n / 3321) });
    grey[n] = float(226.0 - 500.0 * p.z);
    label[n] = p.x < 0.0 ? 3 : 4;
  }
  hasp::BoneScan scan{ hasp::GridView<const float>{ grey.data(), grid }, {} };
  auto recipe = OnTable();
  recipe.landmarks = { { -9, 0, 0 }, { 9, 0, 0 } };
  recipe.screws = { { { -6, 0, 0 } }, { { 6, 0, 0 } } };
  recipe.spacingMm = recipe.bevelMm = 1.0;
  const auto whole = hasp::BuildPlate(scan, recipe);
  ExpectSound(whole.mesh);
  recipe.fragments = { { 3 }, { 4, { 1, 0, 0 } } };
  recipe.bridgeMm = 3.0;
  EXPECT_THROW(hasp::BuildPlate(scan, recipe), std::invalid_argument);
  scan.labels = hasp::GridView<const std::uint8_t>{ label.data(), grid };
  const auto posed = hasp::BuildPlate(scan, recipe);
  ExpectSound(posed.mesh);
  const double volume = hasp::CheckMesh(whole.mesh).volumeMm3;
  EXPECT_NEAR(hasp::CheckMesh(posed.mesh).volumeMm3, volume, 0.02 * volume);
  recipe.fragments = { { 7 } };
  EXPECT_THROW(hasp::BuildPlate(scan, recipe), std::runtime_error);
  recipe.fragments = { { 3 } };
  hasp::GridGeometry shifted = grid;
  shifted.origin.x += 1.0;
  scan.labels = hasp::GridView<const std::uint8_t>{ label.data(), shifted };
  EXPECT_NE(Refused([&] { hasp::BuildPlate(scan, recipe); })
              .find("plate: the labels are of another grid than the volume: their origin"),
    std::string::npos);
}

TEST(PlateBuilder, NoBoneToBridgeIsSaid)
{
  const auto far = hasp::MakeBox({ 500, 0, 0 }, glm::dmat3(1), { 30, 20, 10 });
  const auto region = hasp::BoxAround(OnTable().landmarks, 22.0);
  EXPECT_EQ(Refused([&] { hasp::BridgedSolid(*far, 3.0, region, 1.0, {}); }),
    "plate: there is no bone around the landmarks to bridge");
}

} // namespace
