#include "Devices/Drivers/ForceGate.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace hasp;

constexpr std::int64_t TickNs = 1'000'000;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A gate that was ready and written to for so long that its ramp is over.
struct Warm
{
  explicit Warm(const ForceGateSettings& settings = {}) : gate(FalconProfile(), settings)
  {
    for (int n = 0; n < 700; ++n)
      this->Tick(this->wanted);
  }
  Wrench Tick(const Wrench& wrench, bool ready = true)
  {
    this->nowNs += TickNs;
    this->gate.Want(wrench, this->nowNs);
    return this->gate.At(this->nowNs, ready);
  }
  Wrench Silent(bool ready = true)
  {
    this->nowNs += TickNs;
    return this->gate.At(this->nowNs, ready);
  }
  ForceGate gate;
  Wrench wanted{ { 3, 0, 4 }, {} };
  std::int64_t nowNs = 0;
};

TEST(ForceGate, LetsThroughWhatADeviceGives)
{
  Warm warm;
  EXPECT_EQ(warm.Tick(warm.wanted).force, warm.wanted.force);
}

TEST(ForceGate, BeginsWithNothingAndRampsIn)
{
  ForceGate gate(FalconProfile());
  const double most = FalconProfile().peakForceN;
  for (int n = 0; n <= 600; ++n)
  {
    gate.Want({ { 0, 0, 100 }, {} }, n * TickNs);
    const double force = glm::length(gate.At(n * TickNs, true).force);
    ASSERT_LE(force, most * std::min(1.0, n / 500.0) + 1e-9) << n;
  }
  EXPECT_NEAR(glm::length(gate.At(600 * TickNs, true).force), most, 1e-9);
}

TEST(ForceGate, IsZeroAtOnceForEachReason)
{
  for (const auto& wrong : { Wrench{ { NaN, 0, 0 }, {} }, Wrench{ { 0, HUGE_VAL, 0 }, {} },
         Wrench{ { 0, 0, 1 }, { 0, 0, NaN } } })
  {
    Warm warm;
    EXPECT_EQ(warm.Tick(wrong).force, glm::dvec3(0.0));
    EXPECT_LT(glm::length(warm.Tick(warm.wanted).force), 0.1) << "it ramps in again";
  }
  Warm warm;
  EXPECT_EQ(warm.Tick(warm.wanted, false).force, glm::dvec3(0.0)) << "unplugged or not homed";
  EXPECT_EQ(warm.Silent().force, glm::dvec3(0.0)) << "what was wanted before never comes back";
  EXPECT_LT(glm::length(warm.Tick(warm.wanted).force), 0.1);
}

TEST(ForceGate, ASimulationThatStallsIsSilentWithin40Ms)
{
  Warm warm;
  double before = 5.0;
  for (int ms = 1; ms <= 60; ++ms)
  {
    const double force = glm::length(warm.Silent().force);
    ASSERT_GE(force, ms <= 20 ? 5.0 - 1e-12 : 0.0) << ms;
    ASSERT_LE(force, before + 1e-12) << ms;
    ASSERT_GE(force, before - 0.3) << "evenly, ms " << ms;
    ASSERT_LE(force, ms >= 40 ? 0.0 : 5.0 + 1e-12) << ms;
    before = force;
  }
  EXPECT_LT(glm::length(warm.Tick(warm.wanted).force), 0.1) << "and comes back from nothing";
}

// Whatever is wanted, and whenever: finite, within the norm and the slew.
TEST(ForceGate, NothingWrongEverLeaves)
{
  ForceGate gate(PremiumProfile());
  const DeviceProfile profile = PremiumProfile();
  std::mt19937 random(3);
  std::uniform_int_distribution<int> kind(0, 11);
  std::normal_distribution<double> normal;
  const auto number = [&]() -> double
  {
    switch (kind(random))
    {
      case 0:
        return NaN;
      case 1:
        return -std::numeric_limits<double>::infinity();
      case 2:
        return std::numeric_limits<double>::max();
      case 3:
        return std::numeric_limits<double>::denorm_min();
      case 4:
        return 1e200;
      default:
        return 30.0 * normal(random);
    }
  };
  Wrench before;
  std::int64_t nowNs = 0;
  for (int n = 0; n < 100'000; ++n)
  {
    const std::int64_t passed = kind(random) == 0 ? 60 * TickNs : TickNs;
    nowNs += passed;
    if (kind(random) > 1)
      gate.Want({ { number(), number(), number() }, { number(), number(), number() } }, nowNs);
    const Wrench out = gate.At(nowNs, kind(random) > 0);
    ASSERT_TRUE(IsFinite(out));
    ASSERT_LE(glm::length(out.force), profile.peakForceN * (1.0 + 1e-12));
    ASSERT_LE(glm::length(out.torque), profile.peakTorqueNmm * (1.0 + 1e-12));
    ASSERT_LE(glm::length(out.force) - glm::length(before.force),
      2000.0 * 1e-9 * static_cast<double>(passed) + 1e-9);
    before = out;
  }
}

TEST(ForceGate, AClockThatIsSetBackGivesNoMore)
{
  Warm warm;
  warm.nowNs = 1000;
  EXPECT_LE(glm::length(warm.Silent().force), 5.0);
  for (int n = 0; n < 100; ++n)
    ASSERT_LE(glm::length(warm.Tick(warm.wanted).force), 5.0 + 1e-12);
}

TEST(ForceGate, ADeviceWithoutMotorsGetsNothing)
{
  DeviceProfile profile = FalconProfile();
  profile.forceAxes = 0;
  ForceGate gate(profile);
  for (int n = 0; n < 1000; ++n)
  {
    gate.Want({ { 1, 1, 1 }, { 1, 1, 1 } }, n * TickNs);
    const Wrench out = gate.At(n * TickNs, true);
    ASSERT_EQ(out.force, glm::dvec3(0.0));
    ASSERT_EQ(out.torque, glm::dvec3(0.0));
  }
}

} // namespace
