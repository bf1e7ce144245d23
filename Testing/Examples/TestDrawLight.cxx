#include "ExampleRun.h"
#include "PictureFiles.h"

namespace
{

class DrawLight : public ExampleTest
{
};

TEST_F(DrawLight, SaysWhatItCannotRead)
{
  this->WriteBall();
  EXPECT_EQ(this->Run("DrawLight no.mha 0 picture.png"), 1) << this->said;
  EXPECT_EQ(this->Run("DrawLight ball.mha 0 picture.png no.hdr"), 1);
  EXPECT_NE(this->said.find("environment no.hdr"), std::string::npos) << this->said;
}

TEST_F(DrawLight, DaylightFallsOnTheBallAndItsPart)
{
  this->WriteBall();
  ASSERT_EQ(this->Run("DrawLight ball.mha 0 picture.png"), 0) << this->said;
  EXPECT_EQ(this->said, "");
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  ASSERT_EQ(picture.width, 600);
  int bright = 0, dark = 0;
  for (std::size_t n = 0; n < picture.pixels.size(); ++n)
    (picture.pixels[n] > 128 ? bright : dark) += 1;
  EXPECT_GT(bright, 20'000); // of 1,080,000: sunlit bone
  EXPECT_GT(dark, 500'000);  // the background
}

} // namespace
