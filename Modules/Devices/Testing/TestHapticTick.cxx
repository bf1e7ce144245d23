// All of a haptic tick but the force of a scene: device, guard, mapping, recorder, on a thread of a
// loop, with a RENDER thread beside it. What is held here holds whatever the machine's clock does;
// the preset tsan looks for races.
#include "Devices/GuardedHapticDevice.h"
#include "Devices/HapticRecorder.h"
#include "Devices/ReplayHapticDevice.h"
#include "Devices/SimulatedHapticDevice.h"
#include "Devices/WorkspaceMapping.h"
#include "Realtime/LoopThread.h"
#include "Realtime/TripleBuffer.h"

#include "Grid/Testing/CountNew.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>

namespace
{

using namespace hasp;

/// A ball at the world's origin that pushes the tool away.
Wrench Ball(const RigidPose& tool)
{
  const double distance = glm::length(tool.position);
  return distance < 20.0 && distance > 0.0
           ? Wrench{ 0.2 * (20.0 - distance) * tool.position / distance }
           : Wrench{};
}

/// What a loop owns. The same object runs on a thread and in virtual time.
struct HapticTick
{
  std::unique_ptr<HapticDevice> device;
  WorkspaceMapping mapping{ { .scale = 2.0 } };
  DeviceSample sample{};
  std::int64_t beforeNs = 0;

  HapticRecord Run(std::uint64_t number, std::int64_t nowNs) noexcept
  {
    HapticRecord record{ .number = number, .nowNs = nowNs };
    record.status = device->Read(nowNs, sample);
    const double dtS = number == 0 ? 0.001 : 1e-9 * static_cast<double>(nowNs - beforeNs);
    const RigidPose& tool = mapping.Update(sample.pose, (sample.buttons & 1) != 0, dtS);
    record.wrench = mapping.ToDevice(Ball(tool));
    device->Write(record.wrench);
    record.sample = sample;
    beforeNs = nowNs;
    return record;
  }
};

std::unique_ptr<HapticDevice> Hand()
{
  SimulatedDeviceSettings settings;
  settings.buttons = { { 0.05, 1 }, { 0.08, 0 } };
  settings.outages = { { 0.10, 0.11 } };
  auto hand = std::make_unique<SimulatedHapticDevice>(settings,
    HandIntention({ { 15, 0, 0 } },
      { MinimumJerkMotion{ { { -15, 2, 0 }, TurnBy({ 0, 0.4, 0 }) }, 0.2 } }, { .reachMm = 0.1 }));
  return std::make_unique<GuardedHapticDevice>(std::move(hand));
}

TEST(HapticTick, WhatAThreadRecordedIsReplayedToTheLastBit)
{
  constexpr std::uint64_t Ticks = 250;
  const std::string file =
    (std::filesystem::temp_directory_path() / ("hasp-tick-" + std::to_string(getpid()))).string();
  HapticRecorder recorder(file, {});
  TripleBuffer<RigidPose> poses; // HAPTIC to RENDER
  std::atomic<std::size_t> allocations{ 0 };
  HapticTick haptic{ Hand() };
  std::int64_t startNs = 0;
  LoopThread loop;
  loop.Start({ .periodNs = 250'000 },
    [&](const LoopTick& tick) noexcept
    {
      const std::size_t before = test::NewCountOfAllThreads();
      if (tick.number == 0)
        startNs = tick.nowNs;
      // A tick every quarter of a ms that tells the device of a ms: seconds go by in less.
      recorder.Push(haptic.Run(tick.number, 4 * (tick.nowNs - startNs)));
      poses.Write(haptic.mapping.Tool());
      // RENDER takes none while it waits below, so that what is counted is the tick's.
      allocations.fetch_add(test::NewCountOfAllThreads() - before, std::memory_order_relaxed);
      return tick.number + 1 < Ticks;
    });
  std::uint64_t seen = 0, faults = 0;
  while (loop.Running())
  {
    if (poses.Update())
    {
      ++seen;
      faults += !(std::abs(glm::length(poses.Latest()->orientation) - 1.0) < 1e-9);
    }
    faults += loop.Rates().ticks > Ticks;
  }
  loop.Stop();
  recorder.Finish();
  EXPECT_EQ(allocations, 0u);
  EXPECT_EQ(faults, 0u);
  EXPECT_GT(seen, 0u);

  const auto recording = std::make_shared<HapticRecording>(ReadHapticRecording(file));
  std::filesystem::remove(file);
  ASSERT_EQ(recording->records.size(), Ticks);
  // The replay stands where the guarded device stood; what the guard would do is in the statuses.
  auto made = std::make_unique<ReplayHapticDevice>(recording);
  ReplayHapticDevice& replay = *made;
  HapticTick again{ std::move(made) };
  for (std::uint64_t number = 0; number < Ticks; ++number)
    again.Run(number, *replay.NextNs());
  EXPECT_EQ(replay.Differences().compared, Ticks);
  EXPECT_EQ(replay.Differences().different, 0u);
  std::uint64_t pushed = 0;
  for (const HapticRecord& record : recording->records)
    pushed += record.wrench.force != glm::dvec3(0.0);
  EXPECT_GT(pushed, 0u) << "the ball was met, else this compared zeros";
}

/// On the machine's own clock, which stands at its uptime.
TEST(HapticTick, ASimulatedHandRunsOnAThreadsClock)
{
  auto made = std::make_unique<SimulatedHapticDevice>(
    SimulatedDeviceSettings{}, HandIntention({}, { ImpactMotion{ { 50, 0, 0 }, 100.0 } }));
  const SimulatedHapticDevice& simulated = *made;
  GuardedHapticDevice device(std::move(made));
  DeviceSample sample;
  std::uint64_t good = 0;
  LoopThread loop;
  loop.Start({},
    [&](const LoopTick& tick) noexcept
    {
      good += device.Read(tick.nowNs, sample) == DeviceStatus::Ok;
      device.Write({ -0.1 * sample.pose.position });
      return tick.number + 1 < 50;
    });
  while (loop.Running())
    std::this_thread::yield();
  loop.Stop();
  EXPECT_EQ(loop.Rates().ticks, 50u);
  EXPECT_EQ(good, 50u);
  EXPECT_GT(simulated.Hand().Pose().position.x, 0.1) << "the hand moved";
}

/// A step that gives NaN for a while, then dies; a hand that is pressed meanwhile.
TEST(HapticTick, AStepThatGoesWrongNeverPullsTheHand)
{
  auto made = std::make_unique<SimulatedHapticDevice>(SimulatedDeviceSettings{},
    HandIntention({ { 15, 0, 0 } }, { ImpactMotion{ { -100, 0, 0 }, 0.3 } }));
  const SimulatedHapticDevice& simulated = *made;
  GuardedHapticDevice device(std::move(made));
  DeviceSample sample;
  for (int ms = 0; ms < 400; ++ms)
  {
    device.Read(std::int64_t(1'000'000) * ms, sample);
    if (ms < 100)
      device.Write({ { 2, 0, 0 } });
    else if (ms < 150)
      device.Write({ { std::nan(""), 2, 2 } });
    else if (ms < 200)
      device.Write({ { 1e300, -1e300, 1e300 } });
    const double force = glm::length(simulated.Applied().force);
    EXPECT_LE(force, TouchProfile().peakForceN * (1.0 + 1e-12)) << ms;
    if ((ms >= 100 && ms < 150) || ms >= 200 + 40)
    {
      EXPECT_EQ(force, 0.0) << ms;
    }
  }
  EXPECT_EQ(device.Counts().badWrenches, 50u);
  EXPECT_EQ(device.Counts().ramps, 1u);
}

} // namespace
