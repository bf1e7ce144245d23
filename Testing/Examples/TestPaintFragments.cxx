#include "ExampleRun.h"
#include "PictureFiles.h"

#include <algorithm>

namespace
{

class PaintFragments : public ExampleTest
{
};

TEST_F(PaintFragments, AFolderThatIsNotThereIsAFailure)
{
  EXPECT_EQ(this->Run("PaintFragments no/such/folder.png"), 1) << this->said;
}

// The drag goes straight across the forehead: a red bar, as wide as the brush, on white bone.
TEST_F(PaintFragments, ADragColoursTheBoneThatItPasses)
{
  ASSERT_EQ(this->Run("PaintFragments picture.png"), 0) << this->said;
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  int red = 0, left = picture.width, right = -1, bottom = picture.height, top = -1;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
    {
      const std::uint8_t* p = picture.At(x, y);
      if (p[0] < 2 * p[1] || p[0] < 40)
        continue;
      ++red;
      left = std::min(left, x);
      right = std::max(right, x);
      bottom = std::min(bottom, y);
      top = std::max(top, y);
    }
  EXPECT_GT(red, 800);
  // 100 pixels, and the brush on either side; the middle is the pointer's row.
  EXPECT_LT(left, 280);
  EXPECT_GT(right, 380);
  EXPECT_NEAR(0.5 * (left + right), 330.0, 8.0);
  EXPECT_NEAR(0.5 * (bottom + top), 420.0, 8.0);
  EXPECT_LT(top - bottom, 60);
}

} // namespace
