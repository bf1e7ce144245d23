// What a plate promises, measured on plates of a scan as they come back from a file.
#include "Evaluation/FitCertificate.h"
#include "GuideFixture.h"
#include "Planning/PlateRecipe.h"
#include "PlateBuilder.h"
#include "PlateClaims.h"

#include <string>

using namespace guidetest;

namespace
{

hasp::PlateRecipe OnScan()
{
  hasp::PlateRecipe r;
  r.landmarks = { OnSkull(-14, 3), OnSkull(0, -2), OnSkull(14, 4) };
  r.screws = { { OnSkull(-11, 1.6) }, { OnSkull(0, -2) }, { OnSkull(11, 2.5) } };
  r.screws[2].axis = glm::normalize(glm::dvec3(0.45, 0.1, 1)); // leans by some degrees
  r.spacingMm = 0.7;
  return r;
}

class PlateClaims : public testing::Test
{
protected:
  vtkSmartPointer<vtkImageData> ct = ScanOf(Skull(), glm::dvec3(1.0), 0.3);

  hasp::TriangleMesh Make(const hasp::PlateRecipe& recipe) const
  {
    const auto built = hasp::BuildPlate({ hasp::ViewImage(this->ct) }, recipe);
    return ThroughFile(hasp::MakePolyData(built.mesh));
  }
  /// What a plate is told that is held to another recipe, without what CGAL finds.
  std::string Faults(const hasp::TriangleMesh& mesh, const hasp::PlateRecipe& promised) const
  {
    const auto scan = hasp::ViewImage(this->ct);
    const auto claims = hasp::ClaimsOf(promised, hasp::FindScrewAxes(scan, promised));
    std::string text;
    for (const auto& fault : hasp::CertifyFit(mesh, scan, claims,
           [](const hasp::TriangleMesh&) {
             return std::vector<std::array<std::uint32_t, 2>>();
           }).faults)
      text += fault.text + "\n";
    return text;
  }
};

TEST_F(PlateClaims, APlateKeepsWhatItsRecipePromisesAndNothingElse)
{
  const auto recipe = OnScan();
  const auto mesh = this->Make(recipe);
  EXPECT_EQ(this->Faults(mesh, recipe), "");
  const auto held = [&](auto change)
  {
    auto other = recipe;
    change(other);
    return this->Faults(mesh, other);
  };
  const auto names = [](const std::string& faults, const char* words)
  { EXPECT_NE(faults.find(words), std::string::npos) << words << " is not in: " << faults; };
  names(held([](auto& r) { r.gapMm = 0.7; }), "of the gap of 0.70");
  names(held([](auto& r) { r.thicknessMm = 4.5; }), "the shell is 2.");
  names(held([](auto& r) { r.screws[1].diameterMm = 2.7; }), "must have 2.70 within 0.10");
  names(held([](auto& r) { r.screws[0].point.y += 0.3; }), "screws[0] lies 0.3");
  names(held(
          [](auto& r) {
            r.screws.push_back({ OnSkull(5.5, 0.1), {}, 1.5, 1.5 });
          }),
    "screws[3] is blocked");
}

TEST_F(PlateClaims, WhatAScanCannotTellIsNotClaimed)
{
  auto recipe = OnScan();
  const auto axes = hasp::FindScrewAxes(hasp::ViewImage(this->ct), recipe);
  ASSERT_EQ(axes.size(), 3U);
  EXPECT_EQ(hasp::ClaimsOf(recipe, axes).holes.size(), 3U);
  EXPECT_THROW(hasp::ClaimsOf(recipe, { axes.data(), 2 }), std::invalid_argument);
  // A bore of 0.4 mm below its cone.
  recipe.screws[1].headDepthMm = 1.3;
  const auto claims = hasp::ClaimsOf(recipe, axes);
  ASSERT_EQ(claims.holes.size(), 2U);
  EXPECT_EQ(claims.holes[1].name, "screws[2]");
  // Bone that is moved is in no scan: no gap, but walls, and the bores.
  recipe.fragments = { { 1 } };
  const auto moved = hasp::ClaimsOf(recipe, axes);
  EXPECT_FALSE(moved.shell);
  ASSERT_EQ(moved.holes.size(), 2U);
  EXPECT_EQ(moved.holes[1].name, "screws[2]");
  EXPECT_EQ(moved.leastWallMm, claims.leastWallMm);
  EXPECT_THROW(hasp::FindScrewAxes(hasp::ViewImage(this->ct), recipe), std::invalid_argument);
}

} // namespace
