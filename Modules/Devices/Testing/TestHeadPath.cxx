#include "Devices/HeadPath.h"
#include "Devices/HeadTracker.h"
#include "Devices/RecordedHeadPose.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace
{

const std::string Columns = "timeS,xMm,yMm,zMm,qw,qx,qy,qz\n";

hasp::HeadPath Good()
{
  return { { -0.1, { { 1.0 / 3.0, -0.0, 600 }, { 1, 0, 0, 0 } } },
    { 0.0166, { { 1e-7, 123456.789e-3, 1e3 }, { 0.8, 0, 0.6, 0 } } },
    { 5e3, { { -9999, 0, 0 }, { 0, 0, 0, 1 } } } };
}

std::string Refusal(const std::string& text)
{
  try
  {
    hasp::ParseHeadPath(text);
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

struct Folder
{
  Folder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "hasp-path-XXXXXX").string();
    this->path = mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(this->path); }
  std::string File(const char* name) const { return (this->path / name).string(); }
  std::filesystem::path path;
};

TEST(HeadPath, WhatIsWrongInTheTextIsSaidByItsLine)
{
  const std::string fine = "0,0,0,600,1,0,0,0\n";
  const struct
  {
    std::string text;
    const char* says;
  } cases[] = {
    { "", "line 1: it must be timeS,xMm" },
    { "time,x,y,z\n" + fine, "line 1" },
    { Columns, "line 2: there is no pose" },
    { Columns + "0,0,0,600,1,0,0\n", "line 2: there must be 8" },
    { Columns + fine + "1,0,0,600,1,0,0,0,0\n", "line 3: something stands behind" },
    { Columns + fine + "\n" + fine, "line 3: column 1" },
    { Columns + fine + "1,0,0,six,1,0,0,0\n", "line 3: column 4" },
    { Columns + "0, 0,0,600,1,0,0,0\n", "line 2: column 2" },
    { Columns + "0,0,0,1e999,1,0,0,0\n", "line 2: column 4 is no number that a double holds" },
    { Columns + "0,0,0,nan,1,0,0,0\n", "line 2: head path: pose 1: head pose: a number is not" },
    { Columns + "inf,0,0,600,1,0,0,0\n", "line 2: head path: pose 1: its time must be finite" },
    { Columns + "0,0,0,60000,1,0,0,0\n", "60000 mm" },
    { Columns + "0,0,0,600,1,1,0,0\n", "1.41421" },
    { Columns + fine + fine, "line 3: head path: pose 2: its time is 0.000000 s before" },
    { Columns + "1,0,0,600,1,0,0,0\n" + fine, "times must increase" },
  };
  for (const auto& c : cases)
    EXPECT_NE(Refusal(c.text).find(c.says), std::string::npos) << c.says << "\n" << Refusal(c.text);
}

TEST(HeadPath, ErrorsHoldNoTextOfTheFile)
{
  for (const std::string& text : { Columns + "SECRET,0,0,600,1,0,0,0\n",
         Columns + "0,0,0,600,1,0,0,0SECRET\n", std::string("SECRET\n") })
  {
    EXPECT_FALSE(Refusal(text).empty());
    EXPECT_EQ(Refusal(text).find("SECRET"), std::string::npos);
  }
  try
  {
    hasp::ReadHeadPath("/nowhere/SECRET.csv");
    ADD_FAILURE();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "head path: there is no such file");
  }
}

TEST(HeadPath, TextComesBackToTheLastBit)
{
  const hasp::HeadPath path = Good(), again = hasp::ParseHeadPath(hasp::FormatHeadPath(path));
  ASSERT_EQ(again.size(), path.size());
  for (std::size_t n = 0; n < path.size(); ++n)
  {
    EXPECT_EQ(again[n].timeS, path[n].timeS);
    EXPECT_EQ(again[n].pose.position, path[n].pose.position);
    EXPECT_EQ(again[n].pose.orientation, path[n].pose.orientation);
  }
  std::string windows = hasp::FormatHeadPath(path);
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.replace(at, 1, "\r\n");
  EXPECT_EQ(hasp::ParseHeadPath(windows).size(), path.size());
}

TEST(HeadPath, FilesAreWholeOrAsBefore)
{
  const Folder folder;
  const std::string file = folder.File("path.csv");
  hasp::WriteHeadPath(file, Good());
  EXPECT_EQ(hasp::ReadHeadPath(file).size(), 3u);
  EXPECT_THROW(hasp::WriteHeadPath(file, hasp::HeadPath{}), std::invalid_argument);
  EXPECT_EQ(hasp::ReadHeadPath(file).size(), 3u) << "the old file is still there";
  EXPECT_THROW(hasp::WriteHeadPath(folder.File("no/such/folder.csv"), Good()), std::runtime_error);
  std::filesystem::create_directory(folder.File("taken"));
  std::ofstream(folder.File("taken/x")) << "x";
  EXPECT_THROW(hasp::WriteHeadPath(folder.File("taken"), Good()), std::runtime_error);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path))
    ++entries;
  EXPECT_EQ(entries, 2u) << "no temporary file is left";
}

TEST(HeadPath, SizesAreHeldAgainstTheirLimitsFirst)
{
  const Folder folder;
  const std::string file = folder.File("large.csv");
  std::ofstream(file) << Columns;
  std::filesystem::resize_file(file, std::uintmax_t(300) << 20); // a hole: no memory, no disk
  try
  {
    hasp::ReadHeadPath(file);
    ADD_FAILURE();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "head path: the file has 314572800 bytes, at most 268435456");
  }
  std::string many = Columns;
  for (int n = 0; n <= 1'000'000; ++n)
    (many += std::to_string(n)) += ",0,0,0,1,0,0,0\n";
  EXPECT_NE(Refusal(many).find("line 1000002: there are more than 1000000"), std::string::npos);
}

TEST(HeadPath, BetweenPosesTheHeadGoesStraightAndTurnsEvenly)
{
  const double quarter = std::numbers::pi / 2;
  const hasp::HeadPath path = { { 1.0, { { 0, 0, 600 }, { 1, 0, 0, 0 } } },
    { 3.0, { { 20, -10, 500 }, hasp::HeadOrientation(quarter, 0, 0) } } };
  for (double share = 0.0; share <= 1.0; share += 0.125)
  {
    const hasp::HeadPose pose = hasp::HeadPoseAt(path, 1.0 + 2.0 * share);
    EXPECT_LT(
      glm::length(pose.position - glm::dvec3(20 * share, -10 * share, 600 - 100 * share)), 1e-12);
    const glm::dquat truth = hasp::HeadOrientation(quarter * share, 0, 0);
    EXPECT_NEAR(std::abs(glm::dot(pose.orientation, truth)), 1.0, 1e-14);
  }
  EXPECT_EQ(hasp::HeadPoseAt(path, -5.0).position, path[0].pose.position);
  EXPECT_EQ(hasp::HeadPoseAt(path, 99.0).position, path[1].pose.position);
}

TEST(HeadPath, TheShortWayRoundIsTaken)
{
  const hasp::HeadPose a{ {}, hasp::HeadOrientation(0.1, 0, 0) },
    b{ {}, -hasp::HeadOrientation(0.3, 0, 0) };
  const hasp::HeadPose middle = hasp::MixHeadPoses(a, b, 0.5);
  EXPECT_NEAR(std::abs(glm::dot(middle.orientation, hasp::HeadOrientation(0.2, 0, 0))), 1.0, 1e-14);
}

TEST(RecordedHeadPose, NothingBeforeItsStartAndTheLastPoseAfterItsEnd)
{
  hasp::RecordedHeadPose source(
    { { 10.0, { { 1, 0, 600 }, { 1, 0, 0, 0 } } }, { 12.0, { { 3, 0, 600 }, { 1, 0, 0, 0 } } } },
    { .startS = 100.0 });
  EXPECT_FALSE(source.Latest(99.9));
  EXPECT_FALSE(source.Latest(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_DOUBLE_EQ(source.Latest(100.0)->pose.position.x, 1.0);
  EXPECT_DOUBLE_EQ(source.Latest(101.0)->pose.position.x, 2.0);
  EXPECT_DOUBLE_EQ(source.Latest(101.0)->timeS, 101.0);
  EXPECT_DOUBLE_EQ(source.Latest(150.0)->pose.position.x, 3.0);
  EXPECT_DOUBLE_EQ(source.Latest(150.0)->timeS, 102.0) << "it grows old";
}

TEST(RecordedHeadPose, ALoopBeginsAgainAndItsTimesGoOn)
{
  hasp::RecordedHeadPose source(
    { { 10.0, { { 1, 0, 600 }, { 1, 0, 0, 0 } } }, { 12.0, { { 3, 0, 600 }, { 1, 0, 0, 0 } } } },
    { .startS = 100.0, .loop = true });
  double last = 0.0;
  for (double now = 100.25; now < 111.0; now += 0.5)
  {
    const auto pose = source.Latest(now);
    EXPECT_NEAR(pose->pose.position.x, 1.0 + std::fmod(now - 100.0, 2.0), 1e-12) << now;
    EXPECT_NEAR(pose->timeS, now, 1e-12);
    EXPECT_GT(pose->timeS, last);
    last = pose->timeS;
  }
}

TEST(RecordedHeadPose, AsItsTrackerPosesComeLateAndAreNotMixed)
{
  hasp::RecordedHeadPose source(
    { { 0.0, { { 1, 0, 600 }, { 1, 0, 0, 0 } } }, { 1.0, { { 2, 0, 600 }, { 1, 0, 0, 0 } } } },
    { .interpolate = false, .delayS = 0.25 });
  EXPECT_FALSE(source.Latest(0.2));
  EXPECT_EQ(source.Latest(1.2)->pose.position.x, 1.0);
  EXPECT_EQ(source.Latest(1.2)->timeS, 0.0);
  EXPECT_EQ(source.Latest(1.25)->pose.position.x, 2.0);
  EXPECT_EQ(source.Latest(1.25)->timeS, 1.0);
}

TEST(RecordedHeadPose, WhatCannotBePlayedIsRefused)
{
  EXPECT_THROW(hasp::RecordedHeadPose({}), std::invalid_argument);
  EXPECT_THROW(hasp::RecordedHeadPose(Good(), { .delayS = -1.0 }), std::invalid_argument);
  EXPECT_THROW(
    hasp::RecordedHeadPose(Good(), { .startS = std::numeric_limits<double>::infinity() }),
    std::invalid_argument);
}

TEST(RecordedHeadPose, ALoopOfOnePoseIsAHeadThatKeepsStill)
{
  const hasp::HeadPath one{ { 5.0, { { 1, 2, 700 }, { 1, 0, 0, 0 } } } };
  EXPECT_EQ(hasp::RecordedHeadPose(one).Latest(7.0)->timeS, 0.0) << "played once it grows old";
  for (const bool interpolate : { true, false })
  {
    const hasp::PlaybackSettings settings{
      .startS = 2.0, .loop = true, .interpolate = interpolate, .delayS = 0.5
    };
    hasp::RecordedHeadPose source(one, settings);
    EXPECT_FALSE(source.Latest(2.4));
    for (const double now : { 2.5, 7.0, 1000.0 })
    {
      EXPECT_EQ(source.Latest(now)->timeS, now - 0.5);
      EXPECT_EQ(source.Latest(now)->pose.position, glm::dvec3(1, 2, 700));
    }
  }
  hasp::HeadTracker tracker(
    std::make_unique<hasp::RecordedHeadPose>(one, hasp::PlaybackSettings{ .loop = true }));
  for (int n = 0; n < 120; ++n)
    EXPECT_EQ(tracker.At(n / 60.0).state, hasp::HeadTrackerState::Tracking) << n;
}

/// Where a round ends, rounding says which one it is: n d less floor(n d / d) d may be below 0.
TEST(RecordedHeadPose, WhereALoopBeginsAgainItIsAPoseOfThePath)
{
  int below = 0;
  for (const double end : { 0.1, 0.3, 0.7, 1.1, 2.3 })
    for (const bool interpolate : { true, false })
    {
      hasp::RecordedHeadPose source(
        { { 0.0, { { 1, 0, 600 }, { 1, 0, 0, 0 } } }, { end, { { 2, 0, 600 }, { 1, 0, 0, 0 } } } },
        { .loop = true, .interpolate = interpolate });
      for (int n = 1; n < 500; ++n)
        for (const double now :
          { std::nextafter(n * end, 0.0), n * end, std::nextafter(n * end, 1e9) })
        {
          below += now - std::floor(now / end) * end < 0.0;
          const auto pose = source.Latest(now);
          ASSERT_TRUE(pose);
          const double x = pose->pose.position.x;
          EXPECT_TRUE(std::abs(x - 1.0) < 1e-9 || std::abs(x - 2.0) < 1e-9) << now << " " << x;
          // Not mixed it may still be the first, which is there as long as the second is not.
          EXPECT_NEAR(pose->timeS, now, interpolate || x > 1.5 ? 1e-9 : end + 1e-9);
        }
    }
  EXPECT_GT(below, 10) << "or the test proves nothing";
}

} // namespace
