#include "Realtime/NanosecondHistogram.h"
#include "Realtime/RateMonitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

namespace
{

using namespace hasp;

TEST(NanosecondHistogram, EmptyGivesZeros)
{
  const NanosecondCounts none = NanosecondHistogram().Read();
  EXPECT_EQ(none.total, 0u);
  EXPECT_EQ(none.PercentileNs(0.5), 0.0);
  EXPECT_EQ(none.MeanNs(), 0.0);
  EXPECT_EQ(none.leastNs, 0);
  EXPECT_EQ(none.mostNs, 0);
  EXPECT_EQ(none.Above(0), 0u);
}

TEST(NanosecondHistogram, BinsFollowEachOtherWithoutAGap)
{
  EXPECT_EQ(NanosecondCounts::FirstOf(0), 0);
  for (int bin = 0; bin < NanosecondCounts::Bins; ++bin)
  {
    const std::int64_t first = NanosecondCounts::FirstOf(bin);
    ASSERT_EQ(NanosecondCounts::BinOf(first), bin);
    if (bin == 0)
      continue;
    ASSERT_EQ(NanosecondCounts::BinOf(first - 1), bin - 1);
    const std::int64_t width = first - NanosecondCounts::FirstOf(bin - 1);
    ASSERT_LE(width, std::max<std::int64_t>(1, first / 32)) << bin;
  }
  EXPECT_EQ(NanosecondCounts::FirstOf(NanosecondCounts::Bins - 1), (std::int64_t(63) << 30));
}

TEST(NanosecondHistogram, WhatIsOutsideIsCountedAtTheEdge)
{
  NanosecondHistogram histogram;
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t ns : { std::int64_t(-5), most })
    histogram.Add(ns);
  const NanosecondCounts read = histogram.Read();
  EXPECT_EQ(read.total, 2u);
  EXPECT_EQ(read.counts.front(), 1u);
  EXPECT_EQ(read.counts.back(), 1u);
  EXPECT_EQ(read.leastNs, 0);
  EXPECT_EQ(read.mostNs, most);
}

TEST(NanosecondHistogram, PercentilesAreThoseOfTheSortedTimes)
{
  std::mt19937_64 random(1);
  for (const double spread : { 0.1, 1.0, 4.0 })
  {
    NanosecondHistogram histogram;
    std::vector<std::int64_t> sorted;
    for (int n = 0; n < 5000; ++n)
    {
      // Log-uniform: from single nanoseconds to seconds for the widest.
      const double decades = static_cast<double>(random() >> 11) * 0x1p-53 * 2.0 * spread;
      sorted.push_back(static_cast<std::int64_t>(std::pow(10.0, 5.0 - spread + decades)));
      histogram.Add(sorted.back());
    }
    std::sort(sorted.begin(), sorted.end());
    const NanosecondCounts read = histogram.Read();
    for (const double share : { 0.0, 1e-4, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0 })
    {
      const auto rank = std::max(1.0, std::ceil(share * 5000.0));
      const auto truth = static_cast<double>(sorted[static_cast<std::size_t>(rank) - 1]);
      // Half a bin, which is a 32nd of its first value; below 32 ns a bin is one value.
      EXPECT_NEAR(read.PercentileNs(share), truth, truth / 64.0) << share << " of " << spread;
    }
    EXPECT_EQ(read.leastNs, sorted.front());
    EXPECT_EQ(read.mostNs, sorted.back());
    double sum = 0.0;
    for (const std::int64_t ns : sorted)
      sum += static_cast<double>(ns);
    EXPECT_NEAR(read.MeanNs(), sum / 5000.0, 1e-12 * sum) << "sums of doubles in another order";
    // A bin's edge: what is above is known exactly.
    const std::int64_t edge = NanosecondCounts::FirstOf(NanosecondCounts::BinOf(sorted[2500])) - 1;
    EXPECT_EQ(
      read.Above(edge), static_cast<std::uint64_t>(
                          sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), edge)));
  }
}

TEST(NanosecondHistogram, WhatCameSinceIsTheLaterPart)
{
  NanosecondHistogram all, later;
  for (int n = 0; n < 1000; ++n)
    all.Add(10 * n);
  const NanosecondCounts before = all.Read();
  for (int n = 0; n < 500; ++n)
  {
    all.Add(5000 + n);
    later.Add(5000 + n);
  }
  const NanosecondCounts since = all.Read().Since(before), truth = later.Read();
  EXPECT_EQ(since.counts, truth.counts);
  EXPECT_EQ(since.total, 500u);
  EXPECT_EQ(since.MeanNs(), truth.MeanNs());
  EXPECT_EQ(NanosecondCounts::BinOf(since.mostNs), NanosecondCounts::BinOf(truth.mostNs));
  EXPECT_EQ(NanosecondCounts::BinOf(since.leastNs), NanosecondCounts::BinOf(truth.leastNs));
}

/// One thread adds, one reads: no count goes back, and all are there at the end.
TEST(RateMonitor, CanBeReadWhileItCounts)
{
  constexpr std::uint64_t Ticks = 40'000;
  RateMonitor monitor;
  std::atomic<bool> reading{ false };
  std::thread writer(
    [&]
    {
      reading.wait(false); // so that the two meet, on one core as well
      for (std::uint64_t n = 0; n < Ticks; ++n)
        monitor.Add({ .periodNs = 1'000'000,
          .latenessNs = static_cast<std::int64_t>(n % 100),
          .costNs = 1000,
          .skipped = n % 2,
          .overrun = n % 4 == 0 });
    });
  RateCounts before = monitor.Read();
  reading = true;
  reading.notify_one();
  std::uint64_t backwards = 0, wrong = 0;
  while (before.ticks < Ticks)
  {
    const RateCounts now = monitor.Read();
    for (int bin = 0; bin < NanosecondCounts::Bins; ++bin)
      backwards += now.lateness.counts[bin] < before.lateness.counts[bin];
    backwards += now.ticks < before.ticks || now.skipped < before.skipped;
    wrong += now.lateness.mostNs > 99 || now.period.total > Ticks;
    before = now;
  }
  writer.join();
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(wrong, 0u);
  const RateCounts end = monitor.Read();
  EXPECT_EQ(end.period.total, Ticks);
  EXPECT_EQ(end.cost.PercentileNs(0.99), 1000.0);
  EXPECT_EQ(end.skipped, Ticks / 2);
  EXPECT_EQ(end.overruns, Ticks / 4);
  EXPECT_EQ(end.Since(before).ticks, 0u);
}

TEST(RateMonitor, TheFirstTickHasNoPeriod)
{
  RateMonitor monitor;
  monitor.Add({ .latenessNs = 7 });
  monitor.Add({ .periodNs = 1000, .latenessNs = 9 });
  EXPECT_EQ(monitor.Read().period.total, 1u);
  EXPECT_EQ(monitor.Read().lateness.total, 2u);
}

} // namespace
