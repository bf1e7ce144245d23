#include "ExampleRun.h"

#include "Grid/AnalyticVolumes.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <sstream>

namespace
{

class BakeFragments : public ExampleTest
{
protected:
  /// ball.mha, and labels.mha, whose lower half is fragment 2 and whose upper half is 3.
  void WriteHalves()
  {
    hasp::GridGeometry grid;
    grid.dims = { 30, 30, 30 };
    grid.spacing = glm::dvec3(0.7);
    this->Write("ball.mha", grid,
      hasp::SampleAnalytic<std::int16_t>(
        hasp::AnalyticSphere(glm::dvec3(10.15), 7.0), grid, 100.0, 0.0));
    std::vector<std::uint16_t> labels(grid.Size());
    for (std::size_t n = 0; n < labels.size(); ++n)
      labels[n] = n < labels.size() / 2 ? 2 : 3;
    hasp::WriteVolume(hasp::MakeImage(grid, labels), this->Path("labels.mha"));
  }
};

TEST_F(BakeFragments, SaysWhatThereIsAndWhatIsNot)
{
  this->WriteHalves();
  ASSERT_EQ(this->Run("BakeFragments ball.mha labels.mha 0"), 0) << this->said;
  std::istringstream lines(this->said);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
  {
    const bool surface = line.find("closed surface") != std::string::npos;
    EXPECT_EQ(line.find(" 0 bytes  not asked for") != std::string::npos, surface) << line;
    EXPECT_EQ(line.find(" bytes  asked for") != std::string::npos, !surface) << line;
  }
  EXPECT_EQ(count, 1 + 2 * 3);
}

TEST_F(BakeFragments, WhatItCannotTakeIsAnsweredByOneLine)
{
  this->WriteHalves();
  this->WriteBall();
  for (const std::string wrong :
    { "BakeFragments", "BakeFragments ball.mha ball.mha 0", "BakeFragments ball.mha labels.mha 0" })
  {
    EXPECT_EQ(this->Run(wrong), 1) << wrong;
    EXPECT_EQ(this->said.find('\n'), this->said.size() - 1) << this->said;
  }
}

} // namespace
