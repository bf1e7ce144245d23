#include "CutFixture.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace cuttest;

namespace
{

hasp::CutBone Cut(const BoneScan& scan, const hasp::CutRecipe& recipe)
{
  return hasp::CutFragments({ scan.View(), {}, 1 }, recipe);
}

/// The error's text; empty if there is none.
std::string Fault(const BoneScan& scan, const hasp::CutRecipe& recipe)
{
  try
  {
    Cut(scan, recipe);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

/// As an STL file keeps it.
void ExpectPrintable(const hasp::BoneFragment& fragment)
{
  hasp::TriangleMesh mesh = fragment.mesh;
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  mesh = hasp::WeldPoints(mesh);
  EXPECT_TRUE(hasp::CheckMesh(mesh).Sound()) << fragment.number;
#if HASP_WITH_CGAL
  EXPECT_EQ(hasp::CountSelfIntersections(mesh), 0U) << fragment.number;
#endif
}

constexpr double BarSection = 36.0 * glm::pi<double>();
constexpr double Conserved = 1e-3; // the promise

// Nothing first.

TEST(FragmentCutter, RefusesWhatCannotBeCutByName)
{
  const BoneScan scan = ScanOfBar();
  const auto with = [](auto change)
  {
    hasp::CutRecipe recipe = OneCut({});
    change(recipe);
    return recipe;
  };
  const auto expect = [&](const hasp::CutRecipe& recipe, const char* text)
  {
    const std::string fault = Fault(scan, recipe);
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  };
  expect(with([](auto& r) { r.cuts.clear(); }), "the number of cuts is 0");
  expect(with([](auto& r) { r.cuts[0].blade.kerfMm = 0.1; }), "cuts[0].kerfMm is 0.1");
  expect(with([](auto& r) { r.cuts[0].blade.normal = { 1, 1, 0 }; }), "cuts[0]: normal");
  expect(with([](auto& r) { r.cuts[0].reachMm = std::nan(""); }), "cuts[0].reachMm is nan");
  expect(with([](auto& r) { r.cuts[0].blade.point = { 0, 60, 0 }; }), "cuts[0] does not meet bone");
  expect(with([](auto& r) { r.cuts.push_back(r.cuts[0]); }), "cuts[1] does not meet bone");
  expect(with(
           [](auto& r) {
             r.resected = { { 0, 0, 12 } };
           }),
    "resected[0] is"); // 6 mm from the bar
  double share = 0.0;
  const hasp::CutRecipe far = with([](auto& r) { r.resected = { { 0, 0, 0 }, { 0, 300, 0 } }; });
  try
  {
    hasp::CutFragments({ scan.View(), {}, 1 }, far,
      [&](double done)
      {
        share = done;
        return true;
      });
    ADD_FAILURE() << "not refused";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("resected[1] is over 2"), std::string::npos);
  }
  EXPECT_LE(share, 0.1); // before bone is measured
  expect(with([](auto& r) { r.isovalue = 20000; }), "does not meet bone");
  const std::vector<std::uint8_t> few(8);
  EXPECT_THROW(hasp::CutFragments({ scan.View(),
                                    hasp::GridView<const std::uint8_t>{ few.data(),
                                      { { 2, 2, 2 }, {}, glm::dvec3(1), glm::dmat3(1) } },
                                    1 },
                 OneCut({})),
    std::invalid_argument);
  EXPECT_THROW(hasp::CutFragments({ scan.View(), {}, 1 }, OneCut({}), [](double) { return false; }),
    hasp::Cancelled);
}

TEST(FragmentCutter, ABarIsPartedIntoWhatItsClosedFormSays)
{
  const BoneScan scan = ScanOf(BarDistance, { 34, 16, 14 }, glm::dvec3(0.4));
  hasp::CutRecipe recipe = OneCut({ 5.0, 0.0, 0.0 });
  recipe.spacingMm = 0.3;
  const hasp::CutBone cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 2U);
  const double ends = BarSection * 4.0; // half a ball of radius 6 is as long as 4 mm of bar
  // Trilinear between samples of 0.4 mm and chords of up to 0.5 mm on a radius of 6 mm: h^2 / (8 R)
  // each, at most 0.009 mm of 6 mm, which is 0.3 % of a section.
  EXPECT_NEAR(cut.fragments[0].volumeMm3 / (BarSection * 24.5 + ends), 1.0, 4e-3);
  EXPECT_NEAR(cut.fragments[1].volumeMm3 / (BarSection * 14.5 + ends), 1.0, 4e-3);
  EXPECT_NEAR(cut.cuts[0].kerfMm3 / BarSection, 1.0, 4e-3);
  EXPECT_NEAR(cut.cuts[0].areaMm2 / BarSection, 1.0, 4e-3);
  EXPECT_TRUE(cut.cuts[0].parted);
  EXPECT_EQ(cut.cuts[0].front, std::vector<int>{ 2 });
  EXPECT_EQ(cut.cuts[0].back, std::vector<int>{ 1 });
  EXPECT_EQ(cut.cuts[0].frontMm3, cut.fragments[1].volumeMm3);
  EXPECT_EQ(cut.cuts[0].backMm3, cut.fragments[0].volumeMm3);
  EXPECT_EQ(cut.cuts[0].leftMm2, 0.0);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
  EXPECT_LT(cut.fragments[0].center.x, -5.0);
  for (const hasp::BoneFragment& fragment : cut.fragments)
  {
    ExpectPrintable(fragment);
    EXPECT_FALSE(fragment.crumb || fragment.resected);
    // The face is where the blade's is, plane to the contour's last digits.
    const double face = fragment.number == 1 ? 4.5 : 5.5;
    double nearest = 1e30;
    for (const glm::dvec3& p : fragment.mesh.points)
      nearest = std::min(nearest, (p.x - face) * (fragment.number == 1 ? -1.0 : 1.0));
    EXPECT_NEAR(nearest, 0.0, 0.01);
  }
}

/// A pin of radius 2.5, 12 mm and its round ends: thin kerfs ask for fine grids.
double PinDistance(const glm::dvec3& p)
{
  return glm::length(p - glm::dvec3(std::clamp(p.x, -6.0, 6.0), 0, 0)) - 2.5;
}
constexpr double PinSection = 6.25 * glm::pi<double>();

TEST(FragmentCutter, KerfsFromThinToThickPartBoneWhicheverWayTheyLie)
{
  const BoneScan scan = ScanOf(PinDistance, { 13, 8, 7 }, glm::dvec3(0.4));
  for (const double kerf : { 0.3, 0.8, 3.0 })
    for (const glm::dvec3& normal : { glm::dvec3(1, 0, 0), glm::normalize(glm::dvec3(1, 1, 1)) })
    {
      hasp::CutRecipe recipe = OneCut({ -1.0, 0.4, 0.2 }, kerf);
      recipe.spacingMm = 0.3;
      recipe.cuts[0].blade.normal = normal;
      recipe.cuts[0].blade.along = glm::normalize(glm::cross(normal, glm::dvec3(0, 0.6, 0.8)));
      const hasp::CutBone cut = Cut(scan, recipe);
      EXPECT_EQ(cut.fragments.size(), 2U) << kerf;
      EXPECT_TRUE(cut.cuts[0].parted) << kerf;
      EXPECT_LE(cut.UnaccountedShare(), Conserved) << kerf;
      // Chords of 0.3 sqrt(3) mm on 2.5 mm: 0.013 mm at most, 1 % of a section.
      EXPECT_NEAR(cut.cuts[0].areaMm2 * normal.x / PinSection, 1.0, 0.01) << kerf;
    }
}

TEST(FragmentCutter, ABladeThatIsTooShortLeavesOnePieceAndSaysSo)
{
  const BoneScan scan = ScanOfBar();
  hasp::CutRecipe recipe = OneCut({ 0.0, 0.0, 4.0 });
  recipe.cuts[0].blade.depthMm = 8.0; // reaches z = 0: along is y, so across is z
  const hasp::CutBone cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 1U);
  EXPECT_FALSE(cut.cuts[0].parted);
  EXPECT_EQ(cut.cuts[0].frontMm3, 0.0);
  EXPECT_EQ(cut.cuts[0].front, cut.cuts[0].back);
  EXPECT_NEAR(cut.cuts[0].areaMm2 / (0.5 * BarSection), 1.0, 0.02);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
  ExpectPrintable(cut.fragments[0]);
}

/// A ring as round as a jaw: radius 20, 4 mm thick.
double RingDistance(const glm::dvec3& p)
{
  return std::hypot(std::hypot(p.x, p.y) - 20.0, p.z) - 4.0;
}

TEST(FragmentCutter, TheFarSideStaysWholeUnlessItIsWithinReach)
{
  const BoneScan scan = ScanOf(RingDistance, { 30, 30, 18 }, glm::dvec3(0.8));
  const double section = 16.0 * glm::pi<double>();
  hasp::CutRecipe recipe;
  recipe.cuts = { { { { 20, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, 120.0, 40.0, 1.0 }, 8.0 } };
  hasp::CutBone cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 1U);
  EXPECT_FALSE(cut.cuts[0].parted);
  EXPECT_NEAR(cut.cuts[0].leftMm2 / section, 1.0, 0.05); // samples of 0.25 mm
  EXPECT_NEAR(cut.cuts[0].areaMm2 / section, 1.0, 0.02);
  // The far side is as it was: no point of the mesh is off the ring there.
  for (const glm::dvec3& p : cut.fragments[0].mesh.points)
    if (p.x < 0.0)
    {
      EXPECT_LT(std::abs(RingDistance(p)), 0.1) << p.x << " " << p.y << " " << p.z;
    }
  recipe.cuts[0].reachMm = 200.0;
  cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 2U);
  EXPECT_TRUE(cut.cuts[0].parted);
  EXPECT_EQ(cut.cuts[0].leftMm2, 0.0);
  EXPECT_NEAR(cut.cuts[0].areaMm2 / section, 2.0, 0.04);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
}

TEST(FragmentCutter, ABladeThatReachesIntoAnotherFragmentLeavesThatOneWhole)
{
  const BoneScan scan = ScanOf(PinDistance, { 13, 8, 7 }, glm::dvec3(0.4));
  for (const double kerf : { 0.3, 1.0 })
  {
    const hasp::CutRecipe one = OneCut({ 0.0, 0.0, 0.0 }, kerf);
    const hasp::CutBone first = Cut(scan, one);
    hasp::CutRecipe two = one; // along the pin, its middle in the front half
    two.cuts.push_back({ { { 3, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, 80.0, 40.0, 1.0 }, 100.0 });
    const hasp::CutBone cut = Cut(scan, two);
    ASSERT_EQ(cut.fragments.size(), 3U) << kerf;
    EXPECT_TRUE(cut.cuts[0].parted && cut.cuts[1].parted) << kerf;
    EXPECT_GT(cut.cuts[1].leftMm2, 30.0); // 5 mm x 7 mm of the back half, and its round end
    EXPECT_NEAR(cut.fragments[0].volumeMm3, first.cuts[0].backMm3, 1e-3 * first.boneMm3) << kerf;
    EXPECT_LT(cut.fragments[0].center.x, 0.0);
    EXPECT_NEAR(cut.cuts[0].frontMm3, first.cuts[0].frontMm3, 1e-3 * first.boneMm3)
      << "as it was before the second cut";
    EXPECT_LE(cut.UnaccountedShare(), Conserved) << kerf;
    for (const hasp::BoneFragment& fragment : cut.fragments)
      ExpectPrintable(fragment);
  }
}

TEST(FragmentCutter, AKerfBesideAnotherTakesNothingFromBeyondIt)
{
  // The second kerf reaches from -1 to 3 mm, over the first one's (+-0.5 mm) and into the back.
  const BoneScan scan = ScanOfBar();
  hasp::CutRecipe recipe = OneCut({ 0.0, 0.0, 0.0 });
  const double back = Cut(scan, recipe).cuts[0].backMm3;
  recipe.cuts.push_back({ { { 1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 30.0, 30.0, 4.0 }, 8.0 });
  const hasp::CutBone cut = Cut(scan, recipe);
  EXPECT_NEAR(cut.cuts[0].backMm3, back, 1e-3 * cut.boneMm3);
  EXPECT_NEAR(cut.cuts[1].kerfMm3 / BarSection, 2.5, 0.03);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
}

TEST(FragmentCutter, OtherIslandsAreNotLookedAt)
{
  // Two bars 3 mm apart; the blade reaches both.
  const auto two = [](const glm::dvec3& p)
  { return std::min(BarDistance(p), BarDistance(p - glm::dvec3(0, 15, 0))); };
  const BoneScan scan = ScanOf(two, { 34, 30, 16 });
  hasp::CutRecipe recipe = OneCut({ 3.0, 0.0, 0.0 });
  recipe.cuts[0].blade.widthMm = 60.0;
  const hasp::CutBone cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 2U);
  for (const hasp::BoneFragment& fragment : cut.fragments)
    EXPECT_LT(fragment.center.y, 1.0);
  recipe.cuts.push_back(recipe.cuts[0]);
  recipe.cuts[1].blade.point.y = 15.0;
  const hasp::CutBone both = Cut(scan, recipe);
  ASSERT_EQ(both.fragments.size(), 4U);
  EXPECT_NEAR(both.cuts[0].kerfMm3, cut.cuts[0].kerfMm3, 0.01 * cut.cuts[0].kerfMm3);
  EXPECT_NEAR(both.cuts[0].leftMm2 / BarSection, 1.0, 0.05) << "the other bar";
}

TEST(FragmentCutter, AHollowStaysWithTheBoneAroundIt)
{
  // A canal that ends within the bar: a second surface inside the first.
  const auto hollow = [](const glm::dvec3& p)
  {
    const double canal = glm::length(p - glm::dvec3(std::clamp(p.x, -15.0, -5.0), 0, 0)) - 3.0;
    return std::max(BarDistance(p), -canal);
  };
  const BoneScan scan = ScanOf(hollow, { 34, 16, 14 });
  const hasp::CutBone cut = Cut(scan, OneCut({ 10.0, 0.0, 0.0 }));
  ASSERT_EQ(cut.fragments.size(), 2U);
  const double canal = glm::pi<double>() * (9.0 * 10.0 + 4.0 / 3.0 * 27.0);
  EXPECT_NEAR(cut.cuts[0].backMm3, BarSection * (29.5 + 4.0) - canal, 0.01 * BarSection * 33.5);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
  const hasp::CutBone opened = Cut(scan, OneCut({ -10.0, 0.0, 0.0 }));
  ASSERT_EQ(opened.fragments.size(), 2U);
  EXPECT_NEAR(opened.cuts[0].areaMm2 / (BarSection - 9.0 * glm::pi<double>()), 1.0, 0.02);
  EXPECT_LE(opened.UnaccountedShare(), Conserved);
}

TEST(FragmentCutter, CrumbsAreToldAndMarkedAndWhatIsResectedStays)
{
  const BoneScan scan = ScanOfBar();
  hasp::CutRecipe recipe = OneCut({ 25.0, 0.0, 0.0 }); // of the round end 0.5 mm is left
  recipe.resected = { { 0, 0, 0 } };
  const hasp::CutBone cut = Cut(scan, recipe);
  ASSERT_EQ(cut.fragments.size(), 2U);
  EXPECT_TRUE(cut.fragments[1].crumb);
  EXPECT_FALSE(cut.fragments[0].crumb);
  const double cap = glm::pi<double>() * 0.25 * (3.0 * 6.0 - 0.5) / 3.0; // h^2 (3 r - h) / 3
  EXPECT_NEAR(cut.fragments[1].volumeMm3, cap, 0.15 * cap);
  EXPECT_TRUE(cut.fragments[0].resected);
  EXPECT_FALSE(cut.fragments[1].resected);
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
  recipe.resected = { { 24.4, 5.0, 0 } }; // beside both: 0.9 mm from the bar, 2.8 mm from the crumb
  const hasp::CutBone beside = Cut(scan, recipe);
  EXPECT_TRUE(beside.fragments[0].resected);
  EXPECT_FALSE(beside.fragments[1].resected);
}

TEST(FragmentCutter, LabelsSayWhoseBoneIsCutAndWhoseEachVoxelIs)
{
  const BoneScan scan = ScanOfBar();
  std::vector<std::uint8_t> labels(scan.samples.size());
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    const glm::ivec3 d = scan.grid.dims;
    labels[n] =
      scan.grid.IndexToWorld(glm::dvec3(n % d.x, n / d.x % d.y, n / d.x / d.y)).x < 12.0 ? 3 : 4;
  }
  const hasp::AnyGridView mask = hasp::GridView<const std::uint8_t>{ labels.data(), scan.grid };
  const hasp::CutBone cut = hasp::CutFragments({ scan.View(), mask, 3 }, OneCut({}));
  ASSERT_EQ(cut.fragments.size(), 2U);
  // Half a voxel of its 0.6 to 0.8 mm at the label's end.
  EXPECT_NEAR(cut.boneMm3, BarSection * (4.0 + 20.0 + 12.0), BarSection * 0.5);
  const std::vector<std::uint16_t> numbers = hasp::LabelFragments(cut.fragments, scan.grid);
  std::vector<double> volume(3, 0.0);
  const double voxel = 0.6 * 0.6 * 0.8;
  for (const std::uint16_t number : numbers)
    volume.at(number) += voxel;
  for (const hasp::BoneFragment& fragment : cut.fragments)
    EXPECT_NEAR(volume[fragment.number], fragment.volumeMm3, 0.02 * fragment.volumeMm3);
}

TEST(FragmentCutter, LabelsOfAnotherGridAreRefused)
{
  const BoneScan scan = ScanOfBar();
  const std::vector<std::uint8_t> labels(scan.samples.size(), 3);
  const auto refusal = [&](const std::function<void(hasp::GridGeometry&)>& change) -> std::string
  {
    hasp::GridGeometry grid = scan.grid;
    change(grid);
    const hasp::AnyGridView mask = hasp::GridView<const std::uint8_t>{ labels.data(), grid };
    try
    {
      hasp::CutFragments({ scan.View(), mask, 3 }, OneCut({}));
      return {};
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
  };
  const auto says = [&](const char* words, const std::function<void(hasp::GridGeometry&)>& change)
  {
    const std::string text = refusal(change);
    EXPECT_NE(text.find("the labels are of another grid than the volume: "), std::string::npos);
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  says("their size is (", [](auto& grid) { grid.dims.x -= 1; });
  says("their size is (", [](auto& grid) { std::swap(grid.dims.x, grid.dims.y); });
  says("their spacing is (", [](auto& grid) { grid.spacing.z += 0.001; });
  says("their axes have other directions",
    [](auto& grid) { grid.direction = glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1); });
  says("their origin is (", [](auto& grid) { grid.origin.y += 0.6; });
  says("their origin is (", [](auto& grid) { grid.origin.y += std::nan(""); });
  EXPECT_EQ(refusal([](auto& grid) { grid.origin.y += 1e-4; }), ""); // a header's decimals
}

TEST(FragmentCutter, TheMandibleOfThePhantomIsResectedAndNothingIsLost)
{
  const hasp::HorseshoeShape arch = LowerArch(); // each blade reaches the left side, too
  const hasp::CutBone cut = Cut(ScanOfJaw(), JawCuts());
  ASSERT_EQ(cut.fragments.size(), 3U);
  EXPECT_TRUE(cut.cuts[0].parted && cut.cuts[1].parted);
  EXPECT_GT(cut.cuts[1].leftMm2, 100.0) << "the left ramus is the far side";
  // The tumour's part is between the cuts: 28.5 mm along an arch of 12 mm x 21 mm or so, with
  // teeth.
  const hasp::BoneFragment& between = cut.fragments[2];
  EXPECT_TRUE(between.resected);
  EXPECT_NEAR(between.center.x, arch.PointAt(-25.0).x, 2.0);
  EXPECT_EQ(cut.cuts[0].front, std::vector<int>{ 1 });
  EXPECT_EQ(cut.cuts[0].back, std::vector<int>{ 3 });
  EXPECT_EQ(cut.cuts[1].back, std::vector<int>{ 2 });
  std::printf("mandible %.0f mm3, not accounted for: %.2g\n", cut.boneMm3, cut.UnaccountedShare());
  EXPECT_LE(cut.UnaccountedShare(), Conserved);
}

} // namespace
