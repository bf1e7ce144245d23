#include "Devices/RecordedHeadPose.h"
#include "Devices/SimulatedHeadPath.h"
#include "HeadTrackerBench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

namespace
{

constexpr double Frame = 1.0 / 60;

TEST(HeadTracker, SettingsOutOfRangeAreRefused)
{
  const auto nothing = [](double) { return std::nullopt; };
  EXPECT_THROW(hasp::HeadTracker(nullptr), std::invalid_argument);
  EXPECT_THROW(hasp::Track(nothing, { .frameS = 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::Track(nothing, { .horizonS = 0.3 }), std::invalid_argument);
  EXPECT_THROW(hasp::Track(nothing, { .fitS = NAN }), std::invalid_argument);
  EXPECT_THROW(hasp::Track(nothing, { .mostPredictedMm = -1 }), std::invalid_argument);
  EXPECT_THROW(hasp::Track(nothing, { .backS = 0 }), std::invalid_argument);
  EXPECT_THROW(
    hasp::Track(nothing, { .rest = { { NAN, 0, 0 }, { 1, 0, 0, 0 } } }), std::invalid_argument);
  EXPECT_THROW(hasp::HeadTracker(std::make_unique<hasp::ScriptedSource>(nothing), {},
                 { .trackerToRoom = glm::dquat(3, 0, 0, 0) }),
    std::invalid_argument);
}

TEST(HeadTracker, BeforeTheFirstPoseTheHeadRests)
{
  hasp::HeadTracker tracker =
    hasp::Track([](double) { return std::nullopt; }, { .rest = { { 1, 2, 555 }, { 1, 0, 0, 0 } } });
  for (double now = 0.0; now < 3.0; now += Frame)
  {
    const hasp::TrackedHead head = tracker.At(now);
    EXPECT_EQ(head.pose.position, glm::dvec3(1, 2, 555));
    EXPECT_EQ(head.state, hasp::HeadTrackerState::Waiting);
    EXPECT_EQ(head.latencyFrames, 0.0);
  }
}

TEST(HeadTracker, CalibrationComesFirst)
{
  hasp::HeadTracker tracker(
    std::make_unique<hasp::ScriptedSource>(
      [](double now) {
        return hasp::TimedHeadPose{ now, { { 0, 0, 100 }, { 1, 0, 0, 0 } } };
      }),
    {}, { .trackerInRoomMm = { 0, 200, 400 }, .eyesInMarkerMm = { 0, -80, 0 } });
  EXPECT_LT(glm::length(tracker.At(1.0).pose.position - glm::dvec3(0, 120, 500)), 1e-9);
}

/// An even motion is predicted exactly, whatever the delay, within the limits.
TEST(HeadTracker, EvenMotionIsPredictedExactly)
{
  const glm::dvec3 velocity(200, -100, 50);
  for (int delay = 0; delay <= 3; ++delay)
  {
    const auto truth = [&](double t)
    {
      return hasp::HeadPose{ glm::dvec3(0, 0, 600) + velocity * t,
        hasp::HeadOrientation(0.5 * t, 0, 0) };
    };
    hasp::HeadTracker tracker = hasp::Track(
      [&](double now)
      {
        const double t = now - delay * Frame;
        return hasp::TimedHeadPose{ t, truth(t) };
      });
    for (int n = 0; n < 60; ++n)
    {
      const double now = n * Frame;
      const hasp::TrackedHead head = tracker.At(now);
      EXPECT_NEAR(head.latencyFrames, 2 + delay, 1e-9);
      if (n < 5)
        continue;
      EXPECT_EQ(head.state, hasp::HeadTrackerState::Tracking);
      EXPECT_NEAR(head.predictedS, (2 + delay) * Frame, 1e-12);
      EXPECT_LT(glm::length(head.pose.position - truth(now + 2 * Frame).position), 1e-7);
      EXPECT_LT(
        hasp::AngleDegrees(head.pose.orientation, truth(now + 2 * Frame).orientation), 2e-6);
    }
  }
}

TEST(HeadTracker, PredictionIsBoundedInTimeLengthAndAngle)
{
  const auto fast = [](double now)
  {
    return hasp::TimedHeadPose{ now - 0.05,
      { { 2000.0 * (now - 0.05), 0, 600 }, hasp::HeadOrientation(10 * (now - 0.05), 0, 0) } };
  };
  hasp::HeadTracker tracker =
    hasp::Track(fast, { .mostPredictedMm = 30, .mostPredictedDegrees = 5 });
  hasp::TrackedHead head;
  for (int n = 0; n < 60; ++n)
    head = tracker.At(n * Frame);
  const hasp::HeadPose newest = fast(59 * Frame).pose;
  EXPECT_NEAR(glm::length(head.pose.position - newest.position), 30.0, 1e-6);
  EXPECT_NEAR(hasp::AngleDegrees(head.pose.orientation, newest.orientation), 5.0, 1e-6);
}

struct Errors
{
  double rmsMm = 0.0, p99Mm = 0.0, rmsDegrees = 0.0;
};

/// A minute of a natural head, recorded at `hz` and given `delay` frames late; drawn at 60 Hz for
/// two frames later. Errors against where the head is then.
Errors ErrorsOf(const hasp::SimulatedHeadSettings& simulated, double hz, int delay, bool predict)
{
  const hasp::SimulatedHeadPath path(simulated);
  const hasp::HeadPath recorded = path.Record(0.0, 60.0, hz);
  hasp::HeadTracker tracker(
    std::make_unique<hasp::RecordedHeadPose>(recorded,
      hasp::PlaybackSettings{
        .startS = recorded.front().timeS, .interpolate = false, .delayS = delay * Frame }),
    { .predict = predict });
  std::vector<double> off;
  double squares = 0.0, degrees = 0.0;
  for (int n = 30; n < 3500; ++n)
  {
    // Between the tracker's ticks, as the two are not in step.
    const double now = (n + 0.4) * Frame;
    const hasp::HeadPose drawn = tracker.At(now).pose, truth = path.At(now + 2 * Frame);
    off.push_back(glm::length(drawn.position - truth.position));
    squares += off.back() * off.back();
    degrees += std::pow(hasp::AngleDegrees(drawn.orientation, truth.orientation), 2);
  }
  std::sort(off.begin(), off.end());
  return { std::sqrt(squares / off.size()), off[off.size() * 99 / 100],
    std::sqrt(degrees / off.size()) };
}

/// The promise: with prediction the error is less than half of that without, at each delay.
TEST(HeadTracker, PredictionHalvesTheErrorAtEachDelay)
{
  std::printf("60 Hz, 0.1 mm and 0.05 degrees of noise, seen two frames later\n"
              "%-6s %10s %10s %10s %10s %10s %10s\n",
    "delay", "mm rms", "predicted", "mm p99", "predicted", "deg rms", "predicted");
  for (int delay = 0; delay <= 3; ++delay)
  {
    const hasp::SimulatedHeadSettings noisy{ .noiseMm = 0.1, .noiseDegrees = 0.05 };
    const Errors without = ErrorsOf(noisy, 60, delay, false),
                 with = ErrorsOf(noisy, 60, delay, true);
    std::printf("%-6d %10.3f %10.3f %10.3f %10.3f %10.3f %10.3f\n", delay, without.rmsMm,
      with.rmsMm, without.p99Mm, with.p99Mm, without.rmsDegrees, with.rmsDegrees);
    EXPECT_LT(with.rmsMm, 0.5 * without.rmsMm) << delay;
    EXPECT_LT(with.p99Mm, 0.5 * without.p99Mm) << delay;
    EXPECT_LT(with.rmsDegrees, 0.5 * without.rmsDegrees) << delay;
  }
}

/// Trackers faster and slower than frames, jitter in their times: still better than without.
TEST(HeadTracker, PredictionHelpsAtOtherRatesAndWithJitter)
{
  for (const double hz : { 30.0, 90.0, 250.0, 1000.0 })
  {
    const hasp::SimulatedHeadSettings s{
      .noiseMm = 0.1, .noiseDegrees = 0.05, .jitterS = 0.3 / hz
    };
    const Errors without = ErrorsOf(s, hz, 1, false), with = ErrorsOf(s, hz, 1, true);
    std::printf("%6.0f Hz: %.3f mm without, %.3f with\n", hz, without.rmsMm, with.rmsMm);
    EXPECT_LT(with.rmsMm, 0.5 * without.rmsMm) << hz;
  }
}

TEST(HeadTracker, AStillHeadWithNoiseIsHardlyWorseThanItsTracker)
{
  const Errors without = ErrorsOf(
    { .reachMm = {}, .reachDegrees = {}, .noiseMm = 0.3, .noiseDegrees = 0.1 }, 60, 0, false);
  const Errors with = ErrorsOf(
    { .reachMm = {}, .reachDegrees = {}, .noiseMm = 0.3, .noiseDegrees = 0.1 }, 60, 0, true);
  std::printf("still: %.3f mm without, %.3f with\n", without.rmsMm, with.rmsMm);
  EXPECT_LT(with.rmsMm, 1.3 * without.rmsMm);
  EXPECT_LT(with.rmsDegrees, 1.3 * without.rmsDegrees);
}

/// One pose of twenty is anywhere: it is not followed.
TEST(HeadTracker, WildPosesAreNotFollowed)
{
  const hasp::SimulatedHeadPath path({ .noiseMm = 0.1 });
  hasp::HeadPath recorded = path.Record(0.0, 30.0, 60.0);
  std::mt19937_64 random(3);
  for (std::size_t n = 10; n < recorded.size(); n += 20)
    recorded[n].pose.position += glm::dvec3(double(random() % 1000) - 500.0, 300.0, 0.0);
  hasp::HeadTracker tracker(std::make_unique<hasp::RecordedHeadPose>(
    recorded, hasp::PlaybackSettings{ .interpolate = false }));
  double most = 0.0;
  for (int n = 5; n < 1700; ++n)
    most = std::max(most, glm::length(tracker.At((n + 0.4) * Frame).pose.position -
                                      path.At((n + 2.4) * Frame).position));
  EXPECT_LT(most, 30.0); // prediction alone: 15; a followed one: 300 and more
}

TEST(HeadTracker, TheSourcesDelayIsBridged)
{
  const hasp::SimulatedHeadPath path;
  const auto error = [&](double known)
  {
    hasp::HeadTracker tracker = hasp::Track( // poses are 40 ms older than their stamps
      [&](double now) {
        return hasp::TimedHeadPose{ now, path.At(now - 0.04) };
      },
      { .sourceDelayS = known });
    double sum = 0.0;
    for (int n = 0; n < 600; ++n)
    {
      const glm::dvec3 off =
        tracker.At(n * Frame).pose.position - path.At((n + 2) * Frame).position;
      sum += n < 10 ? 0.0 : glm::dot(off, off);
    }
    return std::sqrt(sum / 590);
  };
  EXPECT_LT(error(0.04), 0.6 * error(0.0));
}

} // namespace
