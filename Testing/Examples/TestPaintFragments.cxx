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

// One drag right of the break in front of the jaw's angle, one on the chin: both sides of it get
// the colour of their drag, far beyond what the brush has touched; what is above, apart, gets
// neither.
TEST_F(PaintFragments, TwoDragsPartTheJawAtItsBreak)
{
  ASSERT_EQ(this->Run("PaintFragments picture.png"), 0) << this->said;
  const hasp::RGBPicture picture = hasp::ReadPNG(this->Path("picture.png"));
  struct Seen
  {
    int pixels = 0, left = 1 << 20, right = -1, top = -1;
  };
  Seen of[2]; // red is label 2, the palette's next is 3
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
    {
      const std::uint8_t* p = picture.At(x, y);
      const int most = std::max({ p[0], p[1], p[2] }), least = std::min({ p[0], p[1], p[2] });
      if (most < 40 || most < 2 * least)
        continue;
      Seen& seen = of[p[0] == most && p[0] > 2 * p[2] && p[0] > 2 * p[1] ? 0 : 1];
      ++seen.pixels;
      seen.left = std::min(seen.left, x);
      seen.right = std::max(seen.right, x);
      seen.top = std::max(seen.top, y);
    }
  EXPECT_GT(of[0].pixels, 2000);
  EXPECT_GT(of[1].pixels, 4000);
  EXPECT_LT(of[0].left, 150);
  EXPECT_LT(of[0].right, of[1].right);
  EXPECT_GT(of[1].right, 380);
  EXPECT_NEAR(of[0].right, of[1].left, 60) << "they meet at the break";
}

} // namespace
