#include "Devices/SimulatedHapticDevice.h"

#include "Grid/Testing/CountNew.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;

SimulatedDeviceSettings Exact(int delayTicks = 0)
{
  SimulatedDeviceSettings settings{ .profile = PremiumProfile() };
  settings.profile.positionQuantumMm = settings.profile.angleQuantumRad = 0.0;
  settings.profile.delayTicks = delayTicks;
  return settings;
}

TEST(DeviceProfile, TheProfilesAreValidAndDiffer)
{
  for (const DeviceProfile& profile :
    { GenericProfile(), FalconProfile(), TouchProfile(), PremiumProfile() })
    EXPECT_NO_THROW(ValidateDeviceProfile(profile)) << profile.name;
  EXPECT_EQ(FalconProfile().peakForceN, 8.9);
  EXPECT_EQ(TouchProfile().peakForceN, 3.3);
  EXPECT_EQ(PremiumProfile().peakForceN, 22.0);
  EXPECT_EQ(FalconProfile().poseAxes, 3);
  EXPECT_EQ(TouchProfile().forceAxes, 3);
}

TEST(DeviceProfile, WhatIsNoDeviceIsRefused)
{
  const auto refused = [](auto change)
  {
    DeviceProfile profile;
    change(profile);
    EXPECT_THROW(ValidateDeviceProfile(profile), std::invalid_argument);
  };
  refused([](DeviceProfile& p) { p.poseAxes = 4; });
  refused([](DeviceProfile& p) { p.forceAxes = 1; });
  refused([](DeviceProfile& p) { p.buttons = 33; });
  refused([](DeviceProfile& p) { p.workspaceMm.y = 0.0; });
  refused([](DeviceProfile& p) { p.peakForceN = std::nan(""); });
  refused([](DeviceProfile& p) { p.continuousForceN = 2.0 * p.peakForceN; });
  refused([](DeviceProfile& p) { p.delayTicks = 17; });
  refused([](DeviceProfile& p) { p.positionQuantumMm = -1.0; });
}

TEST(DeviceProfile, ForcesAreShortenedAndKeepTheirDirection)
{
  const DeviceProfile premium = PremiumProfile();
  const Wrench far{ { 300, -400, 0 }, { 0, 0, 1000 } };
  const Wrench clamped = ClampToProfile(premium, far);
  EXPECT_LT(glm::length(clamped.force - glm::dvec3(0.6, -0.8, 0) * 22.0), 1e-12);
  EXPECT_LT(glm::length(clamped.torque - glm::dvec3(0, 0, 188)), 1e-12);
  const Wrench small{ { 1, 2, 3 }, { 4, 5, 6 } };
  EXPECT_EQ(ClampToProfile(premium, small).force, small.force);
  EXPECT_EQ(ClampToProfile(premium, small).torque, small.torque);
  EXPECT_EQ(ClampToProfile(TouchProfile(), small).torque, glm::dvec3(0.0));
  DeviceProfile input;
  input.forceAxes = 0;
  EXPECT_EQ(ClampToProfile(input, small).force, glm::dvec3(0.0));
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), 1e300 })
  {
    const Wrench out = ClampToProfile(premium, { { bad, 1, 1 }, { 1, bad, 1 } });
    EXPECT_TRUE(glm::length(out.force) <= 22.0 && glm::length(out.torque) <= 188.0) << bad;
  }
}

TEST(SimulatedHapticDevice, TimesThatAreNoneAreRefused)
{
  SimulatedDeviceSettings settings;
  settings.buttons = { { 1.0, 1 }, { 0.5, 0 } };
  EXPECT_THROW(SimulatedHapticDevice(settings, HandIntention()), std::invalid_argument);
  settings.buttons = {};
  settings.outages = { { 1.0, 0.5 } };
  EXPECT_THROW(SimulatedHapticDevice(settings, HandIntention()), std::invalid_argument);
  settings.outages = { { std::nan(""), 0.5 } };
  EXPECT_THROW(SimulatedHapticDevice(settings, HandIntention()), std::invalid_argument);
}

TEST(SimulatedHapticDevice, SaysWhereTheHandIsToTheEncodersCount)
{
  SimulatedDeviceSettings settings = Exact();
  settings.profile.positionQuantumMm = 0.05;
  settings.profile.angleQuantumRad = 0.002;
  SimulatedHapticDevice device(settings,
    HandIntention({}, { MinimumJerkMotion{ { { 17, -9, 4 }, TurnBy({ 0.3, 0.1, -0.4 }) }, 0.3 } },
      { .reachMm = 0.1 }));
  DeviceSample sample;
  double most = 0.0;
  for (int ms = 1; ms <= 400; ++ms)
  {
    ASSERT_EQ(device.Read(ms * Ms, sample), DeviceStatus::Ok);
    EXPECT_EQ(sample.timeNs, ms * Ms);
    const RigidPose& truth = device.Hand().Pose();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double counts = sample.pose.position[axis] / 0.05;
      EXPECT_NEAR(counts, std::round(counts), 1e-9);
      const double off = std::abs(sample.pose.position[axis] - truth.position[axis]);
      EXPECT_LE(off, 0.025 + 1e-12);
      most = std::max(most, off);
      const double turns = RotationVector(sample.pose.orientation)[axis] / 0.002;
      EXPECT_NEAR(turns, std::round(turns), 1e-9);
    }
    EXPECT_LE(
      glm::length(RotationVector(sample.pose.orientation * glm::conjugate(truth.orientation))),
      0.001 * std::sqrt(3.0) * 1.01); // half a count on each axis; turns do not quite add up
  }
  EXPECT_GT(most, 0.024) << "counts were seen";
}

TEST(SimulatedHapticDevice, ThePoseIsAsOldAsTheDelaySays)
{
  for (const int delay : { 0, 1, 3, 16 })
  {
    SimulatedHapticDevice device(
      Exact(delay), HandIntention({}, { ImpactMotion{ { 50, 0, 0 }, 1.0 } }));
    std::vector<RigidPose> truth;
    DeviceSample sample;
    for (int tick = 0; tick < 60; ++tick)
    {
      device.Read((tick + 1) * Ms, sample);
      truth.push_back(device.Hand().Pose());
      const int old = std::max(0, tick - delay);
      EXPECT_EQ(sample.pose.position, truth[old].position) << delay << " " << tick;
      EXPECT_EQ(sample.timeNs, (old + 1) * Ms);
    }
  }
}

TEST(SimulatedHapticDevice, TheSameTimeAgainIsNothingNew)
{
  SimulatedHapticDevice device(Exact(1), HandIntention({}, { ImpactMotion{ { 50, 0, 0 }, 1.0 } }));
  DeviceSample sample, again;
  EXPECT_EQ(device.Read(0, sample), DeviceStatus::Ok);
  device.Read(1 * Ms, sample);
  device.Read(2 * Ms, sample);
  EXPECT_EQ(device.Read(2 * Ms, again), DeviceStatus::Stale);
  EXPECT_EQ(again.timeNs, sample.timeNs) << "the cable does not move on";
}

/// Poses and times of 200 ms, from this first Read on.
std::vector<DeviceSample> TwoHundredMs(std::int64_t firstNs)
{
  SimulatedDeviceSettings settings;
  settings.buttons = { { 0.05, 1 } };
  settings.outages = { { 0.1, 0.11 } };
  SimulatedHapticDevice device(
    settings, HandIntention({}, { ImpactMotion{ { 50, 3, 0 }, 0.2 } }, { .reachMm = 0.1 }));
  std::vector<DeviceSample> samples(200);
  for (int ms = 0; ms < 200; ++ms)
  {
    device.Read(firstNs + ms * Ms, samples[ms]);
    device.Write({ -0.2 * samples[ms].pose.position });
  }
  EXPECT_EQ(device.Hand().TimeNs(), 199 * Ms);
  return samples;
}

TEST(SimulatedHapticDevice, TheHandBeginsWithTheFirstReadWhateverTheClockSays)
{
  // 10^15 ns: a machine that has been up for 11 days.
  const std::vector<DeviceSample> early = TwoHundredMs(0),
                                  late = TwoHundredMs(1'000'000'000'000'000);
  for (std::size_t ms = 0; ms < early.size(); ++ms)
  {
    EXPECT_EQ(late[ms].pose.position, early[ms].pose.position) << ms;
    EXPECT_EQ(late[ms].pose.orientation, early[ms].pose.orientation) << ms;
    EXPECT_EQ(late[ms].buttons, early[ms].buttons) << ms;
    const bool out = ms >= 100 && ms < 110;
    EXPECT_EQ(late[ms].timeNs, out ? 0 : early[ms].timeNs + 1'000'000'000'000'000) << ms;
  }
  EXPECT_GT(early[199].pose.position.x, 1.0) << "it moved";
  EXPECT_EQ(early[99].buttons, 1u);
}

TEST(SimulatedHapticDevice, APauseIsNoLongerThanTheLongestReadForTheHand)
{
  SimulatedHapticDevice device(Exact(), HandIntention({}, { ImpactMotion{ { 50, 0, 0 }, 1.0 } }));
  constexpr std::int64_t Longest = SimulatedHapticDevice::LongestReadNs;
  DeviceSample sample;
  device.Read(0, sample);
  device.Read(Longest, sample);
  EXPECT_EQ(device.Hand().TimeNs(), Longest) << "so long a tick is one";
  constexpr std::int64_t Hour = 3'600'000'000'000;
  ASSERT_EQ(device.Read(Hour, sample), DeviceStatus::Ok);
  EXPECT_EQ(sample.timeNs, Hour);
  EXPECT_EQ(device.Hand().TimeNs(), 2 * Longest);
  device.Read(Hour + Ms, sample);
  EXPECT_EQ(device.Hand().TimeNs(), 2 * Longest + Ms) << "and goes on from there";
}

/// A recording may say any, and a clock be set.
TEST(SimulatedHapticDevice, AnyTwoTimesAreATick)
{
  constexpr std::int64_t First = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t Last = std::numeric_limits<std::int64_t>::max();
  SimulatedHapticDevice device(Exact(), HandIntention());
  DeviceSample sample;
  device.Read(First, sample);
  EXPECT_EQ(device.Read(Last, sample), DeviceStatus::Ok);
  EXPECT_EQ(sample.timeNs, Last);
  EXPECT_EQ(device.Hand().TimeNs(), SimulatedHapticDevice::LongestReadNs);
  EXPECT_EQ(device.Read(First, sample), DeviceStatus::Stale);
  EXPECT_EQ(device.Hand().TimeNs(), SimulatedHapticDevice::LongestReadNs) << "none goes back";
}

TEST(NsBetween, IsExactWhereItFitsAndAsFarAsItReachesWhereNot)
{
  constexpr std::int64_t First = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t Last = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t from : { First, First + 1, -Ms, std::int64_t(0), Ms, Last - 1, Last })
    for (const std::int64_t to : { First, First + 1, -Ms, std::int64_t(0), Ms, Last - 1, Last })
    {
      // 64 bits hold what fits exactly, and round what does not to beyond the end.
      const long double between = static_cast<long double>(to) - static_cast<long double>(from);
      const auto held =
        std::clamp(between, static_cast<long double>(First), static_cast<long double>(Last));
      EXPECT_EQ(NsBetween(from, to), static_cast<std::int64_t>(held)) << from << " " << to;
    }
}

TEST(SimulatedHapticDevice, AForceActsUntilTheNextAndWithinTheProfile)
{
  SimulatedDeviceSettings settings = Exact();
  settings.grip = { .springNPerMm = 0.5, .damperNsPerMm = 0.02 };
  SimulatedHapticDevice device(settings, HandIntention());
  DeviceSample sample;
  device.Read(0, sample);
  device.Write({ { 1e6, 0, 0 } });
  EXPECT_EQ(device.Applied().force, glm::dvec3(22, 0, 0));
  device.Write({ { 5, 0, 0 } });
  for (int ms = 1; ms <= 1000; ++ms)
    device.Read(ms * Ms, sample); // written once
  EXPECT_NEAR(sample.pose.position.x, 10.0, 1e-6);
  device.Write({ { std::nan(""), 0, 0 } });
  EXPECT_EQ(device.Applied().force, glm::dvec3(0.0));
}

TEST(SimulatedHapticDevice, ThreeAxesKnowNoTurnAndFeelNone)
{
  const SimulatedDeviceSettings settings{ .profile = FalconProfile() };
  SimulatedHapticDevice device(
    settings, HandIntention({}, { MinimumJerkMotion{ { {}, TurnBy({ 0.3, 0.0, 0.0 }) }, 0.1 } }));
  DeviceSample sample;
  for (int ms = 1; ms <= 100; ++ms)
  {
    device.Read(ms * Ms, sample);
    EXPECT_EQ(sample.pose.orientation, glm::dquat(1, 0, 0, 0));
    device.Write({ {}, { 100, 100, 100 } });
    EXPECT_EQ(device.Applied().torque, glm::dvec3(0.0));
  }
  EXPECT_GT(glm::length(RotationVector(device.Hand().Pose().orientation)), 0.1);
}

// m v' = F - b v - c: what the profile says of the device is what the hand feels of it.
TEST(SimulatedHapticDevice, MovesTheMassAndDampingOfItsProfile)
{
  for (const DeviceProfile& profile : { FalconProfile(), TouchProfile(), PremiumProfile() })
    for (const double dry : { 0.0, 0.4 })
    {
      SimulatedDeviceSettings settings{ .profile = profile, .grip = NoGrip() };
      settings.coulombN = dry;
      SimulatedHapticDevice device(settings, HandIntention());
      DeviceSample sample;
      device.Read(0, sample);
      device.Write({ { 1, 0, 0 } });
      for (int ms = 1; ms <= 100; ++ms)
        device.Read(ms * Ms, sample);
      const double b = profile.dampingNsPerMm, perS = 1000.0 * b / profile.movingMassKg;
      const double mmPerS = (1.0 - dry) / b * (1.0 - std::exp(-0.1 * perS));
      EXPECT_NEAR(device.Hand().VelocityMmPerS().x, mmPerS, 1e-3 * mmPerS) << profile.name;
    }
}

TEST(SimulatedHapticDevice, ButtonsAndOutagesComeWhenTheyAreSaid)
{
  SimulatedDeviceSettings settings = Exact();
  settings.buttons = { { 0.010, 1 }, { 0.020, 3 }, { 0.030, 0 } };
  settings.outages = { { 0.025, 0.035 } };
  SimulatedHapticDevice device(settings, HandIntention());
  DeviceSample first;
  device.Read(0, first);
  for (int ms = 1; ms <= 50; ++ms)
  {
    DeviceSample sample{ .buttons = 77 };
    const DeviceStatus status = device.Read(ms * Ms, sample);
    const bool out = ms >= 25 && ms < 35;
    EXPECT_EQ(status, out ? DeviceStatus::Unplugged : DeviceStatus::Ok) << ms;
    const unsigned held = ms < 10 ? 0 : ms < 20 ? 1 : ms < 30 ? 3 : 0;
    EXPECT_EQ(sample.buttons, out ? 77u : held) << ms;
    if (ms == 35)
    {
      EXPECT_EQ(device.Applied().force, glm::dvec3(0.0)) << "plugged in again: no kick";
    }
    EXPECT_EQ(device.Write({ { 1, 0, 0 } }), status);
    EXPECT_EQ(device.Applied().force.x, out ? 0.0 : 1.0);
  }
}

TEST(SimulatedHapticDevice, AForceFromBeforeAnOutageIsGone)
{
  SimulatedDeviceSettings settings = Exact();
  settings.outages = { { 0.010, 0.020 } };
  SimulatedHapticDevice device(settings, HandIntention());
  DeviceSample sample;
  device.Read(0, sample);
  device.Write({ { 1, 0, 0 } });
  for (int ms = 1; ms <= 30; ++ms) // nobody writes again
  {
    device.Read(ms * Ms, sample);
    EXPECT_EQ(device.Applied().force.x, ms < 10 ? 1.0 : 0.0) << ms;
  }
}

/// The largest stiffness of a spring to 0, in N/mm, with which the hand still comes to rest: the
/// loop of device, computer and hand, closed.
double StablestSpring(double massKg, double damping, const HandGrip& grip, int delayTicks)
{
  SimulatedDeviceSettings settings = Exact(delayTicks);
  settings.profile.peakForceN = 1000.0; // stays linear
  settings.profile.movingMassKg = massKg;
  settings.profile.dampingNsPerMm = damping;
  settings.grip = grip;
  const auto grows = [&](double stiffness)
  {
    SimulatedHapticDevice device(settings, HandIntention());
    device.Hand().SetState({ { 0.1, 0, 0 } }, {}, {});
    DeviceSample sample;
    double early = 0.0, late = 0.0;
    for (int ms = 1; ms <= 600; ++ms)
    {
      device.Read(ms * Ms, sample);
      device.Write({ -stiffness * sample.pose.position });
      double& most = ms <= 300 ? early : late;
      most = ms > 100 ? std::max(most, std::abs(device.Hand().Pose().position.x)) : most;
    }
    return late > early || late > 10.0; // what has reached the motors' limit grows no more
  };
  double stable = 0.0, unstable = 100.0;
  while (unstable - stable > 0.005 * unstable)
  {
    const double middle = 0.5 * (stable + unstable);
    (grows(middle) ? unstable : stable) = middle;
  }
  return stable;
}

/// K < (b + b_hand) / (T / 2 + t_d): the linear bound of Colgate and Schenkel, with delay of Gil,
/// Diolaiti and Hulin. It leaves out the mass and the hand's spring, which both help.
TEST(SimulatedHapticDevice, GoesUnstableWhereTheorySaysThatLoopsDo)
{
  const struct
  {
    double massKg, damping;
    HandGrip grip;
  } hands[] = { { 0.12, 0.001, LooseGrip() }, { 0.12, 0.001, FirmGrip() },
    { 0.045, 0.0003, LooseGrip() }, { 0.045, 0.0003, FirmGrip() } };
  for (const auto& hand : hands)
    for (const int delay : { 0, 1, 2 })
    {
      const double bound = (hand.damping + hand.grip.damperNsPerMm) / (0.0005 + 0.001 * delay);
      const double found = StablestSpring(hand.massKg, hand.damping, hand.grip, delay);
      RecordProperty("bound " + std::to_string(bound), std::to_string(found));
      EXPECT_GT(found / bound, 1.0 - 0.005) << "to where the bisection ends";
      EXPECT_LT(found / bound, 1.1) << hand.massKg << " " << delay;
    }
}

TEST(SimulatedHapticDevice, ATickTakesNoMemory)
{
  SimulatedHapticDevice device(
    {}, HandIntention({}, { ChirpMotion{ { 5, 0, 0 } } }, { .reachMm = 0.1 }));
  DeviceSample sample;
  const std::size_t before = test::NewCountOfAllThreads();
  for (int ms = 1; ms <= 50; ++ms)
  {
    device.Read(ms * Ms, sample);
    device.Write({ -0.1 * sample.pose.position });
  }
  EXPECT_EQ(test::NewCountOfAllThreads(), before);
  ::operator delete(::operator new(1));
  EXPECT_EQ(test::NewCountOfAllThreads(), before + 1) << "the counter counts";
}

} // namespace
