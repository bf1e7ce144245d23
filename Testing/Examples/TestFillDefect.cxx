#include "ExampleRun.h"

#include "Grid/Phantom.h"

namespace
{

class FillDefect : public ExampleTest
{
protected:
  /// The demo's recipe, and both bones in one coarse scan.
  void WriteScan() const
  {
    hasp::PhantomSettings settings;
    settings.anatomy = hasp::PhantomAnatomy::HeadAndFibula;
    hasp::GridGeometry grid;
    grid.dims = { 78, 62, 130 };
    grid.origin = { -62, -100, -195 };
    grid.spacing = { 3.0, 2.0, 3.0 };
    this->Write("both.mha", grid, hasp::SamplePhantom(grid, settings));
  }
  const std::string recipe = HASP_SOURCE "/Data/phantom-transplant.json";
};

TEST_F(FillDefect, WrongInputIsAFailureAndLeavesNoFile)
{
  EXPECT_EQ(this->Run("FillDefect"), 1);
  this->WriteScan();
  EXPECT_EQ(this->Run("FillDefect both.mha both.mha no.json segments.ply"), 1);
  EXPECT_NE(this->said.find("the file is not there"), std::string::npos) << this->said;
  EXPECT_EQ(this->Run("FillDefect both.mha no.mha " + this->recipe + " segments.ply"), 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("segments.ply")));
}

TEST_F(FillDefect, SaysHowLongTheSegmentsAre)
{
  this->WriteScan();
  ASSERT_EQ(this->Run("FillDefect both.mha both.mha " + this->recipe + " segments.ply"), 0)
    << this->said;
  EXPECT_NE(this->said.find("segment 2: 26."), std::string::npos) << this->said;
  EXPECT_TRUE(std::filesystem::exists(this->Path("segments.ply")));
}

} // namespace
