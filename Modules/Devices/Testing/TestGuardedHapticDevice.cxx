#include "Devices/GuardedHapticDevice.h"
#include "Devices/SimulatedHapticDevice.h"

#include "Grid/Testing/CountNew.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;

/// Says what it is told to say, and keeps what it is told to do.
class Puppet : public HapticDevice
{
public:
  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    if (TakesForce(this->says))
      sample = { nowNs, this->pose, 0 };
    return this->says;
  }
  DeviceStatus Write(const Wrench& wrench) noexcept override
  {
    this->felt = wrench;
    return DeviceStatus::Ok;
  }
  RigidPose pose;
  DeviceStatus says = DeviceStatus::Ok;
  Wrench felt{ { 99, 99, 99 } };

private:
  DeviceProfile Is = PremiumProfile();
};

struct Bench
{
  Bench()
  {
    auto made = std::make_unique<Puppet>();
    puppet = made.get();
    guard = std::make_unique<GuardedHapticDevice>(std::move(made));
  }
  DeviceStatus Read(std::int64_t ms) { return guard->Read(ms * Ms, sample); }
  Puppet* puppet;
  std::unique_ptr<GuardedHapticDevice> guard;
  DeviceSample sample;
};

const Wrench Push{ { 4, 0, 0 }, { 0, 50, 0 } };

TEST(GuardedHapticDevice, NeedsADevice)
{
  EXPECT_THROW(GuardedHapticDevice(nullptr), std::invalid_argument);
  EXPECT_THROW(
    GuardedHapticDevice(std::make_unique<Puppet>(), { .staleNs = -1 }), std::invalid_argument);
}

TEST(GuardedHapticDevice, ForceThatIsNoneLeavesAsZeroAndIsCounted)
{
  Bench bench;
  std::uint64_t bad = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double number : { std::nan(""), std::numeric_limits<double>::infinity() })
      for (const bool torque : { false, true })
      {
        Wrench wrench = Push;
        (torque ? wrench.torque : wrench.force)[axis] = number;
        bench.Read(1);
        bench.guard->Write(wrench);
        EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0));
        EXPECT_EQ(bench.puppet->felt.torque, glm::dvec3(0.0));
        EXPECT_EQ(bench.guard->Counts().badWrenches, ++bad);
      }
  bench.guard->Write({ { 1e9, 0, 0 } });
  EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(22, 0, 0)) << "and never over the limit";
}

TEST(GuardedHapticDevice, APoseThatIsNoneIsNotHandedOnAndEndsTheForce)
{
  Bench bench;
  bench.puppet->pose.position = { 1, 2, 3 };
  bench.Read(1);
  bench.guard->Write(Push);
  EXPECT_EQ(bench.puppet->felt.force, Push.force);
  RigidPose poses[3];
  poses[0].position.y = std::nan("");
  poses[1].orientation = { 0, 0, 0, 0 };
  poses[2].orientation.w = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 3; ++n)
  {
    bench.puppet->pose = poses[n];
    EXPECT_TRUE(Has(bench.Read(2 + n), DeviceStatus::Fault));
    EXPECT_EQ(bench.sample.pose.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0)) << "at once, before anything is written";
    bench.guard->Write(Push);
    EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0));
  }
  EXPECT_EQ(bench.guard->Counts().badPoses, 3u);
  bench.puppet->pose = {};
  EXPECT_EQ(bench.Read(9), DeviceStatus::Ok);
  EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0)) << "no kick from what was written before";
  bench.guard->Write(Push);
  EXPECT_EQ(bench.puppet->felt.force, Push.force);
}

TEST(GuardedHapticDevice, ADeviceThatIsNotWellFeelsNothingFromTheNextTick)
{
  for (const DeviceStatus ill :
    { DeviceStatus::Unplugged, DeviceStatus::NotHomed, DeviceStatus::Fault, DeviceStatus::Ended })
  {
    Bench bench;
    bench.Read(1);
    bench.guard->Write(Push);
    bench.puppet->says = ill;
    EXPECT_EQ(bench.Read(2), ill);
    EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0));
    EXPECT_TRUE(Has(bench.guard->Write(Push), ill));
    EXPECT_EQ(bench.puppet->felt.force, glm::dvec3(0.0));
  }
  Bench bench;
  bench.puppet->says = DeviceStatus::Stale;
  bench.Read(1);
  bench.guard->Write(Push);
  EXPECT_EQ(bench.puppet->felt.force, Push.force) << "a stale pose alone keeps it";
}

/// The loop reads on, and nobody computes: the closed form of the ramp, at each tick.
TEST(GuardedHapticDevice, RampsToZeroWhereNobodyWritesAnyMore)
{
  Bench bench;
  bench.Read(100);
  bench.guard->Write(Push);
  for (int ms = 101; ms <= 200; ++ms)
  {
    bench.Read(ms);
    const double share = std::clamp(1.0 - (ms - 100 - 20) / 20.0, 0.0, 1.0);
    EXPECT_LT(glm::length(bench.puppet->felt.force - share * Push.force), 1e-12) << ms;
    EXPECT_LT(glm::length(bench.puppet->felt.torque - share * Push.torque), 1e-12) << ms;
  }
  EXPECT_EQ(bench.guard->Counts().ramps, 1u);
}

/// The same with a hand on the device, as it would be felt: without the guard the last force stays.
TEST(GuardedHapticDevice, AStalledLoopLetsGoOfTheHand)
{
  const auto run = [](HapticDevice& device, const SimulatedHapticDevice& simulated)
  {
    DeviceSample sample;
    for (int ms = 1; ms <= 500; ++ms)
    {
      device.Read(ms * Ms, sample);
      if (ms < 100)
        device.Write({ { 2, 0, 0 } });
    }
    return simulated.Hand().Pose().position.x;
  };
  SimulatedHapticDevice bare({}, HandIntention());
  EXPECT_GT(run(bare, bare), 10.0);
  auto made = std::make_unique<SimulatedHapticDevice>(SimulatedDeviceSettings{}, HandIntention());
  const SimulatedHapticDevice& inside = *made;
  GuardedHapticDevice guarded(std::move(made));
  EXPECT_LT(std::abs(run(guarded, inside)), 0.5);
}

/// A cable that hangs: the driver has no new pose, and the loop goes on computing from the old one.
/// A wrench is as old as the pose that it is made of.
TEST(GuardedHapticDevice, RampsToZeroWhereThePoseGrowsOld)
{
  Bench bench;
  bench.Read(100);
  bench.guard->Write(Push);
  bench.puppet->says = DeviceStatus::Stale;
  for (int ms = 101; ms <= 200; ++ms)
  {
    bench.Read(ms);
    bench.guard->Write(Push);
    const double share = std::clamp(1.0 - (ms - 100 - 20) / 20.0, 0.0, 1.0);
    EXPECT_LT(glm::length(bench.puppet->felt.force - share * Push.force), 1e-12) << ms;
  }
  EXPECT_EQ(bench.guard->Counts().ramps, 1u);
  bench.puppet->says = DeviceStatus::Ok;
  bench.Read(201);
  bench.guard->Write(Push);
  EXPECT_EQ(bench.puppet->felt.force, Push.force);
}

TEST(GuardedHapticDevice, LeavesADeviceWithoutForce)
{
  Wrench left{ { 99, 99, 99 } };
  struct Witness : Puppet
  {
    explicit Witness(Wrench& last) : Last(last) {}
    ~Witness() override { this->Last = this->felt; }
    Wrench& Last;
  };
  {
    GuardedHapticDevice guard(std::make_unique<Witness>(left));
    DeviceSample sample;
    guard.Read(Ms, sample);
    guard.Write(Push);
  }
  EXPECT_EQ(left.force, glm::dvec3(0.0));
  EXPECT_EQ(left.torque, glm::dvec3(0.0));
}

TEST(GuardedHapticDevice, ATickTakesNoMemory)
{
  Bench bench;
  const std::size_t before = test::NewCountOfAllThreads();
  for (int ms = 1; ms <= 100; ++ms)
  {
    bench.Read(ms);
    bench.guard->Write(ms % 3 ? Push : Wrench{ glm::dvec3(std::nan("")) });
  }
  EXPECT_EQ(test::NewCountOfAllThreads(), before);
}

} // namespace
