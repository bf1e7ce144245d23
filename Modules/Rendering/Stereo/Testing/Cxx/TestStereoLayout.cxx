#include "StereoLayout.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using hasp::StereoLayout;

TEST(StereoLayout, NamesGoBothWays)
{
  for (int n = 0; n <= static_cast<int>(StereoLayout::QuadBuffer); ++n)
  {
    const auto layout = static_cast<StereoLayout>(n);
    EXPECT_EQ(hasp::StereoLayoutFromName(hasp::StereoLayoutName(layout)), layout);
  }
  try
  {
    hasp::StereoLayoutFromName("quad");
    FAIL() << "an unknown name must throw";
  }
  catch (const std::invalid_argument& error)
  {
    for (const char* known : { "side-by-side", "interlaced", "quad-buffer" })
      EXPECT_NE(std::string(error.what()).find(known), std::string::npos);
  }
}

TEST(StereoLayout, SaysHowManyEyesAndPictures)
{
  for (const StereoLayout one : { StereoLayout::Mono, StereoLayout::Left, StereoLayout::Right })
    EXPECT_FALSE(hasp::NeedsSecondEye(one));
  for (const StereoLayout two : { StereoLayout::SideBySide, StereoLayout::TopBottom,
         StereoLayout::Anaglyph, StereoLayout::Interlaced, StereoLayout::Checkerboard,
         StereoLayout::DualWindow, StereoLayout::QuadBuffer })
    EXPECT_TRUE(hasp::NeedsSecondEye(two));
  EXPECT_FALSE(hasp::IsOnePicture(StereoLayout::DualWindow));
  EXPECT_FALSE(hasp::IsOnePicture(StereoLayout::QuadBuffer));
  EXPECT_TRUE(hasp::IsOnePicture(StereoLayout::Checkerboard));
}

} // namespace
