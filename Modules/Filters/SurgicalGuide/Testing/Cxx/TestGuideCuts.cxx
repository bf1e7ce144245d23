// Guides that follow planned cuts: the planes in the written mesh are those of the blades.
#include "Evaluation/SlotFit.h"
#include "Evaluation/TriangleTree.h"
#include "GuideClaims.h"
#include "GuideFixture.h"

#include <random>
#include <vector>

using namespace guidetest;

namespace
{

constexpr double Radius = 40.0;

vtkImageData* Ball()
{
  static const auto ct = ScanOf(hasp::AnalyticSphere({ 0, 0, -20 }, Radius), glm::dvec3(1.5), 0.2);
  return ct;
}

glm::dvec3 OnBall(double x, double y)
{
  return { x, y, std::sqrt(Radius * Radius - x * x - y * y) - 20 };
}

hasp::GuideRecipe Plain()
{
  hasp::GuideRecipe r;
  r.landmarks = { OnBall(-18, 0), OnBall(-9, 0), OnBall(0, 0), OnBall(9, 0), OnBall(18, 0) };
  r.widthMm = 24;
  r.thicknessMm = 3;
  r.spacingMm = 0.6;
  return r;
}

/// A blade whose middle is somewhere in the bone below the guide.
hasp::Osteotomy AnyBlade(std::mt19937& random)
{
  std::uniform_real_distribution<double> any(-1, 1);
  hasp::Osteotomy blade;
  const double around = 3.1 * any(random);
  blade.normal = glm::normalize(glm::dvec3(std::cos(around), std::sin(around), 0.4 * any(random)));
  const glm::dvec3 other = glm::normalize(glm::dvec3(any(random), any(random), 0.3 * any(random)));
  blade.along = glm::normalize(glm::cross(blade.normal, glm::cross(other, blade.normal)));
  if (std::abs(blade.along.z) > 0.4) // not on its end
    blade.along = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), blade.normal));
  blade.point = OnBall(7 * any(random), 3 * any(random)) - glm::dvec3(0, 0, 1 + any(random));
  blade.widthMm = 12;
  blade.depthMm = 20;
  blade.kerfMm = 1.1 + 0.3 * any(random);
  return blade;
}

class GuideOfCut : public testing::TestWithParam<int>
{
};

TEST_P(GuideOfCut, HasTheBladesPlane)
{
  std::mt19937 random(1000 + GetParam());
  const hasp::Osteotomy blade = AnyBlade(random);
  Answer answer(Ball(), Plain(), { blade });
  ASSERT_EQ(answer.error, "");
  const hasp::TriangleMesh mesh = ThroughFile(answer.Guide());
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
  ASSERT_EQ(answer.filter->GetMadeRecipe().slots.size(), 1U);
  // Looked for in the plane of the blade itself, whatever the guide says about its slot.
  const glm::dmat3 axes = hasp::SawAxes(blade.normal, { 0, 0, 1 });
  const double width = blade.kerfMm + 2 * Plain().clearanceMm;
  const hasp::SlotFit fit = hasp::FitSlot(
    hasp::TriangleTree(mesh), { blade.point, blade.normal, axes[1], width, blade.widthMm, 0.1 });
  ASSERT_GT(fit.places, 100U);
  EXPECT_LE(std::abs(fit.offsetMm), 0.1);
  EXPECT_LE(fit.tiltDegrees, 0.5);
  EXPECT_NEAR(fit.widthMm, width, 0.05);
  EXPECT_FALSE(fit.blockedAt.has_value());
}

INSTANTIATE_TEST_SUITE_P(Seeds, GuideOfCut, testing::Range(0, 8));

TEST(GuideCuts, TheSlotIsOnTheBoneAndEndsWithItsBlade)
{
  hasp::Osteotomy blade;
  blade.point = OnBall(3, 0) - glm::dvec3(0, 0, 4);
  blade.normal = { 1, 0, 0 };
  blade.along = { 0, 1, 0 };
  blade.widthMm = 10;
  blade.depthMm = 18;
  auto recipe = Plain();
  recipe.slots = { { OnBall(-8, 0), { 1, 0, 0 }, 1, 8, 20, 10 } };
  recipe.axisSearchDeg = 10;
  Answer answer(Ball(), recipe, { blade });
  ASSERT_EQ(answer.error, "");
  const hasp::GuideRecipe& made = answer.filter->GetMadeRecipe();
  EXPECT_EQ(made.axisSearchDeg, 0);
  ASSERT_EQ(made.slots.size(), 2U);
  EXPECT_EQ(made.slots[0], recipe.slots[0]);
  EXPECT_NEAR(glm::distance(made.slots[1].point, glm::dvec3(0, 0, -20)), Radius, 0.05);
  const glm::dvec3 up = hasp::SawAxes({ 1, 0, 0 }, made.withdrawal)[2];
  EXPECT_NEAR(made.slots[1].depthMm, 13, 0.3); // 4 above the middle, 9 below it
  EXPECT_NEAR(glm::dot(made.slots[1].point - blade.point, up), 4, 0.3);
  EXPECT_EQ(hasp::ClaimsOf(made).slots.size(), 2U);
  // What was made makes the same guide again.
  Answer again(Ball(), made);
  EXPECT_EQ(again.error, "");
  EXPECT_EQ(again.Guide()->GetNumberOfPolys(), answer.Guide()->GetNumberOfPolys());
}

TEST(GuideCuts, BladesThatDoNotEnterBoneAreNamed)
{
  hasp::Osteotomy blade;
  blade.point = OnBall(0, 0) + glm::dvec3(0, 0, 20);
  blade.along = { 0, 1, 0 };
  blade.depthMm = 30;
  blade.widthMm = 10;
  const auto refusal = [](const hasp::Osteotomy& cut)
  {
    Answer answer(Ball(), Plain(), { cut });
    EXPECT_EQ(answer.Guide()->GetNumberOfPolys(), 0);
    return answer.error;
  };
  EXPECT_NE(refusal(blade).find("slots[0], of a planned cut: its blade does not enter bone"),
    std::string::npos);
  blade.point.z -= 50; // all of it inside
  EXPECT_NE(refusal(blade).find("slots[0], of a planned cut: its blade does not enter bone"),
    std::string::npos);
  blade.normal = { 0, 0, 1 };
  EXPECT_NE(refusal(blade).find("slots[0], of a planned cut: the cosine"), std::string::npos);
  blade = {};
  blade.point = OnBall(0, 30);
  blade.along = { 0, 1, 0 };
  blade.widthMm = 10;
  EXPECT_NE(refusal(blade).find("slots[0] does not meet the guide"), std::string::npos);
}

} // namespace
