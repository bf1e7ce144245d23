#include "Devices/RecordedHeadPose.h"
#include "Devices/SimulatedHeadPath.h"
#include "HeadTrackerBench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

constexpr double Frame = 1.0 / 60;
using State = hasp::HeadTrackerState;

const hasp::HeadPose Away{ { 150, 60, 500 }, hasp::HeadOrientation(0.4, -0.2, 0.1) };

/// The fastest step of a fade over `mm` in `seconds`: 1.5 times the mean speed.
double FadeStep(double mm, double seconds)
{
  return 1.5 * mm * Frame / seconds;
}

TEST(HeadTrackerFlow, AStalePoseEasesToRestWithoutAJumpAndComesBack)
{
  // Poses until 2 s and from 6 s on, elsewhere.
  hasp::HeadTracker tracker = hasp::Track(
    [](double now) -> std::optional<hasp::TimedHeadPose>
    {
      if (now <= 2.0)
        return hasp::TimedHeadPose{ now, Away };
      if (now < 6.0)
        return hasp::TimedHeadPose{ 2.0, Away };
      return hasp::TimedHeadPose{ now, { { -120, 0, 700 }, { 1, 0, 0, 0 } } };
    });
  hasp::Steps steps;
  for (int n = 0; n < 480; ++n)
  {
    const double now = n * Frame;
    const hasp::TrackedHead head = tracker.At(now);
    steps.Add(head.pose);
    const double fromAway = glm::length(head.pose.position - Away.position),
                 fromRest = glm::length(head.pose.position - glm::dvec3(0, 0, 600));
    const auto expect = [&](double from, double to, State state)
    {
      if (now > from && now < to)
      {
        EXPECT_EQ(head.state, state) << now;
      }
    };
    expect(-1.0, 1.99, State::Tracking);
    expect(2.2, 2.49, State::Holding);
    expect(2.52, 3.98, State::Easing);
    expect(2.5 + 1.5 + 2 * Frame, 5.99, State::Resting); // within the stated time
    expect(6.01, 6.38, State::Returning);
    expect(6.0 + 0.4 + 2 * Frame, 9.0, State::Tracking);
    if (now < 2.49)
    {
      EXPECT_LT(fromAway, 1e-9) << now;
    }
    if (now > 2.5 + 1.5 + 2 * Frame && now < 5.99) // within the stated time
    {
      EXPECT_LT(fromRest, 1e-9) << now;
      EXPECT_NEAR(head.latencyS, now + 2 * Frame - 2.0, 1e-9);
    }
    if (now > 6.0 + 0.4 + 2 * Frame)
    {
      EXPECT_LT(glm::length(head.pose.position - glm::dvec3(-120, 0, 700)), 1e-9) << now;
    }
  }
  EXPECT_TRUE(steps.finite);
  // Away to rest 190 mm in 1.5 s, rest to the new place 156 mm in 0.4 s.
  EXPECT_LT(steps.mostMm, 1.01 * FadeStep(156.3, 0.4));
  EXPECT_LT(steps.mostDegrees, 1.01 * FadeStep(26.5, 0.4));
}

/// Drop-outs of every length in the midst of a natural motion: never a step that no head makes.
TEST(HeadTrackerFlow, DropOutsOfAnyLengthMakeNoJump)
{
  const hasp::SimulatedHeadPath path({ .seed = 5 });
  for (const double hole : { 0.02, 0.05, 0.09, 0.12, 0.2, 0.45, 0.55, 1.0, 1.9, 2.5 })
  {
    hasp::HeadTracker tracker = hasp::Track(
      [&](double now)
      {
        const double t = std::fmod(now, 3.0) < hole ? std::floor(now / 3.0) * 3.0 - 1e-3 : now;
        return hasp::TimedHeadPose{ t, path.At(t) };
      });
    hasp::Steps steps;
    for (int n = 0; n < 60 * 30; ++n)
      steps.Add(tracker.At(5.0 + n * Frame).pose);
    EXPECT_TRUE(steps.finite);
    // The fastest of this path is 10 mm a frame; a return over 300 mm in 0.4 s 19 mm.
    EXPECT_LT(steps.mostMm, 30.0) << hole;
    EXPECT_LT(steps.mostDegrees, 6.0) << hole;
  }
}

TEST(HeadTrackerFlow, ATrackerThatFindsTheHeadElsewhereIsFollowedSmoothly)
{
  hasp::HeadTracker tracker = hasp::Track(
    [](double now)
    {
      const double side = std::fmod(now, 2.0) < 1.0 ? -200.0 : 200.0;
      return hasp::TimedHeadPose{ now, { { side + std::sin(40 * now), 0, 600 }, { 1, 0, 0, 0 } } };
    });
  hasp::Steps steps;
  double reached = 0.0;
  for (int n = 0; n < 600; ++n)
  {
    const hasp::TrackedHead head = tracker.At(n * Frame);
    steps.Add(head.pose);
    if (std::fmod(n * Frame, 2.0) > 1.7)
      reached = std::max(reached, std::abs(head.pose.position.x - 200.0));
  }
  EXPECT_LT(steps.mostMm, 45.0); // at once: 400; a fade of 400 in 0.4 s: 25, and begun anew twice
  EXPECT_LT(reached, 10.0);
}

TEST(HeadTrackerFlow, AHeadThatKeepsStillIsNotStale)
{
  hasp::HeadTracker tracker = hasp::Track(
    [](double now) {
      return hasp::TimedHeadPose{ now, Away };
    });
  for (int n = 0; n < 300; ++n)
  {
    const hasp::TrackedHead head = tracker.At(n * Frame);
    EXPECT_EQ(head.state, State::Tracking);
    EXPECT_LT(glm::length(head.pose.position - Away.position), 1e-9);
    EXPECT_LT(head.latencyS, 0.12 + 3 * Frame);
  }
  EXPECT_GT(tracker.Counts().still, 250u);
}

/// A mouse that rests for any while and goes on: followed at once, nothing is faded.
TEST(HeadTrackerFlow, APauseOfTheHeadIsNoBreak)
{
  for (int rest = 1; rest < 40; ++rest)
  {
    hasp::HeadTracker tracker = hasp::Track(
      [&](double now)
      {
        const double x = now < 1.0 ? 50 * now : std::max(50.0, 50 * (now - rest * Frame));
        return hasp::TimedHeadPose{ now, { { x, 0, 600 }, { 1, 0, 0, 0 } } };
      },
      { .predict = false });
    for (int n = 0; n < 150; ++n)
    {
      const hasp::TrackedHead head = tracker.At(n * Frame);
      EXPECT_EQ(head.state, State::Tracking) << rest << " " << n;
    }
  }
}

/// opentrack repeats the pose of a 30 Hz camera at 250 Hz: the repetitions are no news, and the
/// prediction is that of 30 Hz.
TEST(HeadTrackerFlow, RepeatedPosesDoNotSpoilTheVelocity)
{
  const auto truth = [](double t) { return glm::dvec3(200 * t, 0, 600); };
  hasp::HeadTracker tracker = hasp::Track(
    [&](double now)
    {
      const double seen = std::floor(now * 30.0 + 1e-9) / 30.0;
      return hasp::TimedHeadPose{ now, { truth(seen), { 1, 0, 0, 0 } } };
    });
  double most = 0.0;
  for (int n = 0; n < 600; ++n)
  {
    const double now = n / 120.0;
    const glm::dvec3 drawn = tracker.At(now).pose.position;
    if (n > 40)
      most = std::max(most, glm::length(drawn - truth(now + 2 * Frame)));
  }
  EXPECT_LT(most, 1e-6);
}

/// A plugin says the pose before once more, its age in whole milliseconds: when the head was there
/// then jitters by half a one to either side.
TEST(HeadTrackerFlow, APoseGivenAgainWithItsAgeRoundedIsNoNews)
{
  const auto truth = [](double t) { return glm::dvec3(200 * t, 0, 600); };
  for (const double frames : { 60.0, 75.0, 144.0, 240.0 })
  {
    hasp::HeadTracker tracker = hasp::Track(
      [&](double now)
      {
        const double seen = std::floor(now * 30.0 + 1e-9) / 30.0;
        const double age = 1e-3 * std::round(1e3 * (now - seen));
        return hasp::TimedHeadPose{ now - age, { truth(seen), { 1, 0, 0, 0 } } };
      });
    double most = 0.0;
    for (int n = 0; n < int(10 * frames); ++n)
    {
      const double now = n / frames;
      const glm::dvec3 drawn = tracker.At(now).pose.position;
      if (now > 0.5)
        most = std::max(most, glm::length(drawn - truth(now + 2 * Frame)));
    }
    EXPECT_EQ(tracker.Counts().outOfOrder, 0u) << frames;
    EXPECT_EQ(tracker.Counts().still, 0u) << frames;
    EXPECT_LE(tracker.Counts().followed, 301u) << frames; // of 30 Hz, but for the last frame's
    EXPECT_TRUE(tracker.TakeWarnings().empty()) << frames;
    // A line through three poses 33 ms apart, read 67 ms behind the last: weights -7/6, 1/3, 11/6,
    // each on half a millisecond at 200 mm/s.
    EXPECT_LT(most, 0.1 * (7.0 / 6 + 1.0 / 3 + 11.0 / 6)) << frames;
  }
}

/// The head keeps still and is told of every millisecond: not news each time, but never old.
TEST(HeadTrackerFlow, AStillHeadToldOfEachMillisecondIsNotStale)
{
  hasp::HeadTracker tracker = hasp::Track(
    [](double now) {
      return hasp::TimedHeadPose{ now, Away };
    });
  for (int n = 0; n < 3000; ++n)
  {
    const hasp::TrackedHead head = tracker.At(0.001 * n);
    ASSERT_EQ(head.state, State::Tracking) << n;
    ASSERT_LT(glm::length(head.pose.position - Away.position), 1e-9);
  }
}

TEST(HeadTrackerFlow, OrderIsKept)
{
  std::mt19937_64 random(1);
  const hasp::SimulatedHeadPath path;
  std::vector<double> given;
  hasp::HeadTracker tracker = hasp::Track(
    [&](double now)
    {
      // Now and then a pose from before, or the same once more.
      const double t =
        random() % 3 || given.empty()
          ? now
          : given[given.size() - 1 - random() % std::min<std::size_t>(given.size(), 3)];
      given.push_back(t);
      return hasp::TimedHeadPose{ t, path.At(t) };
    });
  double most = 0.0;
  for (int n = 0; n < 1200; ++n)
  {
    const glm::dvec3 drawn = tracker.At(n * Frame).pose.position;
    if (n > 20)
      most = std::max(most, glm::length(drawn - path.At((n + 2) * Frame).position));
  }
  EXPECT_GT(tracker.Counts().outOfOrder, 100u);
  EXPECT_EQ(tracker.Counts().clockJumps, 0u);
  EXPECT_LT(most, 40.0);
  const auto warnings = tracker.TakeWarnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("older than the one before"), std::string::npos);
  EXPECT_TRUE(tracker.TakeWarnings().empty());
}

/// A source whose clock went back says that its poses are old: the head rests, and it is said why.
TEST(HeadTrackerFlow, ClocksThatJumpMakeNoJump)
{
  const hasp::SimulatedHeadPath path;
  for (const double sourceJump : { -1000.0, -1.0, 1000.0 })
    for (const double ourJump : { 0.0, -500.0, -0.5, 500.0 })
    {
      hasp::HeadTracker tracker = hasp::Track(
        [&](double now)
        {
          const double real = now > 400.0 || now < 0.0 ? now - ourJump : now;
          return hasp::TimedHeadPose{ now + (real > 6.0 ? sourceJump : 0.0), path.At(real) };
        });
      hasp::Steps steps;
      hasp::TrackedHead head;
      glm::dvec3 truth;
      for (int n = 0; n < 900; ++n)
      {
        const double real = n * Frame,
                     now = real > 10.0 && std::abs(ourJump) > 1 ? real + ourJump : real;
        head = tracker.At(now);
        steps.Add(head.pose);
        truth = path.At(real + 2 * Frame).position;
      }
      EXPECT_TRUE(steps.finite);
      EXPECT_LT(steps.mostMm, 35.0) << sourceJump << " " << ourJump;
      if (sourceJump < 0.0)
      {
        EXPECT_EQ(head.state, State::Resting);
        EXPECT_GT(tracker.Counts().stale, 100u);
        EXPECT_FALSE(tracker.TakeWarnings().empty());
      }
      else
      {
        EXPECT_EQ(head.state, State::Tracking);
        EXPECT_LT(glm::length(head.pose.position - truth), 40.0) << ourJump;
        EXPECT_GT(tracker.Counts().future, 100u);
      }
    }
}

TEST(HeadTrackerFlow, APauseOfTheProgramEndsWithoutAJump)
{
  const hasp::SimulatedHeadPath path({ .seed = 2 });
  hasp::HeadTracker tracker = hasp::Track(
    [&](double now) {
      return hasp::TimedHeadPose{ now, path.At(now) };
    });
  hasp::Steps steps;
  double now = 0.0;
  for (int n = 0; n < 600; ++n)
  {
    now += n % 100 == 99 ? 3.7 : Frame;
    steps.Add(tracker.At(now).pose);
  }
  // A fade over at most 300 mm begins with a step of 0.1 s of its 0.4: 16 %.
  EXPECT_LT(steps.mostMm, 60.0);
}

TEST(HeadTrackerFlow, TheSameNowIsTheSamePose)
{
  double x = 0.0;
  hasp::HeadTracker tracker = hasp::Track(
    [&](double now) {
      return hasp::TimedHeadPose{ now, { { ++x, 0, 600 }, { 1, 0, 0, 0 } } };
    });
  const hasp::TrackedHead first = tracker.At(1.0);
  EXPECT_EQ(tracker.At(1.0).pose.position, first.pose.position);
  EXPECT_EQ(tracker.At(NAN).pose.position, first.pose.position);
  EXPECT_EQ(tracker.At(INFINITY).pose.position, first.pose.position);
}

/// Whatever times and poses a source makes up: what is drawn is a head, and does not jump.
TEST(HeadTrackerFlow, StiffTimesAndPosesLeaveAHead)
{
  constexpr double Inf = std::numeric_limits<double>::infinity();
  const double deltas[] = { 0.0, 1e-15, 1e-9, 1e-7, 1e-3, Frame, 0.3, 1e9, 1e300, -1e-9, -1.0,
    -1e300, Inf, -Inf, NAN };
  std::mt19937_64 random(7);
  for (int round = 0; round < 60; ++round)
  {
    double at = 0.0;
    hasp::HeadTracker tracker = hasp::Track(
      [&](double now)
      {
        const double delta = deltas[random() % std::size(deltas)];
        at = random() % 8 ? now + (random() % 2 ? 0.0 : delta) : at + delta;
        const double wild[] = { 0.0, 1.0, 100.0, 9000.0, 1e5, NAN };
        return hasp::TimedHeadPose{ at,
          { { wild[random() % 6], wild[random() % 4], 600 },
            random() % 5 ? hasp::HeadOrientation(0.001 * double(random() % 3000), 0, 0)
                         : glm::dquat(0, 0, 0, 0) } };
      });
    double now = 0.0;
    for (int n = 0; n < 400; ++n)
    {
      const double delta = deltas[random() % 6];
      now += random() % 5 ? Frame : delta;
      ASSERT_EQ(hasp::FaultOf(tracker.At(now).pose), hasp::HeadPoseFault::None)
        << round << " " << n;
    }
    EXPECT_GT(tracker.Counts().refused, 0u);
  }
}

/// A minute at 60 Hz with 2 % of the poses lost: how many frames have no pose newer than a
/// prediction reaches?
TEST(HeadTrackerFlow, ARecordedMinuteHasNoHoles)
{
  std::mt19937_64 random(4);
  hasp::HeadPath path =
    hasp::SimulatedHeadPath({ .noiseMm = 0.2, .jitterS = 0.004 }).Record(0, 60, 60);
  std::erase_if(
    path, [&](const hasp::TimedHeadPose& p) { return p.timeS > 1 && random() % 50 == 0; });
  hasp::HeadTracker tracker(std::make_unique<hasp::RecordedHeadPose>(path,
    hasp::PlaybackSettings{ .startS = path.front().timeS, .interpolate = false, .delayS = Frame }));
  int holes = 0;
  double latency = 0.0;
  for (int n = 30; n < 3540; ++n)
  {
    const hasp::TrackedHead head = tracker.At((n + 0.5) * Frame);
    holes += head.state != State::Tracking;
    latency += head.latencyFrames / 3510;
  }
  EXPECT_LT(holes, 0.005 * 3510);
  // Two frames ahead, one of delay, half a frame until the next pose and 2 % of a frame lost.
  EXPECT_NEAR(latency, 3.52, 0.1);
}

} // namespace
