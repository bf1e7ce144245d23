// The chain where its device fails: unplugged, late, without numbers, at any time.
#include "TouchScene.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(HapticChain, AnUnpluggedDeviceGetsNothingAndForcesGrowWhenItIsBack)
{
  SimulatedDeviceSettings hand = HandSettings();
  hand.outages = { { 1.0, 1.5 } };
  HapticChainSettings settings = Settings();
  settings.step.limits.rampInS = 0.5;
  HapticChain chain(
    std::make_unique<SimulatedHapticDevice>(hand, HandIntention(At(0, 0, BallRadius - 5))),
    settings);
  const auto& truth = static_cast<SimulatedHapticDevice&>(chain.Guarded());
  chain.OfferScene(Scene());
  std::int64_t now = 0;
  const double held = Ticks(chain, 998, now).onDevice.force.z;
  EXPECT_GT(held, 0.1);
  Ticks(chain, 3, now);
  EXPECT_EQ(truth.Applied().force, glm::dvec3(0.0));
  const HapticSnapshot away = Ticks(chain, 400, now);
  EXPECT_TRUE(Has(away.status, DeviceStatus::Unplugged));
  EXPECT_EQ(away.onDevice.force, glm::dvec3(0.0));
  EXPECT_GT(away.away, 390u);
  Ticks(chain, 100, now);
  const double first = Ticks(chain, 1, now).onDevice.force.z;
  EXPECT_LE(first, 3.0 / 500.0 * settings.step.limits.force); // the third tick of the ramp's 500
  EXPECT_LT(first, 0.2 * held);
  EXPECT_NEAR(Ticks(chain, 500, now).onDevice.force.z, held, 0.05 * held);
}

/// A device that has nothing new for a while, after a second.
struct Stalling : SimulatedHapticDevice
{
  using SimulatedHapticDevice::SimulatedHapticDevice;
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    if (++this->Reads > 1000 && this->Reads <= 1000 + this->Missing)
    {
      sample = this->Old;
      return DeviceStatus::Stale;
    }
    const DeviceStatus status = SimulatedHapticDevice::Read(nowNs, sample);
    this->Old = sample;
    return status;
  }
  DeviceSample Old;
  int Reads = 0, Missing = 0;
};

TEST(HapticChain, ForcesGrowAgainAfterTheGuardWentSilent)
{
  for (const int missing : { 10, 30, 100 }) // borne, on the way to zero, silent
  {
    HapticChainSettings settings = Settings();
    settings.step.limits.rampInS = 0.5;
    auto made = std::make_unique<Stalling>(HandSettings(), HandIntention(At(0, 0, BallRadius - 5)));
    Stalling& device = *made;
    device.Missing = missing;
    HapticChain chain(std::move(made), settings);
    chain.OfferScene(Scene());
    std::int64_t now = 0;
    const double held = Ticks(chain, 1000, now).onDevice.force.z;
    EXPECT_GT(held, 0.1);
    Ticks(chain, missing, now);
    const double left = device.Applied().force.z;
    const double first = missing == 10 ? held : missing == 30 ? 0.5 * held : 0.0;
    EXPECT_NEAR(left, first, 0.1 * held) << missing;
    Ticks(chain, 1, now);
    if (missing == 10)
      EXPECT_NEAR(device.Applied().force.z, held, 0.05 * held);
    else
      EXPECT_LE(device.Applied().force.z, 1.001 / 500.0 * settings.step.limits.force) << missing;
    EXPECT_NEAR(Ticks(chain, 800, now).onDevice.force.z, held, 0.05 * held) << missing;
  }
}

/// A device that says what cannot be, every third tick.
struct NoPose : SimulatedHapticDevice
{
  using SimulatedHapticDevice::SimulatedHapticDevice;
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override
  {
    const DeviceStatus status = SimulatedHapticDevice::Read(nowNs, sample);
    if (++this->Reads % 3 == 0)
      sample.pose.position.x = std::nan("");
    return status;
  }
  int Reads = 0;
};

TEST(HapticChain, NaNNeverLeaves)
{
  HapticChain chain(
    std::make_unique<NoPose>(HandSettings(), HandIntention(At(0, 0, BallRadius - 5))), Settings());
  const auto& truth = static_cast<SimulatedHapticDevice&>(chain.Guarded());
  chain.OfferScene(Scene());
  std::int64_t now = 0;
  for (int n = 0; n < 300; ++n)
  {
    const HapticSnapshot& seen = Ticks(chain, 1, now);
    ASSERT_TRUE(IsFinite(seen.onDevice));
    ASSERT_TRUE(IsPose(seen.tool) && IsPose(seen.device));
    ASSERT_TRUE(IsFinite(truth.Applied()));
  }
  EXPECT_EQ(chain.Counts().badPoses, 100u);
}

// A recording may say any: the longest tick is what goes by, enough for the clutch to fade in.
TEST(HapticChain, AnyTwoTimesAreATick)
{
  HapticChain chain(HandAt(At(0, 0, BallRadius - 5)), Settings());
  chain.OfferScene(Scene());
  std::int64_t now = std::numeric_limits<std::int64_t>::min();
  EXPECT_GT(Ticks(chain, 500, now).onDevice.force.z, 0.1);
  HapticControl control;
  control.clutched = true;
  chain.Control(control);
  EXPECT_EQ(Ticks(chain, 100, now).onDevice.force, glm::dvec3(0.0));
  chain.Control({});
  chain.Tick(600, std::numeric_limits<std::int64_t>::max());
  EXPECT_GT(chain.Latest()->onDevice.force.z, 0.0);
  chain.Tick(601, std::numeric_limits<std::int64_t>::min());
  EXPECT_TRUE(IsFinite(chain.Latest()->onDevice));
}

} // namespace
