// Recipes and scans at the edge of what is allowed: a sound guide, or an error that says why not.
#include "Evaluation/GuideGap.h"
#include "GuideFixture.h"

#include <functional>

using namespace guidetest;

namespace
{

/// Of a closed mesh of one piece: 0 for a ball, 1 for a ring, and so on.
int Handles(const hasp::MeshCheck& check)
{
  return 1 - (int(check.points) - int(check.triangles / 2)) / 2;
}

hasp::MeshCheck CheckGuide(vtkImageData* ct, const hasp::GuideRecipe& recipe)
{
  Answer answer(ct, recipe);
  EXPECT_EQ(answer.error, "");
  return hasp::CheckMesh(ThroughFile(answer.Guide()));
}

TEST(GuideEdges, AFilledOutlineCoversBoneFarAboveItsLandmarks)
{
  // A long dome, landmarks around its foot: a cap without a hole, up to the very top.
  const glm::dvec3 r(14, 14, 34);
  const auto ct =
    ScanOf({ "dome", [r](const glm::dvec3& p) { return 14.0 * (1.0 - glm::length(p / r)); }, 1 },
      glm::dvec3(1.5), 0.1);
  auto recipe = Band();
  recipe.outline = hasp::GuideOutline::Filled;
  recipe.slots.clear();
  recipe.holes.clear();
  recipe.landmarks.clear();
  const double foot = 14.0 * std::sqrt(1.0 - 4.0 / (34.0 * 34.0));
  for (int n = 0; n < 6; ++n)
    recipe.landmarks.push_back({ foot * std::cos(1.05 * n), foot * std::sin(1.05 * n), 2 });
  recipe.widthMm = 6;
  recipe.spacingMm = 0.9;
  Answer answer(ct, recipe);
  ASSERT_EQ(answer.error, "");
  const auto mesh = hasp::MakeTriangleMesh(answer.Guide());
  const auto check = hasp::CheckMesh(mesh);
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(Handles(check), 0);
  double highest = 0;
  for (const auto& p : mesh.points)
    highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, 34 + recipe.gapMm + recipe.thicknessMm, 0.3); // the scan rounds the top off
}

TEST(GuideEdges, DirectionsNeedNotBeUnitToTheLastDigit)
{
  const auto ct = ScanOf(Skull(), glm::dvec3(2), 0);
  auto recipe = Band();
  recipe.spacingMm = 0.6;
  const auto exact = CheckGuide(ct, recipe);
  recipe.withdrawal *= 0.9991;
  recipe.slots[0].normal *= 1.0009;
  for (auto& hole : recipe.holes)
  {
    hole.axis *= 1.0009;
    hole.point.z += 400; // on the axis, as far away as a planner may put it
  }
  const auto rounded = CheckGuide(ct, recipe);
  EXPECT_EQ(Handles(exact), 3);
  EXPECT_EQ(Handles(rounded), 3);
  EXPECT_NEAR(rounded.volumeMm3, exact.volumeMm3, 1e-3); // the same holes, up to rounding
}

TEST(GuideEdges, MirroredAndStretchedScans)
{
  for (const glm::dvec3& spacing : { glm::dvec3(1.5), glm::dvec3(0.4, 4.0, 1.5) }) // 1 : 10
  {
    hasp::GridGeometry grid;
    grid.dims = glm::ivec3(glm::ceil(glm::dvec3(76) / spacing)) + 1;
    grid.spacing = spacing;
    grid.direction = glm::dmat3({ 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }); // determinant -1
    grid.origin = -(grid.direction * (0.5 * spacing * glm::dvec3(grid.Cells())));
    const auto ct =
      hasp::MakeImage(grid, hasp::SampleAnalytic<std::int16_t>(Skull(), grid, 200, 226));
    auto recipe = Band();
    recipe.spacingMm = 0.6;
    Answer answer(ct, recipe);
    ASSERT_EQ(answer.error, "");
    const auto mesh = ThroughFile(answer.Guide());
    const auto check = hasp::CheckMesh(mesh);
    EXPECT_TRUE(check.Sound()); // outward, too
    EXPECT_EQ(Handles(check), 3);
    hasp::GuideGapSettings settings;
    settings.gapMm = recipe.gapMm;
    EXPECT_GE(hasp::MeasureGuideGap(hasp::ViewImage(ct), mesh, settings).share, 0.95);
  }
}

using Change = std::function<void(hasp::GuideRecipe&)>;
class GuideOddities : public testing::TestWithParam<Change>
{
};

TEST_P(GuideOddities, AreSoundOrNamed)
{
  static const auto ct = ScanOf(Skull(), glm::dvec3(2), 0.3);
  auto recipe = Band();
  recipe.spacingMm = 0.6;
  GetParam()(recipe);
  Answer answer(ct, recipe);
  EXPECT_NE(answer.error.empty(), answer.Guide()->GetNumberOfPolys() == 0);
  if (!answer.error.empty())
    return;
  const auto check = hasp::CheckMesh(ThroughFile(answer.Guide()));
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1U);
}

using R = hasp::GuideRecipe;
INSTANTIATE_TEST_SUITE_P(Recipes, GuideOddities,
  testing::Values([](R& r) { r.slots.push_back(r.slots[0]); },             // the same slot twice
    [](R& r) { r.holes[0].point = r.slots[0].point; },                     // a hole in the slot
    [](R& r) { r.holes[0].diameterMm = 20; },                              // wider than the band
    [](R& r) { r.slots[0].kerfMm = 20; },                                  // as wide
    [](R& r) { r.slots[0].normal = glm::normalize(glm::dvec3(0, 1, 2)); }, // steep: cosine 0.894
    [](R& r) {
      r.holes[0].axis = { 1, 0, 0 };
    },                                                                   // across the guide
    [](R& r) { r.withdrawal = glm::normalize(glm::dvec3(1, 0, 0.05)); }, // along the surface
    [](R& r) { r.gapMm = 0; }, [](R& r) { r.gapMm = 9; },
    [](R& r) { r.thicknessMm = 1.2; }, // two spacings
    [](R& r) { r.thicknessMm = 15; }, [](R& r) { r.widthMm = 30; },
    [](R& r) { r.ignoreBelowMm3 = 1e6; },                  // no bone is that large
    [](R& r) { r.landmarks.push_back(r.landmarks[0]); })); // back to the start

TEST(GuideEdges, AtTheBorderOfTheScan)
{
  // The scan ends at the skull's middle: the landmark in the last slice counts, one beyond does
  // not.
  hasp::GridGeometry grid{ { 40, 61, 40 }, { 0, -30, -10 }, glm::dvec3(1), glm::dmat3(1) };
  const auto ct =
    hasp::MakeImage(grid, hasp::SampleAnalytic<std::int16_t>(Skull(), grid, 200, 226));
  auto recipe = Band();
  recipe.spacingMm = 0.6;
  recipe.slots.clear();
  recipe.holes.clear();
  recipe.landmarks = { OnSkull(0, 0), OnSkull(9, 0) };
  EXPECT_TRUE(CheckGuide(ct, recipe).Sound());
  recipe.landmarks[0].x = -0.01;
  Answer answer(ct, recipe);
  EXPECT_NE(answer.error.find("outside the volume"), std::string::npos) << answer.error;
}

} // namespace
