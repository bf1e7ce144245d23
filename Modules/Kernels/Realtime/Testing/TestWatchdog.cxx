#include "Realtime/Watchdog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using namespace hasp;

constexpr std::int64_t Ms = 1'000'000;
const ForceNumbers Pull = { 4.0, -2.0, 1.0, 80.0, 0.0, -40.0 };
const ForceNumbers Zero{};

TEST(Watchdog, SettingsOutOfRangeAreRefused)
{
  EXPECT_THROW(Watchdog({ .staleNs = 0 }), std::invalid_argument);
  EXPECT_THROW(Watchdog({ .staleNs = -1 }), std::invalid_argument);
  EXPECT_THROW(Watchdog({ .staleNs = 2'000 * Ms }), std::invalid_argument);
  EXPECT_THROW(Watchdog({ .rampNs = -1 }), std::invalid_argument);
  EXPECT_NO_THROW(Watchdog({ .rampNs = 0 }));
}

TEST(Watchdog, WhatIsNoNumberGoesOutAsZeroAndIsCounted)
{
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  Watchdog watchdog;
  std::uint64_t fed = 0;
  for (std::size_t at = 0; at < 6; ++at)
    for (const double bad : { nan, inf, -inf })
    {
      ForceNumbers force = Pull;
      force[at] = bad;
      watchdog.Feed(0, Pull);
      watchdog.Feed(0, force);
      ++fed;
      for (const std::int64_t now : { 0 * Ms, 30 * Ms, 50 * Ms })
      {
        const WatchedForce out = watchdog.At(now, true);
        EXPECT_EQ(out.force, Zero) << "not even the part that is finite";
        EXPECT_EQ(out.state, WatchdogState::NotFinite);
      }
      EXPECT_EQ(watchdog.Counts().notFinite, fed);
    }
  watchdog.Feed(1, Pull);
  EXPECT_EQ(watchdog.At(1, true).force, Pull) << "one good wrench, and all is well again";
}

TEST(Watchdog, NothingBeforeTheFirstWrench)
{
  Watchdog watchdog;
  const WatchedForce out = watchdog.At(5, true);
  EXPECT_EQ(out.force, Zero);
  EXPECT_EQ(out.state, WatchdogState::Waiting);
}

/// 20 ms as it came, 20 ms evenly down, then zero: the closed form, at every tenth of a ms.
TEST(Watchdog, RampsToZeroWithinTwentyMillisecondsAfterTwenty)
{
  constexpr std::int64_t Fresh = 123'456'789;
  for (std::int64_t age = 0; age <= 60 * Ms; age += Ms / 10)
  {
    const double share = std::clamp(1.0 - (static_cast<double>(age) / Ms - 20.0) / 20.0, 0.0, 1.0);
    const WatchedForce out = Watch({}, Fresh + age, Fresh, true, Pull);
    for (std::size_t at = 0; at < 6; ++at)
      EXPECT_NEAR(out.force[at], share * Pull[at], 1e-13 * std::abs(Pull[at])) << age;
    EXPECT_EQ(out.state, age <= 20 * Ms  ? WatchdogState::Fresh
                         : age < 40 * Ms ? WatchdogState::Ramping
                                         : WatchdogState::Silent);
  }
  EXPECT_EQ(Watch({}, 20 * Ms, 0, true, Pull).force, Pull) << "to the last bit";
  EXPECT_EQ(Watch({}, 40 * Ms, 0, true, Pull).force, Zero);
}

TEST(Watchdog, ARampOfNoLengthIsAStep)
{
  const WatchdogSettings step{ .rampNs = 0 };
  EXPECT_EQ(Watch(step, 20 * Ms, 0, true, Pull).force, Pull);
  EXPECT_EQ(Watch(step, 20 * Ms + 1, 0, true, Pull).force, Zero);
}

TEST(Watchdog, AClockThatGoesBackSilencesIt)
{
  EXPECT_EQ(Watch({}, 0, 5 * Ms, true, Pull).force, Pull) << "two threads' clocks, a bit apart";
  EXPECT_EQ(Watch({}, 0, 21 * Ms, true, Pull).force, Zero);
  constexpr auto least = std::numeric_limits<std::int64_t>::min(),
                 most = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(Watch({}, most, least, true, Pull).state, WatchdogState::Silent);
  EXPECT_EQ(Watch({}, least, most, true, Pull).state, WatchdogState::Silent);
}

TEST(Watchdog, UnpluggedIsZeroAtTheNextTickAndForgetsTheWrench)
{
  Watchdog watchdog;
  watchdog.Feed(0, Pull);
  EXPECT_EQ(watchdog.At(1 * Ms, true).force, Pull);
  const WatchedForce out = watchdog.At(2 * Ms, false);
  EXPECT_EQ(out.force, Zero);
  EXPECT_EQ(out.state, WatchdogState::Unplugged);
  EXPECT_EQ(watchdog.At(3 * Ms, true).force, Zero) << "plugged in again: no kick";
  watchdog.Feed(4 * Ms, Pull);
  EXPECT_EQ(watchdog.At(4 * Ms, true).force, Pull);
}

/// A loop of 1 ms that misses 50 ticks: force goes down meanwhile, and each stall counts once.
TEST(Watchdog, CountsEachStallOnce)
{
  Watchdog watchdog;
  for (int tick = 0; tick < 300; ++tick)
  {
    if (tick % 100 < 50)
      watchdog.Feed(tick * Ms, Pull);
    const WatchedForce out = watchdog.At(tick * Ms, true);
    const int age = std::max(0, tick % 100 - 49);
    EXPECT_EQ(out.state == WatchdogState::Fresh, age <= 20) << tick;
    EXPECT_EQ(out.force == Zero, age >= 40) << tick;
  }
  EXPECT_EQ(watchdog.Counts().ramps, 3u);
}

} // namespace
