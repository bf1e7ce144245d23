#include "Distance/SharpContour.h"
#include "Distance/SolidSweeps.h"
#include "Evaluation/MeshCheck.h"
#include "Testing/SolidPromises.h"

#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"

#include <glm/gtc/constants.hpp>

#include <stdexcept>
#include <string>

namespace
{

/// Bone with its upper side at z = 0.
hasp::SolidPointer Plank(double thick)
{
  return hasp::MakeBox({ 0, 0, -0.5 * thick }, glm::dmat3(1), { 30, 30, 0.5 * thick });
}

const std::vector<glm::dvec3> Straight{ { -8, 0, 0 }, { 0, 0, 0 }, { 8, 0, 0 } };

/// Bone between two balls' surfaces.
hasp::SolidPointer Cap(double inner, double outer)
{
  return hasp::MakeShell(hasp::MakeCapsule({}, {}, outer), inner - outer, 0);
}

/// A place of a ball seen from above.
glm::dvec3 OnBall(double radius, double along, double across)
{
  return radius * glm::normalize(glm::dvec3(
                    along, across, std::sqrt(radius * radius - along * along - across * across)));
}

/// Over the top of a ball, up to `far` to each side.
std::vector<glm::dvec3> Arc(double radius, double far, double step)
{
  std::vector<glm::dvec3> path;
  for (double along = -far; along < far + 1e-9; along += step)
    path.push_back(OnBall(radius, along, 0));
  return path;
}

std::string RefusalOf(const hasp::SolidPointer& bone, const std::vector<glm::dvec3>& path,
  double width, double from, double to)
{
  try
  {
    hasp::MakeRibbon(bone, path, width, from, to);
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return "";
}

/// Of a plate on a plank along Straight: one piece between these heights, all of it.
void ExpectOnePlate(double thick, double from, double to)
{
  const auto plate = hasp::MakeRibbon(Plank(thick), Straight, 6, from, to);
  const hasp::GridGeometry grid{ { 59, 35, 59 }, { -14.5, -8.5, -14.5 }, glm::dvec3(0.5),
    glm::dmat3(1) };
  const auto mesh = hasp::SharpContour(*plate, grid);
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
  double low = 99, high = -99;
  for (const glm::dvec3& p : mesh.points)
    low = std::min(low, p.z), high = std::max(high, p.z);
  // 1 % of an edge of a cell that points keep from the grid's points.
  EXPECT_NEAR(low, from, 6e-3);
  EXPECT_NEAR(high, to, 6e-3);
  // Round ends as triangles, and the same 1 % at both sides.
  const double volume = (16 * 6 + 9 * glm::pi<double>()) * (to - from);
  EXPECT_NEAR(check.volumeMm3 / volume, 1.0, 0.02);
}

TEST(RibbonDepth, ThinBoneGetsOnePlate)
{
  for (const double thick : { 1.0, 2.0, 4.0, 5.4, 7.0 })
  {
    SCOPED_TRACE(thick);
    ExpectOnePlate(thick, 0, 1);
    ExpectOnePlate(thick, -0.4, 0.6);
  }
}

TEST(RibbonDepth, NothingIsBesideThinBonesEdge)
{
  // 2 mm of the band are beyond the edge: it goes down the side, but not round below.
  const std::vector<glm::dvec3> path{ { -8, 29, 0 }, { 8, 29, 0 } };
  const auto plate = hasp::MakeRibbon(Plank(2), path, 6, 0, 1);
  EXPECT_LT(plate->At({ 0, 29, 0.5 }), -0.4);
  EXPECT_LT(plate->At({ 0, 30.5, -0.5 }), -0.3);
  for (double y = 25; y < 33; y += 0.1)
    EXPECT_GT(plate->At({ 0, y, -2.1 }), 0.0) << y;
}

TEST(RibbonDepth, BoneMayBeThinOnOneSideOfThePath)
{
  for (const double thin : { -1.0, 1.0 })
  {
    const auto thick = hasp::MakeBox({ 0, -15 * thin, -10 }, glm::dmat3(1), glm::dvec3(30, 15, 10));
    const std::vector<glm::dvec3> path{ { -8, -thin, 0 }, { 8, -thin, 0 } };
    const auto plate = hasp::MakeRibbon(hasp::MakeUnion({ Plank(2), thick }), path, 6, 0, 1);
    for (double y = 0.1; y < 5; y += 0.1)
      EXPECT_GT(plate->At({ 0, thin * y, -2.1 }), 0.0) << thin << " " << y;
    EXPECT_LT(plate->At({ 0, 1.5 * thin, 0.5 }), -0.4) << thin;
  }
}

TEST(RibbonDepth, BoneMayBeThinInTheMiddleOfASegment)
{
  std::vector<hasp::SolidPointer> parts{ Plank(2) };
  for (const double x : { -17.0, 17.0 })
    parts.push_back(hasp::MakeBox({ x, 0, -10 }, glm::dmat3(1), { 13, 30, 10 }));
  const std::vector<glm::dvec3> path{ { -12, 0, 0 }, { 12, 0, 0 } };
  const auto plate = hasp::MakeRibbon(hasp::MakeUnion(parts), path, 6, 0, 1);
  for (double x = -3.9; x < 3.9; x += 0.1)
    EXPECT_GT(plate->At({ x, 0, -2.1 }), 0.0) << x;
}

/// Values that change by 1.7 mm a mm, as trilinear ones may.
class SteepSolid : public hasp::ImplicitSolid
{
public:
  explicit SteepSolid(hasp::SolidPointer part) : Part(std::move(part)) {}
  double At(const glm::dvec3& x) const noexcept override { return 1.7 * this->Part->At(x); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const Sample s = this->Part->SampleAt(x);
    return { 1.7 * s.value, 1.7 * s.gradient, s.face };
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const Sample s = this->Part->FaceAt(face, x);
    return { 1.7 * s.value, 1.7 * s.gradient, s.face };
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return this->Part->Bounds(); }
  double Steepness() const noexcept override { return 1.7; }

private:
  hasp::SolidPointer Part;
};

TEST(RibbonDepth, ValuesSteeperThanDistancesSkipNoBone)
{
  // A ridge 2 mm wide; beside it a sheet of 0.1 mm, 1.2 mm lower, which has its band, too.
  const auto ridge = hasp::MakeBox({ 0, 0, -1 }, glm::dmat3(1), { 30, 1, 1 });
  const auto sheet = hasp::MakeBox({ 0, 0, -1.25 }, glm::dmat3(1), { 30, 30, 0.05 });
  const auto bone = std::make_shared<SteepSolid>(hasp::MakeUnion({ ridge, sheet }));
  const auto plate = hasp::MakeRibbon(bone, Straight, 6, 0, 1);
  for (const double y : { -2.0, 2.0 })
  {
    EXPECT_LT(plate->At({ 0, y, -1.1 }), -0.1);
    EXPECT_GT(plate->At({ 0, y, -1.31 }), 0.0);
  }
}

TEST(RibbonDepth, ColumnsStayOnTheBoneThatThePathIsOn)
{
  // 5 mm beside the path the ball is 1.3 mm below the path, the other bone 0.9 mm above it.
  const auto ball = hasp::MakeCapsule({}, {}, 10);
  const auto other = hasp::MakeBox({ 0, 6, 12.9 }, glm::dmat3(1), { 9, 3, 2 });
  const auto both = hasp::MakeUnion({ ball, other });
  EXPECT_EQ(RefusalOf(both, Arc(10, 1, 1), 10, 0, 0.2), "");
}

TEST(RibbonDepth, ABandOnAThinCapLeavesItsInnerSideFree)
{
  const auto cap = Cap(67, 70);
  for (const double width : { 4.0, 6.0, 8.0, 10.0, 12.0 })
  {
    const auto plate = hasp::MakeRibbon(cap, Arc(70, 20, 4), width, 0, 1);
    for (double along = -28; along <= 28; along += 0.5)
      for (double across = -8; across <= 8; across += 0.5)
      {
        for (const double radius : { 66.5, 66.99, 68.5 })
          ASSERT_GT(plate->At(OnBall(radius, along, across)), 0.0) << width << " " << along;
        const bool isUnderBand = std::abs(along) <= 20 && std::abs(across) < 0.5 * width - 0.5;
        if (isUnderBand)
        {
          ASSERT_NEAR(plate->At(OnBall(70.5, along, across)), -0.5, 0.1) << width << " " << along;
        }
      }
  }
}

TEST(RibbonDepth, ABandInsideAThinCapLeavesItsOuterSideFree)
{
  // The bone rises beside the path and beyond each segment's end: there its other side is nearest
  // to the tangent plane, 0.30 mm below it; beside the path it is 0.63 mm.
  const auto plate = hasp::MakeRibbon(Cap(10, 11), Arc(10, 4, 2), 6, 0, 0.5);
  for (double along = -8; along <= 8; along += 0.05)
    for (double across = -4; across <= 4; across += 0.25)
      ASSERT_GT(plate->At(OnBall(11.002, along, across)), 0.0) << along << " " << across;
  for (double along = -4; along <= 4; along += 0.1)
    EXPECT_LT(plate->At(OnBall(9.7, along, 0)), -0.15) << along;
}

TEST(RibbonDepth, OnThickBoneTheBandIsAsHighAsDeep)
{
  const double width = 6, reach = 1.5 + 0.75 * width;
  const auto turned = glm::dmat3(glm::dvec3(0.6, 0.8, 0), { -0.8, 0.6, 0 }, { 0, 0, 1 });
  const auto block = hasp::MakeBox({ 0, 0, -10 }, turned, { 30, 30, 10 });
  const auto ball = hasp::MakeCapsule({}, {}, 30);
  for (const auto& [bone, path] :
    { std::pair(block, Straight), std::pair(hasp::SolidPointer(ball), Arc(30, 9, 3)) })
  {
    std::vector<hasp::SolidPointer> stadiums;
    for (std::size_t n = 0; n + 1 < path.size(); ++n)
    {
      glm::dvec3 normal = bone->SampleAt(path[n]).gradient;
      normal += bone->SampleAt(path[n + 1]).gradient;
      normal += bone->SampleAt(0.5 * (path[n] + path[n + 1])).gradient;
      stadiums.push_back(hasp::MakeStadium(path[n], path[n + 1], normal, 0.5 * width, 2.0 * reach));
    }
    const auto truth =
      hasp::MakeIntersection({ hasp::MakeShell(bone, -0.5, 1.5), hasp::MakeUnion(stadiums) });
    const auto plate = hasp::MakeRibbon(bone, path, width, -0.5, 1.5);
    for (const glm::dvec3& x : hasp::RandomPlaces(3000, 14, path[path.size() / 2]))
      ASSERT_EQ(plate->At(x), truth->At(x));
  }
}

TEST(RibbonDepth, RefusesBoneThatIsThinnerThanItBends)
{
  // 4 mm off the path the surface is 0.85 mm lower, or higher: more than the bone's 0.5 mm.
  for (const double radius : { 10.0, 9.5 })
  {
    const std::string told = RefusalOf(Cap(9.5, 10), Arc(radius, 2, 2), 8, 0, 1);
    EXPECT_NE(told.find("middle after place 0 at (-1, 0, "), std::string::npos) << told;
    EXPECT_NE(told.find("a narrower band, more places"), std::string::npos) << told;
    EXPECT_EQ(RefusalOf(Cap(9.5, 10), Arc(radius, 2, 0.5), 3, 0, 1), "");
  }
  // Thinner than what it rises by: columns beside the path begin beneath it.
  EXPECT_NE(RefusalOf(Cap(10, 10.3), Arc(10, 2, 0.5), 12, 0, 1), "");
}

TEST(RibbonDepth, RefusesALowerSideThatIsThroughTheBone)
{
  EXPECT_EQ(RefusalOf(Plank(1), Straight, 6, -0.4, 1), "");
  const std::string told = RefusalOf(Plank(1), Straight, 6, -0.6, 1);
  EXPECT_NE(told.find("place 0 at (-4, 0, 0) mm"), std::string::npos) << told;
  EXPECT_NE(told.find("a lower side less deep"), std::string::npos) << told;
}

TEST(RibbonDepth, PlacesAreToldInMillimetres)
{
  const double nan = std::nan("");
  const std::vector<glm::dvec3> off{ { 0, 0, 0 }, { 2.5, 1, 3 } }, bad{ {}, { 1, nan, 0 } };
  EXPECT_NE(RefusalOf(Plank(9), off, 6, 0, 1).find("place 1 at (2.5, 1, 3) mm is 3 mm off"),
    std::string::npos);
  EXPECT_NE(RefusalOf(Plank(9), bad, 6, 0, 1).find("place 1 at (1, nan, 0) mm is nan; it must"),
    std::string::npos);
  try
  {
    hasp::MakeTube(bad, false, 1);
    ADD_FAILURE();
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_EQ(std::string(e.what()).find("tube: place 1 at (1, nan, 0) mm is nan"), 0U) << e.what();
  }
}

} // namespace
