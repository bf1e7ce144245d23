#include "ExampleRun.h"
#include "PictureFiles.h"

namespace
{

class DrawStereo : public ExampleTest
{
};

TEST_F(DrawStereo, AnUnknownLayoutNamesTheKnownOnes)
{
  this->WriteBall();
  this->Run("DrawStereo ball.mha 0 sideways picture.png");
  EXPECT_NE(this->said.find("side-by-side"), std::string::npos) << this->said;
  EXPECT_EQ(this->Run("DrawStereo no.mha 0 mono picture.png"), 1) << this->said;
}

TEST_F(DrawStereo, EachEyeSeesTheBall)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("DrawStereo ball.mha 0 side-by-side picture.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  ASSERT_EQ(picture.width, 2 * picture.height); // two windows of 300 x 300
  ExpectDisc(picture, 0, picture.height);
  ExpectDisc(picture, picture.height, picture.width);
}

} // namespace
