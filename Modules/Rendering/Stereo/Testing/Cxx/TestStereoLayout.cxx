#include "StereoLayout.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using hasp::StereoLayout;
using Bytes = std::vector<std::uint8_t>;

const glm::ivec2 Size{ 1, 2 };
const Bytes LeftEye{ 10, 20, 30, 255, 255, 255 }; // lower row, upper row
const Bytes RightEye{ 1, 2, 3, 4, 5, 6 };

TEST(StereoLayout, RefusesPicturesThatDoNotFit)
{
  const Bytes small{ 1, 2, 3 };
  EXPECT_THROW(
    hasp::ComposeStereo(StereoLayout::SideBySide, Size, LeftEye, small), std::invalid_argument);
  EXPECT_THROW(
    hasp::ComposeStereo(StereoLayout::SideBySide, { 0, 2 }, {}, {}), std::invalid_argument);
  for (const StereoLayout one : { StereoLayout::Mono, StereoLayout::Left, StereoLayout::Right })
    EXPECT_THROW(hasp::ComposeStereo(one, Size, LeftEye, RightEye), std::invalid_argument);
}

TEST(StereoLayout, LeftIsOnTheLeft)
{
  EXPECT_EQ(hasp::ComposeStereo(StereoLayout::SideBySide, Size, LeftEye, RightEye),
    (Bytes{ 10, 20, 30, 1, 2, 3, 255, 255, 255, 4, 5, 6 }));
  EXPECT_EQ(hasp::ComposedSize(StereoLayout::SideBySide, Size), glm::ivec2(2, 2));
}

TEST(StereoLayout, LeftIsOnTop)
{
  EXPECT_EQ(hasp::ComposeStereo(StereoLayout::TopBottom, Size, LeftEye, RightEye),
    (Bytes{ 1, 2, 3, 4, 5, 6, 10, 20, 30, 255, 255, 255 }));
  EXPECT_EQ(hasp::ComposedSize(StereoLayout::TopBottom, Size), glm::ivec2(1, 4));
}

TEST(StereoLayout, AnaglyphHasTheLeftEyeInRed)
{
  // (77 * 10 + 150 * 20 + 29 * 30 + 128) / 256 = 18.6, and white stays white.
  EXPECT_EQ(hasp::ComposeStereo(StereoLayout::Anaglyph, Size, LeftEye, RightEye),
    (Bytes{ 18, 2, 3, 255, 5, 6 }));
  EXPECT_EQ(hasp::ComposedSize(StereoLayout::Anaglyph, Size), Size);
}

TEST(StereoLayout, NamesGoBothWays)
{
  for (const StereoLayout layout : { StereoLayout::Mono, StereoLayout::SideBySide,
         StereoLayout::TopBottom, StereoLayout::Left, StereoLayout::Right, StereoLayout::Anaglyph })
    EXPECT_EQ(hasp::StereoLayoutFromName(hasp::StereoLayoutName(layout)), layout);
  try
  {
    hasp::StereoLayoutFromName("quad");
    FAIL() << "an unknown name must throw";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("side-by-side"), std::string::npos);
  }
}

} // namespace
