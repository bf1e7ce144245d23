#include "ExampleRun.h"
#include "PictureFiles.h"

namespace
{

class SweepIsosurface : public ExampleTest
{
};

TEST_F(SweepIsosurface, WrongUseAndUnreadableFilesAreFailures)
{
  EXPECT_EQ(this->Run("SweepIsosurface"), 1) << this->said;
  EXPECT_EQ(this->Run("SweepIsosurface no.mha 0 picture.png"), 1) << this->said;
  EXPECT_NE(this->said.find("the .mha file"), std::string::npos) << this->said;
}

/// The same ball as one that never had another isovalue.
TEST_F(SweepIsosurface, EndsWithTheLastIsovalue)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("SweepIsosurface ball.mha 0 swept.png"), 0) << this->said; // 12 to 10 mm
  EXPECT_EQ(this->said, "");
  ASSERT_EQ(this->Run("DrawIsosurface ball.mha 0 drawn.png"), 0) << this->said;
  const hasp::RGBPicture swept = hasp::ReadPNG(this->Path("swept.png"));
  ExpectDisc(swept, 0, swept.width);
  // From another side of the same box, which a ball does not show; a pixel at either end.
  const LitPart lit = FindLit(swept, 0, swept.width);
  const LitPart drawn = FindLit(hasp::ReadPNG(this->Path("drawn.png")), 0, swept.width);
  EXPECT_NEAR(lit.Width(), drawn.Width(), 2);
  EXPECT_NEAR(lit.Height(), drawn.Height(), 2);
}

} // namespace
