#include "Devices/Drivers/DeviceTrial.h"
#include "Devices/Drivers/ForceTrial.h"
#include "Grid/FinitePose.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

using namespace hasp;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

TEST(ForceTrial, NothingIsDoneWithoutAHandOnIt)
{
  for (const double held : { 0.0, -1.0, NaN, HUGE_VAL })
    for (const auto kind :
      { ForceTrial::Kind::None, ForceTrial::Kind::Axes, ForceTrial::Kind::Steady })
      EXPECT_EQ(WrenchOf({ .kind = kind }, held).force, glm::dvec3(0.0));
  EXPECT_EQ(WrenchOf({}, 1.0).force, glm::dvec3(0.0));
}

TEST(ForceTrial, EachAxisGrowsAndFades)
{
  const ForceTrial trial{ .kind = ForceTrial::Kind::Axes, .newton = 2.0 };
  EXPECT_NEAR(glm::distance(WrenchOf(trial, 0.5).force, { 2, 0, 0 }), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(WrenchOf(trial, 1.5).force, { -2, 0, 0 }), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(WrenchOf(trial, 2.5).force, { 0, 2, 0 }), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(WrenchOf(trial, 5.5).force, { 0, 0, -2 }), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(WrenchOf(trial, 6.5).force, { 2, 0, 0 }), 0.0, 1e-12);
  glm::dvec3 before(0.0);
  for (int ms = 1; ms < 12'000; ++ms)
  {
    const glm::dvec3 force = WrenchOf(trial, 0.001 * ms).force;
    ASSERT_LT(glm::distance(force, before), 2.0 * 0.0032) << "no jump at " << ms;
    before = force;
  }
}

TEST(ForceTrial, IsNeverMoreThanGentle)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 1e3);
  for (const double newton : { -5.0, 0.0, 3.0, 1e300, NaN, HUGE_VAL })
    for (int n = 0; n < 1000; ++n)
      for (const auto kind : { ForceTrial::Kind::Axes, ForceTrial::Kind::Steady })
      {
        const glm::dvec3 direction{ normal(random), n % 7 == 0 ? NaN : normal(random),
          n % 11 == 0 ? 1e200 : 0.0 };
        const Wrench out = WrenchOf({ kind, newton, direction }, std::abs(normal(random)));
        ASSERT_TRUE(IsFinite(out));
        ASSERT_LE(glm::length(out.force), ForceTrial::mostN * (1 + 1e-12));
      }
  EXPECT_EQ(
    WrenchOf({ ForceTrial::Kind::Steady, 1.0, glm::dvec3(0.0) }, 1.0).force, glm::dvec3(0.0));
}

TEST(FitScale, FindsTheShareAndSaysHowSure)
{
  const std::vector<ScaleReading> readings{ { 1, 0.5 }, { 2, 1.0 }, { 3, 1.5 } };
  const ScaleFit fit = FitScale(readings);
  EXPECT_DOUBLE_EQ(fit.share, 0.5);
  EXPECT_NEAR(fit.rmsN, 0.0, 1e-15);
  std::vector<ScaleReading> noisy;
  std::mt19937 random(2);
  std::normal_distribution<double> error(0.0, 0.02);
  for (int n = 0; n < 400; ++n)
    noisy.push_back({ 1.0 + n % 3, 1.3 * (1.0 + n % 3) + error(random) });
  const ScaleFit other = FitScale(noisy);
  EXPECT_NEAR(other.share, 1.3, 5.0 * 0.02 / std::sqrt(400.0 * 14.0 / 3.0));
  EXPECT_NEAR(other.rmsN, 0.02, 0.003);
  EXPECT_GT(other.worstN, other.rmsN);
}

TEST(FitScale, RefusesWhatCannotBe)
{
  const auto refused = [](std::vector<ScaleReading> readings)
  { EXPECT_THROW(FitScale(readings), std::invalid_argument); };
  refused({});
  refused({ { 1, 1 }, { 2, 2 } });
  refused({ { 1, 1 }, { 2, 2 }, { 3, NaN } });
  refused({ { 1, 1 }, { 2, 2 }, { 0, 3 } });
  refused({ { 1, 1 }, { 2, 2 }, { 3, -3 } });
  refused({ { 1, 1 }, { 1.1, 1.1 }, { 1.2, 1.2 } }); // too near to each other
  refused({ { 1, 50 }, { 2, 100 }, { 3, 150 } });    // grams
  refused({ { 1, 0.01 }, { 2, 0.02 }, { 3, 0.03 } });
}

/// A device whose button a test holds.
class ButtonDevice : public HapticDevice
{
public:
  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    sample.timeNs = nowNs;
    sample.buttons = this->buttons.load();
    return this->status.load();
  }
  DeviceStatus Write(const Wrench& wrench) noexcept override
  {
    this->newton.store(glm::length(wrench.force));
    return this->status.load();
  }
  std::atomic<std::uint32_t> buttons{ 0 };
  std::atomic<DeviceStatus> status{ DeviceStatus::Ok };
  std::atomic<double> newton{ -1.0 };

private:
  DeviceProfile Is = FalconProfile();
};

/// Until it holds, however slow this machine is; ctest ends what never does.
template <class Holds>
void Until(DeviceTrial& trial, Holds holds)
{
  const std::uint64_t from = trial.Look().ticks;
  MonotonicClock clock;
  while (!holds(trial.Look()) || trial.Look().ticks < from + 3)
    clock.SleepUntil(clock.NowNs() + 1'000'000);
}

TEST(DeviceTrial, ForceIsThereAsLongAsTheButtonIsHeld)
{
  ButtonDevice device;
  device.buttons = 1; // stuck from the beginning
  {
    DeviceTrial trial(device);
    trial.Ask({ .kind = ForceTrial::Kind::Steady, .newton = 1.5 });
    Until(trial, [](const DeviceSight& seen) { return seen.ticks > 20; });
    EXPECT_EQ(device.newton.load(), 0.0);
    device.buttons = 0;
    Until(trial, [](const DeviceSight& seen) { return seen.sample.buttons == 0; });
    device.buttons = 1;
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 1.5; });
    device.status = DeviceStatus::NotHomed;
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 0.0; });
    device.status = DeviceStatus::Ok;
    device.buttons = 0;
    Until(trial, [](const DeviceSight& seen) { return seen.sample.buttons == 0; });
    device.buttons = 1;
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 1.5; });
    device.status = DeviceStatus::Stale; // it has fallen silent, its button as it was
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 0.0; });
    device.status = DeviceStatus::Ok;
    Until(trial, [](const DeviceSight& seen) { return seen.status == DeviceStatus::Ok; });
    EXPECT_EQ(device.newton.load(), 0.0) << "until the button was seen up again";
    device.buttons = 0;
    Until(trial, [](const DeviceSight& seen) { return seen.sample.buttons == 0; });
    device.buttons = 1;
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 1.5; });
    device.buttons = 2; // another one
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 0.0; });
    device.buttons = 1;
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 1.5; });
    trial.Ask({});
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 0.0; });
    trial.Ask({ .kind = ForceTrial::Kind::Steady, .newton = 1.5 });
    Until(trial, [&](const DeviceSight&) { return device.newton.load() == 1.5; });
  }
  EXPECT_EQ(device.newton.load(), 0.0) << "at the end";
}

} // namespace
