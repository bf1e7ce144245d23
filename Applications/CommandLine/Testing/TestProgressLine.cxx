#include "ProgressLine.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{

using hasp::ProgressLine;

std::string After(ProgressLine::Style style)
{
  std::ostringstream stream;
  {
    ProgressLine line(stream);
    line.SetStyle(style);
    line.Step("reading a.mha");
    for (int k = 0; k < 1000; ++k)
      line.Share(k / 1000.0);
    line.Step("drawing");
  }
  return stream.str();
}

TEST(ProgressLine, QuietSaysNothing)
{
  EXPECT_EQ(After(ProgressLine::Style::Quiet), "");
}

TEST(ProgressLine, AFileGetsALineAStep)
{
  EXPECT_EQ(After(ProgressLine::Style::Steps), "hasp: reading a.mha\nhasp: drawing\n");
}

TEST(ProgressLine, ATerminalGetsOneLineThatIsWiped)
{
  const std::string text = After(ProgressLine::Style::Terminal);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.rfind("\r\033[K  0% reading a.mha", 0), 0u) << text;
  EXPECT_TRUE(text.ends_with("drawing\r\033[K")) << text;
  EXPECT_LT(text.size(), 500u); // a thousand shares within a moment are not a thousand lines
}

} // namespace
