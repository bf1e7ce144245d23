// The examples of Filters/Distance: MeasureBone, OffsetBone, CutBone, MakePlate, MeasureDistance.
#include "ExampleRun.h"

#include "Evaluation/MeshCheck.h"
#include "vtkHaspVolumeView.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <cmath>
#include <numbers>

namespace
{

constexpr double BallMm = 10.0; // of ball.mha

double BallMm3(double radius)
{
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

class DistanceExamples : public ExampleTest
{
protected:
  hasp::MeshCheck CheckFile(const std::string& name) const
  {
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName(this->Path(name).c_str());
    reader->MergingOff();
    reader->Update();
    return hasp::CheckMesh(hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput())));
  }
};

TEST_F(DistanceExamples, MeasureBoneSaysHowMuchThereIs)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("MeasureBone ball.mha 0"), 0) << this->said;
  EXPECT_NEAR(std::stod(this->said), BallMm3(BallMm) / 1000.0, 0.01 * BallMm3(BallMm) / 1000.0);
  EXPECT_EQ(this->Run("MeasureBone none.mha 0"), 1);
}

TEST_F(DistanceExamples, OffsetBoneKeepsItsDistance)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("OffsetBone ball.mha 0 -2.5 smaller.stl"), 0) << this->said;
  const hasp::MeshCheck check = this->CheckFile("smaller.stl");
  EXPECT_TRUE(check.Closed());
  EXPECT_TRUE(check.Outward());
  EXPECT_NEAR(check.volumeMm3, BallMm3(BallMm - 2.5), 0.02 * BallMm3(BallMm - 2.5));
  ASSERT_EQ(this->Run("OffsetBone ball.mha 0 6 larger.stl"), 0) << this->said;
  const hasp::MeshCheck larger = this->CheckFile("larger.stl"); // than the scan
  EXPECT_TRUE(larger.Closed());
  EXPECT_TRUE(larger.Outward());
  EXPECT_NEAR(larger.volumeMm3, BallMm3(BallMm + 6.0), 0.02 * BallMm3(BallMm + 6.0));
  EXPECT_EQ(this->Run("OffsetBone ball.mha 0 -50 none.stl"), 1) << "smaller than nothing";
  EXPECT_FALSE(std::filesystem::exists(this->Path("none.stl")));
}

TEST_F(DistanceExamples, CutBoneLeavesTwoPiecesAKerfApart)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("CutBone ball.mha 0 30 -20 500 1.2 cut.stl"), 0) << this->said;
  const hasp::MeshCheck check = this->CheckFile("cut.stl");
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 2u);
  const double gone =
    1.2 * std::numbers::pi * (BallMm * BallMm - 0.12); // of a ball, pi h (r^2 - h^2/12)
  EXPECT_NEAR(check.volumeMm3, BallMm3(BallMm) - gone, 0.01 * BallMm3(BallMm));
  EXPECT_EQ(this->Run("CutBone ball.mha 0 30 -20 500 -1 none.stl"), 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("none.stl")));
}

TEST_F(DistanceExamples, MakePlateKeepsItsMeasures)
{
  ASSERT_EQ(this->Run("MakePlate HASP-1 plate.stl"), 0) << this->said;
  const hasp::MeshCheck check = this->CheckFile("plate.stl");
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1u);
  const double plate = (22.0 * 8.0 + std::numbers::pi * 16.0) * 1.5;
  const double holes = 2.0 * std::numbers::pi * 1.5;
  EXPECT_LT(check.volumeMm3, plate - holes - 1.0) << "something is engraved";
  EXPECT_GT(check.volumeMm3, plate - holes - 8.0);
  EXPECT_EQ(this->Run("MakePlate 'a?' none.stl"), 1);
  EXPECT_EQ(this->Run("MakePlate HASP-12 none.stl"), 1) << "it would run into the hole";
  EXPECT_NE(this->said.find("does not fit"), std::string::npos) << this->said;
  EXPECT_EQ(this->Run("MakePlate HASP-1 none/plate.stl"), 1);
}

TEST_F(DistanceExamples, WrongArgumentsAreAnsweredByOneLine)
{
  for (const std::string wrong : { "MeasureBone", "MeasureBone ball.mha abc", "OffsetBone",
         "OffsetBone ball.mha 226 abc none.stl", "OffsetBone ball.mha 226x 1 none.stl", "CutBone",
         "CutBone ball.mha 0 1 2 z 1 none.stl", "MakePlate", "MakePlate A", "MeasureDistance",
         "MeasureDistance a.stl b.stl 2x" })
  {
    EXPECT_EQ(this->Run(wrong), 1) << wrong;
    EXPECT_EQ(this->said.find(wrong.substr(0, wrong.find(' ')) + " <"), 0U) << this->said;
    EXPECT_EQ(this->said.find('\n'), this->said.size() - 1) << this->said;
  }
}

TEST_F(DistanceExamples, MeasureDistanceFollowsThePose)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("OffsetBone ball.mha 0 0 ball.stl"), 0) << this->said;
  ASSERT_EQ(this->Run("OffsetBone ball.mha 0 -2.5 smaller.stl"), 0) << this->said;
  ASSERT_EQ(this->Run("MeasureDistance smaller.stl ball.stl 4"), 0) << this->said;
  double low = 0, high = 0;
  const std::string last = this->said.substr(this->said.rfind("3 mm: "));
  ASSERT_EQ(std::sscanf(last.c_str(), "3 mm: %lf to %lf mm", &low, &high), 2) << this->said;
  EXPECT_NEAR(high, 3 - 2.5, 0.1); // voxels of a millimetre, and what it is sampled on
  EXPECT_NEAR(low, -3 - 2.5, 0.1);
}

TEST_F(DistanceExamples, AFileThatIsNotThereIsSaidAndNothingElseIsBlamed)
{
  for (const std::string command : { "MeasureBone none.mha 0", "OffsetBone none.mha 0 1 none.stl" })
  {
    EXPECT_EQ(this->Run(command), 1);
    EXPECT_EQ(this->said.find("geometry"), std::string::npos) << this->said;
  }
  ASSERT_EQ(this->Run("MakePlate A plate.stl"), 0);
  EXPECT_EQ(this->Run("MeasureBone plate.stl 0"), 1);
  EXPECT_NE(this->said.find("is a surface"), std::string::npos) << this->said;
}

} // namespace
