// Boxes, flanges, sleeves, letters, painted areas and round edges: where the recipe puts them.
#include "Distance/SolidSweeps.h"
#include "Evaluation/GuideGap.h"
#include "GuideFixture.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <algorithm>
#include <functional>

using namespace guidetest;

namespace
{

constexpr double SkullRadius = 40.0;
// Of a surface of the recipe's, mm: a hundredth of a cell's diagonal that points keep from its
// ends, and as much that triangles may bend. At 0.6 mm a cell.
constexpr double ContourMm = 0.018;
// The middle of a fan may be 0.04 of a cell off instead (SharpContour.h), wherever the grid lies.
constexpr double FanMm = 0.6 * (0.04 + 0.01);

/// A ball of bone: above its top all is closed form.
vtkImageData* Ball()
{
  static const auto ct =
    ScanOf(hasp::AnalyticSphere({ 0, 0, -20 }, SkullRadius), glm::dvec3(1.5), 0.2);
  return ct;
}

glm::dvec3 OnBall(double x, double y)
{
  return { x, y, std::sqrt(SkullRadius * SkullRadius - x * x - y * y) - 20 };
}

/// A band along x over the top of the ball, with nothing on it.
hasp::GuideRecipe Bare()
{
  hasp::GuideRecipe r;
  r.landmarks = { OnBall(-20, 0), OnBall(-10, 0), OnBall(0, 0), OnBall(10, 0), OnBall(20, 0) };
  r.widthMm = 18;
  r.thicknessMm = 3;
  r.edgeRadiusMm = 0;
  r.spacingMm = 0.6;
  return r;
}

hasp::TriangleMesh Made(const hasp::GuideRecipe& recipe)
{
  Answer answer(Ball(), recipe);
  EXPECT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.Guide());
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  return mesh;
}

/// Area of the triangles that lie in a plane, within 0.02 mm and a degree, and within `reach` of
/// the point.
double AreaInPlane(const hasp::TriangleMesh& mesh, const glm::dvec3& point,
  const glm::dvec3& normal, double reach = 1e9)
{
  double area = 0;
  for (const auto& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    if (glm::dot(n, normal) < std::cos(glm::radians(1.0)) * glm::length(n) ||
        glm::distance((a + b + c) / 3.0, point) > reach)
      continue;
    double off = 0;
    for (const glm::dvec3& p : { a, b, c })
      off = std::max(off, std::abs(glm::dot(p - point, normal)));
    area += off < 0.02 ? 0.5 * glm::length(n) : 0;
  }
  return area;
}

double Highest(const hasp::TriangleMesh& mesh)
{
  double z = -1e9;
  for (const auto& p : mesh.points)
    z = std::max(z, p.z);
  return z;
}

TEST(GuideParts, ASlotIsAsWideAsKerfAndClearanceAndItsBoxLeadsTheSaw)
{
  auto r = Bare();
  r.slots = { { OnBall(0, 0), { 1, 0, 0 }, 1.0, 10, 20, 12 } };
  const auto mesh = Made(r);
  // Walls of the slot at half of 1.0 + 2 * 0.25 mm, from the bone's gap to the top of the box.
  for (const double side : { -1.0, 1.0 })
  {
    const glm::dvec3 wall(side * 0.75, 0, 20);
    EXPECT_NEAR(AreaInPlane(mesh, wall, { -side, 0, 0 }), 10 * (12 - r.gapMm), 0.05 * 120);
    const glm::dvec3 box(side * 3.75, 0, 20);
    EXPECT_NEAR(AreaInPlane(mesh, box, { side, 0, 0 }), 16 * (12 - 3.3), 0.05 * 140);
  }
  EXPECT_NEAR(AreaInPlane(mesh, { 0, 0, 32 }, { 0, 0, 1 }), 7.5 * 16 - 1.5 * 10, 1.0);
  EXPECT_NEAR(Highest(mesh), 32, 0.01);
  EXPECT_NEAR(AreaInPlane(mesh, { 0, 5, 20 }, { 0, -1, 0 }), 1.5 * (12 - r.gapMm), 1.5);
}

TEST(GuideParts, NothingIsCutDeeperThanAsked)
{
  auto r = Bare();
  // From 2 mm above the bone 1 mm down: a groove with a floor, and no hole.
  r.slots = { { OnBall(0, 0) + glm::dvec3(0, 0, 2), { 1, 0, 0 }, 1.0, 8, 1, 0 } };
  r.holes = { { OnBall(-10, 0) + glm::dvec3(0, 0, 2), { 0, 0, -1 }, 3, 1, 0 } };
  const auto mesh = Made(r);
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_EQ(int(check.points) - int(check.triangles / 2), 2);
  EXPECT_NEAR(AreaInPlane(mesh, { 0, 0, 21 }, { 0, 0, 1 }), 1.5 * 8, 0.5);
  EXPECT_NEAR(AreaInPlane(mesh, OnBall(-10, 0) + glm::dvec3(0, 0, 1), { 0, 0, 1 }), 7.07, 0.3);
}

TEST(GuideParts, AFlangeIsOneWallAndNothingBeforeIt)
{
  auto r = Bare();
  r.edgeRadiusMm = 0.6; // the face stays sharp
  r.flanges = { { OnBall(8, 0), { 1, 0, 0 }, 1.0, 24, 11, 20, 30 } };
  const auto mesh = Made(r);
  const double face = 8 - 0.75; // half the kerf and the clearance behind the plane
  EXPECT_GT(AreaInPlane(mesh, { face, 0, 20 }, { 1, 0, 0 }), 24 * 9.0);
  double farthest = -1e9;
  for (const auto& p : mesh.points)
    farthest = std::max(farthest, p.x);
  EXPECT_NEAR(farthest, face, 0.01);
  EXPECT_NEAR(Highest(mesh), OnBall(8, 0).z + 11, 0.01);
  EXPECT_GT(AreaInPlane(mesh, { face - r.wallMm, 0, 20 }, { -1, 0, 0 }), 20 * 6.0);
}

TEST(GuideParts, HolesAreRoundAndStandInSleeves)
{
  auto r = Bare();
  r.holes = { { OnBall(-10, 0), glm::normalize(glm::dvec3(-0.2, 0, 1)), 3.0, 20, 8 } };
  const auto mesh = Made(r);
  const glm::dvec3 axis = r.holes[0].axis;
  double bore = 0, sleeve = 0, most = 0, fans = 0;
  for (const auto& p : mesh.points)
  {
    const glm::dvec3 v = p - r.holes[0].point;
    const double height = glm::dot(v, axis), away = glm::length(v - height * axis);
    most = std::max(most, height * (away < 4.0));
    if (height > 4.2 && height < 7.9 && away < 4.0) // above the shell: bore and sleeve alone
    {
      EXPECT_NEAR(away, away < 2.5 ? 1.5 : 3.5, FanMm) << height;
      fans += std::abs(away - (away < 2.5 ? 1.5 : 3.5)) > ContourMm;
      (away < 2.5 ? bore : sleeve) += 1;
    }
  }
  EXPECT_GT(bore, 50);
  EXPECT_GT(sleeve, 50);
  EXPECT_LT(fans, 0.01 * (bore + sleeve));
  EXPECT_NEAR(most, 8, 0.01);
}

TEST(GuideParts, WhatIsAddedClearsTheBoneAndLiftsOff)
{
  // Leaning over the band's edge, long and low: bone and its shadow are taken from them, too.
  auto r = Bare();
  const glm::dvec3 lean = glm::normalize(glm::dvec3(0, -1, 1));
  r.slots = { { OnBall(0, -6), glm::normalize(glm::dvec3(0, 1, 0.5)), 1.0, 14, 20, 9 } };
  r.holes = { { OnBall(12, -6), lean, 3.0, 20, 12 } };
  const auto mesh = Made(r);
  for (const auto& p : mesh.points)
  {
    const double above = glm::distance(p, { 0, 0, -20 }) - SkullRadius;
    EXPECT_GT(above, r.gapMm - 0.06);
    if (p.z < -20)
    {
      EXPECT_GT(std::hypot(p.x, p.y), SkullRadius + r.gapMm - 0.06);
    }
  }
}

/// Area of letters in their plane, by counting places.
double AreaOf(const std::string& text, double height)
{
  const auto letters = hasp::MakeText(text, {}, { 1, 0, 0 }, { 0, 1, 0 }, height, height / 6);
  const double step = 0.02, width = hasp::TextWidth(text.size(), height);
  double area = 0;
  for (double x = -height; x < width + height; x += step)
    for (double y = -height; y < 2 * height; y += step)
      area += letters->At({ x, y, 0 }) < 0 ? step * step : 0;
  return area;
}

TEST(GuideParts, LettersStandOutOrAreCutInByTheirDepth)
{
  auto r = Bare();
  const double plain = hasp::CheckMesh(Made(r)).volumeMm3;
  r.labels = { { "L 7", OnBall(-4, 0), { 1, 0, 0 }, 8, 1.2, false } };
  const auto raised = Made(r);
  const double volume = AreaOf("L 7", 8) * 1.2;
  // Pillars that end on a wall that is bent: 2 % longer at their ends.
  EXPECT_NEAR(hasp::CheckMesh(raised).volumeMm3 - plain, volume, 0.04 * volume);
  double most = 0, least = 1e9;
  for (const auto& p : raised.points)
    most = std::max(most, glm::distance(p, { 0, 0, -20 }) - SkullRadius);
  EXPECT_NEAR(most, r.gapMm + r.thicknessMm + 1.2, 0.05);
  r.labels[0].engraved = true;
  const auto cut = Made(r);
  EXPECT_NEAR(plain - hasp::CheckMesh(cut).volumeMm3, volume, 0.04 * volume);
  for (const auto& p : cut.points)
    if (std::hypot(p.x + 4, p.y) < 6 && glm::distance(p, { 0, 0, -20 }) > SkullRadius + 1)
      least = std::min(least, glm::distance(p, { 0, 0, -20 }) - SkullRadius);
  EXPECT_NEAR(least, r.gapMm + r.thicknessMm - 1.2, 0.05);
}

TEST(GuideParts, LettersAreReadFromOutside)
{
  // Of an L the upright is on the left and the foot below, as seen from above with x to the right.
  auto r = Bare();
  r.labels = { { "L", OnBall(0, 0), { 1, 0, 0 }, 9, 1.2, false } };
  glm::dvec3 sum(0);
  double area = 0;
  const auto mesh = Made(r);
  for (const auto& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 middle = (a + b + c) / 3.0, n = glm::cross(b - a, c - a);
    if (glm::distance(middle, { 0, 0, -20 }) < SkullRadius + r.gapMm + r.thicknessMm + 1.1 ||
        n.z < 0.9 * glm::length(n))
      continue;
    sum += glm::length(n) * middle;
    area += glm::length(n);
  }
  ASSERT_GT(area, 10);
  EXPECT_LT(sum.x / area, -0.8); // strokes of 9 and 6 mm: 3 mm * 9 / 15 left of the middle, less
  EXPECT_LT(sum.y / area, -0.8);
}

TEST(GuideParts, AnAreaIsPaintedAndWipedOffAgain)
{
  auto r = Bare();
  r.landmarks.clear();
  r.strokes = { { { OnBall(-10, 0), OnBall(10, 0) }, 8, false }, { { OnBall(10, 0) }, 9, false },
    { { OnBall(10, 0) }, 3, true } }; // less than the wall
  const auto mesh = Made(r);
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_EQ(int(check.points) - int(check.triangles / 2), 0); // what was wiped off is a hole
  double east = 0, west = 0;
  for (const auto& p : mesh.points)
  {
    east = std::max(east, p.x);
    west = std::min(west, p.x);
    EXPECT_GT(std::hypot(p.x - 10, p.y), 3 - ContourMm); // upright, all through the wall
  }
  EXPECT_NEAR(east, 10 + 9, 0.5);
  EXPECT_NEAR(west, -10 - 8, 0.5);
}

TEST(GuideParts, RoundEdgesTakeTheOuterRimAlone)
{
  const auto sharp = Made(Bare());
  auto r = Bare();
  r.edgeRadiusMm = 1.5;
  const auto round = Made(r);
  // A rim of some 130 mm loses something, and less than the square before its edge.
  const double loss = hasp::CheckMesh(sharp).volumeMm3 - hasp::CheckMesh(round).volumeMm3;
  EXPECT_GT(loss, 5);
  EXPECT_LT(loss, 130 * 0.5 * 1.5 * 1.5);
  EXPECT_NEAR(Highest(round), Highest(sharp), 0.01);
  const auto lowest = [](const hasp::TriangleMesh& mesh)
  {
    return std::min_element(mesh.points.begin(), mesh.points.end(),
      [](const auto& a, const auto& b) { return a.z < b.z; })
      ->z;
  };
  EXPECT_NEAR(lowest(round), lowest(sharp), 0.01); // the inner rim
}

void ExpectRefused(const std::function<void(hasp::GuideRecipe&)>& spoil, const std::string& part)
{
  auto r = Bare();
  r.spacingMm = 0.5;
  spoil(r);
  Answer answer(Ball(), r);
  EXPECT_EQ(answer.Guide()->GetNumberOfPoints(), 0);
  EXPECT_NE(answer.error.find(part), std::string::npos) << part << " in: " << answer.error;
}

TEST(GuideParts, WhatDoesNotFitIsNamed)
{
  using R = hasp::GuideRecipe;
  ExpectRefused(
    [](R& r) {
      r.holes = { { OnBall(0, 25), { 0, 0, 1 } } };
    },
    "holes[0] does not meet the guide");
  ExpectRefused(
    [](R& r) {
      r.slots = { { OnBall(0, 0) + glm::dvec3(0, 0, 25), { 1, 0, 0 }, 1, 10, 500 } };
    },
    "the box of slots[0] does not stand on the guide");
  ExpectRefused(
    [](R& r) {
      r.flanges = { { OnBall(0, 30), { 1, 0, 0 } } };
    },
    "flanges[0] does not meet the guide");
  ExpectRefused(
    [](R& r) {
      r.flanges = { { OnBall(20, 0) + glm::dvec3(9, 0, 0), { -1, 0, 0 }, 1, 20, 15, 20, 30 } };
    },
    "the wall of flanges[0] does not stand on the guide");
  ExpectRefused(
    [](R& r) {
      r.holes = { { OnBall(0, 0) + glm::dvec3(0, 0, 9), { 0, 0, 1 } } };
    },
    "the sleeve of holes[0] does not stand on the guide");
  ExpectRefused(
    [](R& r) {
      r.labels = { { "ERIKA7", OnBall(18, 0), { 1, 0, 0 }, 9 } };
    },
    "labels[0] reaches beyond the guide");
  ExpectRefused(
    [](R& r)
    {
      r.holes = { { OnBall(0, 0), { 0, 0, 1 } } };
      r.labels = { { "ERIKA", OnBall(0, 0), { 1, 0, 0 }, 8 } };
    },
    "labels[0] reaches beyond the guide");
  ExpectRefused(
    [](R& r) {
      r.labels = { { "ERIKA", OnBall(0, 0), { 0, 0, 1 }, 8 } };
    },
    "labels[0] is written towards the wall");
  ExpectRefused(
    [](R& r) {
      r.labels = { { "ERIKA", { 0, 0, -20 }, { 1, 0, 0 }, 8 } };
    },
    "labels[0]");
  ExpectRefused(
    [](R& r) {
      r.labels = { { "", OnBall(0, 0), { 1, 0, 0 }, 8, 1, false, hasp::GuideLabelKind::Case } };
    },
    "labels[0] is to name the case");
  ExpectRefused(
    [](R& r)
    {
      r.landmarks.clear();
      r.strokes = { { { OnBall(0, 0) + glm::dvec3(0, 0, 6) }, 8, false } };
    },
    "strokes[0].points[0] is");
}

} // namespace
