#include "ProgressLine.h"

#include "Grid/Progress.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>
#include <vector>

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

TEST(ProgressLine, WhoWatchesHearsAllOfItAndNothingIsWritten)
{
  std::ostringstream stream;
  std::vector<std::pair<std::string, double>> heard;
  for (const auto style : { ProgressLine::Style::Steps, ProgressLine::Style::Terminal })
  {
    heard.clear();
    ProgressLine line(stream);
    line.SetStyle(style);
    line.SetWatch(
      [&](const std::string& step, double share)
      {
        heard.emplace_back(step, share);
        return true;
      });
    line.Step("making");
    EXPECT_TRUE(line.Share(0.5));
    line.Step("measuring");
    line.Wipe();
    EXPECT_EQ(heard, (std::vector<std::pair<std::string, double>>{
                       { "making", 0.0 }, { "making", 0.5 }, { "measuring", 0.0 } }));
  }
  EXPECT_EQ(stream.str(), "");
}

TEST(ProgressLine, WhoWatchesCanGiveItUp)
{
  std::ostringstream stream;
  ProgressLine line(stream);
  bool goOn = true;
  line.SetWatch([&](const std::string&, double) { return goOn; });
  line.Step("making");
  goOn = false;
  EXPECT_FALSE(line.Share(0.5));
  EXPECT_THROW(line.Step("measuring"), hasp::Cancelled);
}

} // namespace
