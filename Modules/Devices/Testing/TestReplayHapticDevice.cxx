#include "Devices/HapticRecorder.h"
#include "Devices/ReplayHapticDevice.h"
#include "Devices/SimulatedHapticDevice.h"

#include "Grid/Testing/CountNew.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;

/// A wall of 1 N/mm at x = 0: what a haptic step is, made small.
Wrench Wall(const DeviceSample& sample, double stiffness)
{
  return { { -stiffness * std::min(sample.pose.position.x, 0.0), 0, 0 } };
}

std::shared_ptr<HapticRecording> RecordWall(const std::string& file)
{
  SimulatedDeviceSettings settings;
  settings.outages = { { 0.1, 0.11 } };
  SimulatedHapticDevice device(
    settings, HandIntention({ { 5, 0, 0 } }, { MinimumJerkMotion{ { { -8, 0, 0 } }, 0.2 } },
                { .reachMm = 0.1 }));
  HapticRecorder recorder(file, { .poseAxes = 6, .forceAxes = 3, .peakForceN = 3.3 });
  HapticRecord record;
  for (; record.number < 300; ++record.number)
  {
    record.nowNs = static_cast<std::int64_t>(record.number) * Ms;
    record.status = device.Read(record.nowNs, record.sample);
    record.wrench = Wall(record.sample, 1.0);
    device.Write(record.wrench);
    recorder.Push(record);
  }
  recorder.Finish();
  return std::make_shared<HapticRecording>(ReadHapticRecording(file));
}

TEST(ReplayHapticDevice, NeedsARecording)
{
  EXPECT_THROW(ReplayHapticDevice(nullptr), std::invalid_argument);
}

TEST(ReplayHapticDevice, TheSameStepGivesTheSameBitsAgain)
{
  const TemporaryFile file;
  const auto recording = RecordWall(file.Path);
  ReplayHapticDevice replay(recording);
  EXPECT_EQ(replay.Profile().forceAxes, 3);
  EXPECT_EQ(replay.Profile().peakForceN, 3.3);
  for (int round = 0; round < 2; ++round)
  {
    DeviceSample sample;
    std::uint64_t ticks = 0, pressed = 0;
    const std::size_t before = test::NewCountOfAllThreads();
    while (const auto now = replay.NextNs())
    {
      EXPECT_EQ(*now, static_cast<std::int64_t>(ticks) * Ms);
      const DeviceStatus status = replay.Read(*now, sample);
      EXPECT_EQ(Has(status, DeviceStatus::Unplugged), ticks >= 100 && ticks < 110);
      replay.Write(Wall(sample, 1.0));
      pressed += sample.pose.position.x < 0.0;
      ++ticks;
    }
    EXPECT_EQ(test::NewCountOfAllThreads(), before);
    EXPECT_EQ(ticks, 300u);
    EXPECT_GT(pressed, 50u);
    EXPECT_EQ(replay.Differences().compared, 300u);
    EXPECT_EQ(replay.Differences().different, 0u);
    EXPECT_EQ(replay.Read(0, sample), DeviceStatus::Ended);
    EXPECT_EQ(replay.Write({ { 1, 2, 3 } }), DeviceStatus::Ended);
    EXPECT_EQ(replay.Differences().compared, 300u) << "there is no tick to compare with any more";
    EXPECT_EQ(replay.Differences().different, 0u);
    replay.Rewind();
  }
}

TEST(ReplayHapticDevice, AnotherStepIsSeenWithWhereAndHowMuch)
{
  const TemporaryFile file;
  const auto recording = RecordWall(file.Path);
  ReplayHapticDevice replay(recording);
  DeviceSample sample;
  double most = 0.0;
  std::uint64_t number = 0, first = 0;
  for (; replay.NextNs(); ++number)
  {
    replay.Read(0, sample);
    replay.Write(Wall(sample, 1.25));
    const double apart = 0.25 * std::max(0.0, -sample.pose.position.x);
    first = first == 0 && apart > 0.0 ? number : first;
    most = std::max(most, apart);
  }
  EXPECT_GT(replay.Differences().different, 50u);
  EXPECT_EQ(replay.Differences().firstDifferent, first);
  EXPECT_NEAR(replay.Differences().mostForceN, most, 1e-12);
  EXPECT_EQ(replay.Differences().mostTorqueNmm, 0.0);
  replay.Write({ { std::nan(""), 0, 0 } });
  EXPECT_TRUE(std::isinf(replay.Differences().mostForceN));
}

} // namespace
