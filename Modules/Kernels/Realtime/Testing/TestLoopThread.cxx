#include "Realtime/LoopThread.h"
#include "Realtime/TripleBuffer.h"

#include <gtest/gtest.h>

#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

namespace
{

using namespace hasp;

/// Waits until `value` is `least`, however long that takes: no time is promised here.
void WaitFor(const std::atomic<int>& value, int least)
{
  for (int now = value; now < least; now = value)
    value.wait(now);
}

/// Ticks that are counted, and heard of.
struct Counting
{
  std::atomic<int>* ticks;
  int most = 1 << 30;
  bool operator()(const LoopTick&) noexcept
  {
    const int now = ticks->fetch_add(1) + 1;
    ticks->notify_all();
    return now < most;
  }
};

TEST(LoopThread, SettingsOutOfRangeAreRefused)
{
  std::atomic<int> ticks{ 0 };
  LoopThread loop;
  const auto refuses = [&](auto change)
  {
    LoopSettings settings;
    change(settings);
    EXPECT_THROW(loop.Start(settings, Counting{ &ticks }), std::invalid_argument);
  };
  refuses([](LoopSettings& s) { s.periodNs = 0; });
  refuses([](LoopSettings& s) { s.periodNs = 99'999; });
  refuses([](LoopSettings& s) { s.periodNs = 1'000'000'000; });
  refuses([](LoopSettings& s) { s.overrunShare = 1.5; });
  refuses([](LoopSettings& s) { s.overrunShare = std::nan(""); });
  refuses([](LoopSettings& s) { s.mostExcessPeriods = 0; });
  refuses([](LoopSettings& s) { s.scheduling.fifoPriority = 100; });
  EXPECT_FALSE(loop.Running());
  EXPECT_EQ(ticks, 0);
}

TEST(LoopThread, TicksUntilItIsStoppedAndNotOnceMore)
{
  std::atomic<int> ticks{ 0 };
  LoopThread loop;
  for (int round = 0; round < 3; ++round)
  {
    ticks = 0;
    const SchedulingReport& got = loop.Start({}, Counting{ &ticks });
    EXPECT_TRUE(got.fifo.asked);
    EXPECT_TRUE(loop.Running());
    EXPECT_THROW(loop.Start({}, Counting{ &ticks }), std::logic_error);
    WaitFor(ticks, 10);
    loop.Stop();
    const int stopped = ticks;
    EXPECT_FALSE(loop.Running());
    EXPECT_EQ(loop.Rates().ticks, static_cast<std::uint64_t>(stopped)) << "of this round alone";
    loop.Stop();
    EXPECT_EQ(ticks, stopped);
  }
}

TEST(LoopThread, ATickMayEndItAndItMayStartAgain)
{
  std::atomic<int> ticks{ 0 };
  LoopThread loop;
  for (int round = 1; round <= 2; ++round)
  {
    loop.Start({}, Counting{ &ticks, 5 * round });
    WaitFor(ticks, 5 * round);
    while (loop.Running())
      std::this_thread::yield();
  }
  loop.Stop();
  EXPECT_EQ(ticks, 10);
}

TEST(LoopThread, EndsWithItsOwner)
{
  std::atomic<int> ticks{ 0 };
  {
    LoopThread loop;
    loop.Start({}, Counting{ &ticks });
    WaitFor(ticks, 2);
  }
  const int ended = ticks;
  std::this_thread::yield();
  EXPECT_EQ(ticks, ended);
}

TEST(LoopThread, TicksComeInOrderAndNoneBeforeItIsDue)
{
  struct Seen
  {
    std::uint64_t number = 0;
    std::uint64_t faults = 0;
  };
  TripleBuffer<Seen> out;
  std::atomic<int> ticks{ 0 };
  LoopThread loop;
  loop.Start({ .periodNs = 200'000 },
    [&, seen = Seen{}, due = std::int64_t(0)](const LoopTick& tick) mutable noexcept
    {
      const std::int64_t apart = tick.dueNs - due;
      seen.faults +=
        tick.number > 0 && (tick.number != seen.number + 1 ||
                             apart != static_cast<std::int64_t>(1 + tick.skipped) * 200'000);
      seen.faults += tick.nowNs < tick.dueNs || tick.nowNs >= tick.dueNs + 200'000;
      seen.number = tick.number;
      due = tick.dueNs;
      out.Write(seen);
      ++ticks;
      ticks.notify_all();
      return true;
    });
  WaitFor(ticks, 200);
  loop.Stop();
  ASSERT_TRUE(out.Update());
  EXPECT_EQ(out.Latest()->faults, 0u);
  EXPECT_GE(out.Latest()->number, 199u);
  const RateCounts rates = loop.Rates();
  EXPECT_EQ(rates.lateness.total, rates.ticks);
  EXPECT_EQ(rates.period.total, rates.ticks - 1);
}

TEST(LoopThread, SignalsGoToTheProgramsThreads)
{
  std::atomic<int> blocked{ -1 };
  LoopThread loop;
  loop.Start({},
    [&](const LoopTick&) noexcept
    {
      sigset_t set;
      pthread_sigmask(SIG_SETMASK, nullptr, &set);
      blocked = sigismember(&set, SIGINT) + sigismember(&set, SIGTERM);
      blocked.notify_all();
      return false;
    });
  blocked.wait(-1);
  EXPECT_EQ(blocked, 2);
  sigset_t mine;
  pthread_sigmask(SIG_SETMASK, nullptr, &mine);
  EXPECT_EQ(sigismember(&mine, SIGINT), 0) << "and not of the one that starts it";
}

/// Burns CPU time, not the wall's: a tick of five periods each. With the excess of three periods
/// allowed, real-time scheduling is gone after the first, if it was there.
TEST(LoopThread, TakingTooMuchTimeEndsRealTimeScheduling)
{
  std::atomic<int> ticks{ 0 };
  LoopThread loop;
  const SchedulingReport got = loop.Start({ .periodNs = 200'000, .mostExcessPeriods = 3 },
    [&](const LoopTick&) noexcept
    {
      MonotonicClock clock;
      for (const std::int64_t until = clock.CpuNs() + 1'000'000; clock.CpuNs() < until;)
      {
      }
      ++ticks;
      ticks.notify_all();
      return ticks < 3;
    });
  WaitFor(ticks, 3);
  loop.Stop();
  EXPECT_EQ(loop.Dropped(), got.priority > 0);
  EXPECT_EQ(loop.Rates().overruns, 3u);
}

} // namespace
