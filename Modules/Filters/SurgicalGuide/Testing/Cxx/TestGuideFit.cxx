#include "Evaluation/GuideGap.h"
#include "Grid/Trilinear.h"
#include "GuideBuilder.h"
#include "GuideFixture.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <variant>

using namespace guidetest;

namespace
{

class GuideFilterOnGrids : public testing::TestWithParam<std::tuple<glm::dvec3, double>>
{
};

TEST_P(GuideFilterOnGrids, KeepsTheGapAskedFor)
{
  const auto [spacing, angle] = GetParam();
  const auto ct = ScanOf(Skull(), spacing, angle);
  const auto recipe = Band();
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.Guide());
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
  EXPECT_EQ(int(check.points) - int(check.triangles / 2), 2 - 2 * 3); // a slot and two holes
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U);
#endif
  hasp::GuideGapSettings settings;
  settings.gapMm = recipe.gapMm;
  const auto gap = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings);
  EXPECT_GT(gap.innerWallMm2, 100);
  EXPECT_GE(gap.share, 0.95); // the bar
  EXPECT_GT(gap.p5, recipe.gapMm - 0.05);
  EXPECT_LT(gap.p50, recipe.gapMm + 0.05);
  EXPECT_GT(gap.leastAnywhere, recipe.gapMm - 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scans, GuideFilterOnGrids,
  testing::Values(std::make_tuple(glm::dvec3(1), 0.0),
    std::make_tuple(glm::dvec3(0.957, 0.957, 1.5), 0.6),
    std::make_tuple(glm::dvec3(0.6, 0.6, 3), 0.3)));

TEST(GuideFilter, KeepsItsDistanceToTheClosedFormSphere)
{
  // Against the sphere itself, not its trilinear surface: that lies up to h^2 / (8 R) (1/R + 1/R),
  // 0.01 mm, inside.
  const auto sphere = hasp::AnalyticSphere({}, 25);
  const auto ct = ScanOf(sphere, glm::dvec3(1), 0.4);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.holes.clear();
  for (auto& p : recipe.landmarks)
    p = 25.0 * glm::normalize(p);
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  double inner = 0, outer = 0, innerArea = 0, outerArea = 0;
  const auto mesh = hasp::MakeTriangleMesh(answer.Guide());
  for (const auto& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const glm::dvec3 n = glm::cross(b - a, c - a), middle = (a + b + c) / 3.0;
    const double facing = glm::dot(glm::normalize(n), glm::normalize(middle));
    const double area = 0.5 * glm::length(n), d = glm::length(middle) - 25;
    EXPECT_GT(d, recipe.gapMm - 0.05);
    EXPECT_LT(d, recipe.gapMm + recipe.thicknessMm + 0.05);
    (facing < -0.98 ? inner : outer) += facing < -0.98 || facing > 0.98 ? area * d : 0;
    (facing < -0.98 ? innerArea : outerArea) += std::abs(facing) > 0.98 ? area : 0;
  }
  EXPECT_NEAR(inner / innerArea, recipe.gapMm, 0.02);
  EXPECT_NEAR(outer / outerArea, recipe.gapMm + recipe.thicknessMm, 0.04);
}

TEST(GuideFilter, LiftsOffAlongTheWithdrawalDirection)
{
  // Around a sphere's side the bone is undercut: below the equator nothing may remain.
  const auto ct = ScanOf(hasp::AnalyticSphere({}, 20), glm::dvec3(1.5), 0.2);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.holes.clear();
  recipe.landmarks = { { 20, 0, 0 }, { 0, 20, 0 } };
  recipe.landmarks.insert(recipe.landmarks.begin() + 1, 20.0 * glm::normalize(glm::dvec3(1, 1, 0)));
  recipe.widthMm = 16;
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  double deepest = 0, highest = 0;
  for (const auto& p : hasp::MakeTriangleMesh(answer.Guide()).points)
  {
    const double fromAxis = std::hypot(p.x, p.y);
    deepest = std::min(deepest, p.z);
    highest = std::max(highest, p.z);
    if (p.z < 0) // outside the shadow of the sphere and its gap
    {
      EXPECT_GT(fromAxis, 20 + recipe.gapMm - 0.1);
    }
  }
  EXPECT_LT(deepest, -2); // the tube reaches below the equator, beside the shadow
  EXPECT_GT(highest, 5);
}

TEST(GuideFilter, EveryOutlineMakesOnePiece)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1.5), 0.2);
  auto recipe = Band();
  recipe.slots.clear();
  recipe.landmarks = { OnSkull(-9, -8), OnSkull(9, -8), OnSkull(9, 8), OnSkull(-9, 8) };
  recipe.holes = { { OnSkull(9, 8), { 0, 0, 1 }, 2, 500, 0 } };
  recipe.widthMm = 8;
  recipe.spacingMm = 0.6;
  const std::pair<hasp::GuideOutline, int> outlines[] = { { hasp::GuideOutline::Open, 1 },
    { hasp::GuideOutline::Closed, 2 }, { hasp::GuideOutline::Filled, 1 } };
  for (const auto& [outline, handles] : outlines)
  {
    recipe.outline = outline;
    Answer answer(ct, recipe);
    ASSERT_EQ(answer.error, "");
    const auto check = hasp::CheckMesh(hasp::MakeTriangleMesh(answer.Guide()));
    EXPECT_TRUE(check.Sound());
    EXPECT_EQ(int(check.points) - int(check.triangles / 2), 2 - 2 * handles);
  }
}

TEST(GuideFilter, AGapOfZeroTouchesAndNoMore)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1), 0.2);
  auto recipe = Band();
  recipe.gapMm = 0;
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  const auto mesh = ThroughFile(answer.Guide());
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound());
  hasp::GuideGapSettings settings;
  settings.gapMm = 0;
  const auto gap = hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings);
  EXPECT_GE(gap.share, 0.95);
  EXPECT_GT(gap.least, -0.05);
}

TEST(GuideFilter, APreviewIsTheSameSurface)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1), 0.2);
  Answer answer(ct, Band());
  ASSERT_EQ(answer.error, "");
  const double spacing = 0.8;
  const auto preview = answer.filter->MakePreview(spacing);
  ASSERT_TRUE(preview);
  // Points of the mesh lie where the preview's trilinear field is 0, within half a voxel: on
  // edges, too, which it rounds.
  const hasp::AnyGridView view = hasp::ViewImage(preview);
  const auto& field = std::get<hasp::GridView<const float>>(view);
  const auto mesh = hasp::MakeTriangleMesh(answer.Guide());
  double most = 0;
  for (const auto& p : mesh.points)
  {
    const auto value = hasp::SampleTrilinear(field, field.geometry.WorldToIndex(p));
    ASSERT_TRUE(value.has_value());
    most = std::max(most, std::abs(double(*value)));
  }
  EXPECT_LE(most, 0.5 * spacing);
  // And there is nothing else: what is inside is as large.
  double volume = 0;
  for (const float value : std::span(field.data, field.geometry.Size()))
    volume += std::clamp(0.5 + value / spacing, 0.0, 1.0) * spacing * spacing * spacing;
  EXPECT_NEAR(volume, hasp::CheckMesh(mesh).volumeMm3, 0.05 * volume);
  // What Update made is still there.
  EXPECT_GT(answer.Guide()->GetNumberOfPolys(), 0);
  EXPECT_EQ(answer.error, "");
  EXPECT_FALSE(answer.filter->MakePreview(0.1));
  EXPECT_NE(answer.error.find("preview's spacing"), std::string::npos);
}

TEST(GuideFilter, APreviewIsMadeOnACoarserGridAndRefusedInTheGuidesWords)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(1), 0.2);
  const auto view = hasp::ViewImage(ct);
  auto recipe = Band(); // spacingMm 0.5, and a slot of 1.2 mm, which has two cells at least
  const double made = hasp::MakePreviewSolid(view, recipe, {}, 0.8).grid.spacing.x;
  EXPECT_GT(made, 0.5);
  EXPECT_LE(made, 0.6);
  EXPECT_EQ(hasp::MakePreviewSolid(view, recipe, {}, 0.5).grid.spacing.x, 0.5);

  recipe.landmarks[1] += glm::dvec3(0, 0, 4.37); // how far off it is found depends on the grid
  Answer answer(ct, recipe);
  std::string words = answer.error.substr(answer.error.find("guide: landmarks[1]"));
  words.resize(words.find('\n'));
  answer.error.clear();
  EXPECT_FALSE(answer.filter->MakePreview(0.8));
  EXPECT_NE(answer.error.find(words), std::string::npos) << answer.error << words;
}

} // namespace
