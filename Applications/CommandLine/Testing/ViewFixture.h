#pragma once
#include "HaspProcess.h"
#include "TestScreen.h"

using Words = std::vector<std::string>;

/// bin/hasp view on a phantom.
class HaspView : public HaspTest
{
protected:
  Words View(const Words& more) const
  {
    Words words{ "view", this->Path("head.mha"), "--resolution", "200,150" };
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Width and height out of the PNG's header.
  std::pair<int, int> Size(const std::string& name) const
  {
    const std::string png = ReadBytes(this->Path(name));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at)
    {
      return 256 * static_cast<unsigned char>(png.at(at + 2)) +
             static_cast<unsigned char>(png.at(at + 3));
    };
    return { number(16), number(20) };
  }
};

#define REQUIRE_SCREEN(screen)                                                                     \
  if (screen.Display().empty())                                                                    \
  GTEST_SKIP() << "no Xvfb (Debian: xvfb)"
