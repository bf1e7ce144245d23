#include "LensTable.h"
#include "StereoOutput.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <tuple>

namespace
{

using hasp::MirrorFlip;
using hasp::StereoEye;
using hasp::StereoLayout;
using hasp::StereoOutput;
using hasp::StereoResolution;
using Bytes = std::vector<std::uint8_t>;

const glm::ivec2 Column{ 1, 2 };
const Bytes LeftEye{ 10, 20, 30, 255, 255, 255 }; // lower row, upper row
const Bytes RightEye{ 1, 2, 3, 4, 5, 6 };

/// A picture whose pixels say where they are: red x, green y, blue which eye.
Bytes Numbered(glm::ivec2 size, int eye)
{
  Bytes rgb;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (const int value : { x, y, eye })
        rgb.push_back(static_cast<std::uint8_t>(value));
  return rgb;
}

/// What an output of that size shows: (x, y, eye) at a pixel that is counted from the top left, as
/// displays are described.
class Shown
{
public:
  Shown(const StereoOutput& output, glm::ivec2 s)
    : size(s),
      left(hasp::GridOfEye(output, s, StereoEye::Left).size),
      rgb(hasp::ComposeStereo(output, s, Numbered(left, 1),
        Numbered(hasp::GridOfEye(output, s, StereoEye::Right).size, 2)))
  {
  }
  /// Eye pixel counted from the top left, too.
  std::tuple<int, int, int> At(int x, int top) const
  {
    const std::uint8_t* pixel = &this->rgb[3 * ((this->size.y - 1 - top) * this->size.x + x)];
    return { pixel[0], this->left.y - 1 - pixel[1], pixel[2] };
  }
  glm::ivec2 size, left;

private:
  Bytes rgb;
};

using Pixel = std::tuple<int, int, int>;

TEST(StereoOutput, RefusesPicturesThatDoNotFit)
{
  const Bytes small{ 1, 2, 3 };
  const StereoOutput sides{};
  EXPECT_THROW(hasp::ComposeStereo(sides, { 2, 2 }, LeftEye, small), std::invalid_argument);
  EXPECT_THROW(hasp::ComposeStereo(sides, { 0, 2 }, {}, {}), std::invalid_argument);
  EXPECT_THROW(hasp::GridOfEye(sides, { 2, -1 }, StereoEye::Left), std::invalid_argument);
  for (const StereoLayout two : { StereoLayout::DualWindow, StereoLayout::QuadBuffer })
    EXPECT_THROW(hasp::ComposeStereo({ two }, Column, LeftEye, RightEye), std::invalid_argument);
  for (const glm::ivec2 outside :
    { glm::ivec2(-1, 0), glm::ivec2(0, -1), glm::ivec2(4, 0), glm::ivec2(0, 2) })
    EXPECT_THROW(hasp::EyePixelAt(sides, { 4, 2 }, outside), std::invalid_argument);
  const std::array<hasp::LensTable, 2> lenses{}; // of no size
  EXPECT_THROW(
    hasp::ComposeStereo(sides, { 2, 2 }, LeftEye, RightEye, &lenses), std::invalid_argument);
}

TEST(StereoOutput, LeftIsOnTheLeft)
{
  EXPECT_EQ(hasp::ComposeStereo({}, { 2, 2 }, LeftEye, RightEye),
    (Bytes{ 10, 20, 30, 1, 2, 3, 255, 255, 255, 4, 5, 6 }));
  EXPECT_EQ(hasp::ComposedSize({}, Column), glm::ivec2(2, 2));
}

TEST(StereoOutput, LeftIsOnTop)
{
  const StereoOutput output{ StereoLayout::TopBottom };
  EXPECT_EQ(hasp::ComposeStereo(output, { 1, 4 }, LeftEye, RightEye),
    (Bytes{ 1, 2, 3, 4, 5, 6, 10, 20, 30, 255, 255, 255 }));
  EXPECT_EQ(hasp::ComposedSize(output, Column), glm::ivec2(1, 4));
}

TEST(StereoOutput, AnaglyphHasTheLeftEyeInRed)
{
  // (77 * 10 + 150 * 20 + 29 * 30 + 128) / 256 = 18.6, and white stays white.
  StereoOutput output{ StereoLayout::Anaglyph };
  EXPECT_EQ(hasp::ComposeStereo(output, Column, LeftEye, RightEye), (Bytes{ 18, 2, 3, 255, 5, 6 }));
  output.swapEyes = true; // (77 * 1 + 150 * 2 + 29 * 3 + 128) / 256 = 2.3; 5.2
  EXPECT_EQ(
    hasp::ComposeStereo(output, Column, LeftEye, RightEye), (Bytes{ 2, 20, 30, 5, 255, 255 }));
}

TEST(StereoOutput, OneEyeAloneIsItsPicture)
{
  EXPECT_EQ(hasp::ComposeStereo({ StereoLayout::Mono }, Column, LeftEye, {}), LeftEye);
  EXPECT_EQ(hasp::ComposeStereo({ StereoLayout::Left }, Column, LeftEye, {}), LeftEye);
  EXPECT_EQ(hasp::ComposeStereo({ StereoLayout::Right }, Column, {}, RightEye), RightEye);
}

TEST(StereoOutput, TheTopRowAndTheTopLeftPixelAreTheLeftEyes)
{
  for (const int height : { 4, 5 })
    for (const bool swap : { false, true })
    {
      StereoOutput rows{ StereoLayout::Interlaced };
      StereoOutput fields{ StereoLayout::Checkerboard };
      rows.swapEyes = fields.swapEyes = swap;
      const Shown interlaced(rows, { 3, height }), checkered(fields, { 3, height });
      for (int top = 0; top < height; ++top)
        for (int x = 0; x < 3; ++x)
        {
          EXPECT_EQ(interlaced.At(x, top), Pixel(x, top, 1 + ((top & 1) ^ int(swap))));
          EXPECT_EQ(checkered.At(x, top), Pixel(x, top, 1 + (((top + x) & 1) ^ int(swap))));
        }
    }
}

TEST(StereoOutput, HalfResolutionShowsEachEyePixelOnce)
{
  for (const glm::ivec2 size : { glm::ivec2(6, 4), glm::ivec2(7, 5), glm::ivec2(1, 1) })
    for (const StereoLayout layout : { StereoLayout::SideBySide, StereoLayout::TopBottom,
           StereoLayout::Interlaced, StereoLayout::Checkerboard })
    {
      SCOPED_TRACE(hasp::StereoLayoutName(layout));
      const StereoOutput output{ layout, StereoResolution::Half };
      std::set<std::tuple<int, int, int>> seen;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
        {
          const hasp::EyePixel from = hasp::EyePixelAt(output, size, { x, y });
          EXPECT_EQ(hasp::PixelOfEye(output, size, from.eye, { x, y }), from.pixel);
          const glm::ivec2 eye = hasp::GridOfEye(output, size, from.eye).size;
          EXPECT_TRUE(
            from.pixel.x >= 0 && from.pixel.y >= 0 && from.pixel.x < eye.x && from.pixel.y < eye.y);
          EXPECT_TRUE(seen.emplace(from.pixel.x, from.pixel.y, from.eye == StereoEye::Left).second);
        }
    }
}

/// Where an eye's pixel is drawn, as x and y of the output's pixels.
glm::dvec2 DrawnAt(const StereoOutput& output, glm::ivec2 size, const hasp::EyePixel& from)
{
  const hasp::EyeGrid grid = hasp::GridOfEye(output, size, from.eye);
  const glm::dvec2 device = 2.0 * (glm::dvec2(from.pixel) + 0.5) / glm::dvec2(grid.size) - 1.0;
  return ((device - grid.shift) / grid.scale + 1.0) * 0.5 * glm::dvec2(size);
}

TEST(StereoOutput, HalvedRowsAreSampledWhereTheyAreShown)
{
  for (const glm::ivec2 size : { glm::ivec2(6, 4), glm::ivec2(7, 5), glm::ivec2(3, 1) })
    for (const MirrorFlip flip :
      { MirrorFlip::None, MirrorFlip::Horizontal, MirrorFlip::Vertical, MirrorFlip::Both })
      for (const bool swap : { false, true })
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x)
          {
            const StereoOutput rows{ StereoLayout::Interlaced, StereoResolution::Half, flip, swap };
            const bool across = flip == MirrorFlip::Horizontal || flip == MirrorFlip::Both;
            const bool over = flip == MirrorFlip::Vertical || flip == MirrorFlip::Both;
            const glm::dvec2 scene(
              across ? size.x - x - 0.5 : x + 0.5, over ? size.y - y - 0.5 : y + 0.5);
            const glm::dvec2 drawn = DrawnAt(rows, size, hasp::EyePixelAt(rows, size, { x, y }));
            EXPECT_NEAR(drawn.x, scene.x, 1e-12);
            EXPECT_NEAR(drawn.y, scene.y, 1e-12);
            // Fields: half a pixel beside, never more.
            StereoOutput fields = rows;
            fields.layout = StereoLayout::Checkerboard;
            const glm::dvec2 beside =
              DrawnAt(fields, size, hasp::EyePixelAt(fields, size, { x, y }));
            EXPECT_NEAR(std::abs(beside.x - scene.x), 0.5, 1e-12);
            EXPECT_NEAR(beside.y, scene.y, 1e-12);
          }
}

TEST(StereoOutput, AFlipTurnsEachEyeAndSwapsNone)
{
  const glm::ivec2 size{ 6, 4 };
  for (const StereoLayout layout : { StereoLayout::Left, StereoLayout::SideBySide,
         StereoLayout::TopBottom, StereoLayout::Interlaced, StereoLayout::Checkerboard })
    for (const MirrorFlip flip : { MirrorFlip::Horizontal, MirrorFlip::Vertical, MirrorFlip::Both })
    {
      const StereoOutput plain{ layout }, turned{ layout, StereoResolution::Full, flip };
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
        {
          const hasp::EyePixel a = hasp::EyePixelAt(plain, size, { x, y });
          const hasp::EyePixel b = hasp::EyePixelAt(turned, size, { x, y });
          const glm::ivec2 last = hasp::GridOfEye(plain, size, a.eye).size - 1;
          EXPECT_EQ(b.eye, a.eye);
          EXPECT_EQ(b.pixel.x, flip == MirrorFlip::Vertical ? a.pixel.x : last.x - a.pixel.x);
          EXPECT_EQ(b.pixel.y, flip == MirrorFlip::Horizontal ? a.pixel.y : last.y - a.pixel.y);
        }
    }
}

TEST(StereoOutput, OddSizesCutTheSecondEye)
{
  const Shown sides({ StereoLayout::SideBySide }, { 5, 1 });
  EXPECT_EQ(sides.left, glm::ivec2(3, 1));
  EXPECT_EQ(sides.At(2, 0), Pixel(2, 0, 1));
  EXPECT_EQ(sides.At(3, 0), Pixel(0, 0, 2));
  EXPECT_EQ(sides.At(4, 0), Pixel(1, 0, 2)); // its column 2 is not shown
  const Shown over({ StereoLayout::TopBottom }, { 1, 3 });
  EXPECT_EQ(over.At(0, 1), Pixel(0, 1, 1));
  EXPECT_EQ(over.At(0, 2), Pixel(0, 0, 2)); // its lowest row is not shown
}

} // namespace
