#include "Devices/HeadRecorder.h"
#include "Devices/HeadTracker.h"
#include "Devices/RecordedHeadPose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace hasp;

TimedHeadPose At(double timeS, double xMm = 0.0)
{
  return { timeS, { { xMm, 0.0, 600.0 }, { 1.0, 0.0, 0.0, 0.0 } } };
}

TEST(HeadRecorder, KeepsEachPoseOnceAndBeginsAtZero)
{
  HeadRecorder recorder;
  for (const double t : { 7.5, 7.5, 7.75, 7.75, 8.0 })
    recorder.Take(At(t, t));
  ASSERT_EQ(recorder.Path().size(), 3u);
  EXPECT_EQ(recorder.Path()[1].timeS, 0.25);
  EXPECT_EQ(recorder.Path()[2].pose.position.x, 8.0);
  EXPECT_TRUE(recorder.Losses().empty());
}

TEST(HeadRecorder, WhateverCameThePathIsValidAndTheRestIsSaid)
{
  HeadRecorder recorder;
  EXPECT_TRUE(recorder.Path().empty());
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double t : { nan, inf, -inf })
    recorder.Take(At(t));
  recorder.Take(At(1e9, nan));
  recorder.Take(At(1e9, 1e5));
  EXPECT_TRUE(recorder.Path().empty());
  recorder.Take(At(-1e12));
  recorder.Take(At(-1e12 + 1.0));
  recorder.Take(At(-1e12)); // older
  recorder.Take(At(1e12));  // two million million seconds later
  recorder.Take(At(-1e12 + 2.0));
  EXPECT_NO_THROW(ValidateHeadPath(recorder.Path()));
  EXPECT_EQ(recorder.Path().size(), 3u);
  const auto losses = recorder.Losses();
  ASSERT_EQ(losses.size(), 2u);
  EXPECT_NE(losses[0].find("6 poses that are none"), std::string::npos) << losses[0];
  EXPECT_NE(losses[1].find("1 poses older"), std::string::npos) << losses[1];
}

TEST(HeadRecorder, IsFullWhereAFileIs)
{
  HeadRecorder recorder;
  for (std::size_t n = 0; n < MostHeadPathPoses + 2; ++n)
    recorder.Take(At(double(n)));
  EXPECT_EQ(recorder.Path().size(), MostHeadPathPoses);
  ASSERT_EQ(recorder.Losses().size(), 1u);
  EXPECT_NE(recorder.Losses()[0].find("2 poses after"), std::string::npos);
}

/// What a tracker was given, played back, is what it was given: before calibration and prediction.
TEST(HeadRecorder, ATrackersRecordingPlaysItsPathAgain)
{
  HeadPath path;
  for (int n = 0; n < 120; ++n)
    path.push_back(At(n / 60.0, 50.0 * std::sin(n / 20.0)));
  PlaybackSettings playback;
  playback.interpolate = false;
  playback.startS = 100.0;
  TrackerCalibration calibration;
  calibration.trackerInRoomMm = { 10.0, 20.0, 30.0 };
  HeadTracker tracker(std::make_unique<RecordedHeadPose>(path, playback), {}, calibration);
  HeadRecorder recorder;
  tracker.RecordTo(&recorder);
  for (double now = 100.0; now < 102.5; now += 1.0 / 240)
    tracker.At(now);
  ASSERT_EQ(recorder.Path().size(), path.size());
  for (std::size_t n = 0; n < path.size(); ++n)
  {
    EXPECT_NEAR(recorder.Path()[n].timeS, path[n].timeS, 1e-9);
    EXPECT_EQ(recorder.Path()[n].pose.position, path[n].pose.position);
  }
  tracker.RecordTo(nullptr);
  tracker.At(200.0);
  EXPECT_EQ(recorder.Path().size(), path.size());
}

} // namespace
