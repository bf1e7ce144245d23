#include "ExampleRun.h"

#include "Grid/Phantom.h"

#include <fstream>

namespace
{

class CutFragments : public ExampleTest
{
protected:
  /// A coarse fibula, and a blade through its shaft.
  void WriteLegAndRecipe() const
  {
    hasp::PhantomSettings settings;
    settings.anatomy = hasp::PhantomAnatomy::Fibula;
    const hasp::GridGeometry grid = hasp::PhantomGrid({ 1.2, 1.2, 3.0 }, settings);
    this->Write("leg.mha", grid, hasp::SamplePhantom(grid, settings));
    std::ofstream recipe(this->Path("cuts.json"));
    recipe << R"({ "format": "hasp-cut-recipe-1", "isovalue": 226, "spacingMm": 1.2,
      "ignoreBelowMm3": 100, "crumbBelowMm3": 20, "resected": [], "cuts": [
      { "point": [0, -5, 20], "normal": [0, 0, 1], "along": [1, 0, 0], "widthMm": 40,
        "depthMm": 40, "kerfMm": 2, "reachMm": 8 }] })";
  }
};

TEST_F(CutFragments, WrongInputIsAFailureAndLeavesNoFile)
{
  EXPECT_EQ(this->Run("CutFragments"), 1);
  this->WriteLegAndRecipe();
  EXPECT_EQ(this->Run("CutFragments leg.mha no.json parts.ply"), 1);
  EXPECT_NE(this->said.find("the file is not there"), std::string::npos) << this->said;
  EXPECT_EQ(this->Run("CutFragments no.mha cuts.json parts.ply"), 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("parts.ply")));
}

TEST_F(CutFragments, SaysHowLargeTheFragmentsAre)
{
  this->WriteLegAndRecipe();
  ASSERT_EQ(this->Run("CutFragments leg.mha cuts.json parts.ply"), 0) << this->said;
  EXPECT_NE(this->said.find("fragment 2: "), std::string::npos) << this->said;
  EXPECT_EQ(this->said.find("fragment 3: "), std::string::npos) << this->said;
  EXPECT_TRUE(std::filesystem::exists(this->Path("parts.ply")));
}

} // namespace
