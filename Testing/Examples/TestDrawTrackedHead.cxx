#include "ExampleRun.h"
#include "PictureFiles.h"

namespace
{

class DrawTrackedHead : public ExampleTest
{
};

TEST_F(DrawTrackedHead, NeedsAVolumeAndAHeadBeforeTheScreen)
{
  this->WriteBall();
  EXPECT_EQ(this->Run("DrawTrackedHead no.mha 0 0 picture.png"), 1) << this->said;
  EXPECT_EQ(this->Run("DrawTrackedHead ball.mha 0 nan picture.png"), 1) << this->said;
}

TEST_F(DrawTrackedHead, BothEyesSeeTheBallAndAHeadAsideSeesAnotherSide)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("DrawTrackedHead ball.mha 0 0 middle.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("middle.png"));
  ASSERT_EQ(picture.width, 300);
  ASSERT_EQ(picture.height, 300);
  for (const int eye : { 0, 150 })
  {
    const LitPart lit = FindLit(picture, eye, eye + 150); // a ball, squeezed to half its width
    EXPECT_GT(lit.Height(), 80);
    EXPECT_NEAR(lit.Height(), 2 * lit.Width(), 4); // a pixel at either end
    EXPECT_NEAR(lit.left + lit.right, 2 * eye + 149, 2);
    EXPECT_NEAR(lit.bottom + lit.top, 299, 2);
  }
  ASSERT_EQ(this->Run("DrawTrackedHead ball.mha 0 100 aside.png"), 0) << this->said;
  EXPECT_NE(hasp::ReadPNG(this->Path("aside.png")).pixels, picture.pixels);
}

} // namespace
