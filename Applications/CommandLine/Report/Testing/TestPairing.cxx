#include "MeasuredRows.h"
#include "Pairing.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

namespace
{

TEST(Pairing, RefusesTooFewPairs)
{
  const auto run = [] { return hasp::Timing{ 1, 1 }; };
  EXPECT_THROW(hasp::ComparePairs(run, run, { 2, 8 }), std::invalid_argument);
  EXPECT_THROW(hasp::ComparePairs(run, run, { 0, 9 }), std::invalid_argument);
  EXPECT_THROW(hasp::QuartilesOf({}), std::invalid_argument);
}

TEST(Pairing, RefusesRunsThatTakeNoTime)
{
  const auto run = [] { return hasp::Timing{ 1, 1 }; };
  const auto nothing = [] { return hasp::Timing{ 0, 0 }; };
  EXPECT_THROW(hasp::ComparePairs(run, nothing), std::runtime_error);
}

TEST(Pairing, RunsInTurnAndForgetsTheWarmUp)
{
  std::string order;
  int runs = 0;
  const auto a = [&]
  {
    order += 'A';
    return hasp::Timing{ runs++ < 2 ? 1000.0 : 3.0, 1.0 };
  };
  const auto b = [&]
  {
    order += 'B';
    return hasp::Timing{ 2.0, 4.0 };
  };
  const hasp::PairedTimes times = hasp::ComparePairs(a, b);
  EXPECT_EQ(order, "ABABABABABABABABABABAB"); // 2 warm-ups + 9 pairs
  EXPECT_EQ(times.pairs, 9);
  EXPECT_DOUBLE_EQ(times.ratio.median, 1.5);
  EXPECT_DOUBLE_EQ(times.ratio.q3, 1.5); // the slow first runs are gone
  EXPECT_DOUBLE_EQ(times.cpuRatio.median, 0.25);
  EXPECT_DOUBLE_EQ(times.a.wallS, 3.0);
  EXPECT_DOUBLE_EQ(times.b.cpuS, 4.0);
}

TEST(Pairing, ADisturbedMachineDoesNotMoveTheRatio)
{
  // The machine slows down pair by pair, A always takes twice as long as B. The medians of A and of
  // B come from the same pair here, so disturb one pair of each kind too.
  int pairA = 0, pairB = 0;
  const auto a = [&] { return hasp::Timing{ 2.0 * std::exp2(pairA++), 1 }; };
  const auto b = [&]
  {
    const double slow = pairB == 5 ? 100.0 : 1.0;
    return hasp::Timing{ slow * std::exp2(pairB++), 1 };
  };
  const hasp::PairedTimes times = hasp::ComparePairs(a, b);
  EXPECT_DOUBLE_EQ(times.ratio.median, 2.0);
  EXPECT_DOUBLE_EQ(times.ratio.q1, 2.0);
}

TEST(Pairing, WithoutACpuClockThereIsNoCpuRatio)
{
  const auto run = [] { return hasp::Timing{ 1, 0 }; };
  EXPECT_TRUE(std::isnan(hasp::ComparePairs(run, run).cpuRatio.median));
}

TEST(Pairing, QuartilesAreLinearBetweenRanks)
{
  const hasp::Quartiles quartiles = hasp::QuartilesOf({ 4, 1, 3, 2 });
  EXPECT_DOUBLE_EQ(quartiles.q1, 1.75);
  EXPECT_DOUBLE_EQ(quartiles.median, 2.5);
  EXPECT_DOUBLE_EQ(quartiles.q3, 3.25);
  EXPECT_DOUBLE_EQ(hasp::QuartilesOf({ 7 }).q1, 7.0);
}

TEST(Pairing, TimesAreThoseOfTheWork)
{
  volatile double sum = 0.0;
  const hasp::Timing none = hasp::TimeOf([] {});
  const hasp::Timing some = hasp::TimeOf(
    [&]
    {
      for (int k = 0; k < 20'000'000; ++k)
        sum = sum + 1.0;
    });
  EXPECT_GT(some.wallS, none.wallS);
  EXPECT_GT(some.cpuS, 0.0);
  EXPECT_EQ(sum, 20'000'000.0);
}

TEST(Pairing, ThreadTimeIsOfThisThreadAlone)
{
  const auto nothing = [] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); };
  const auto work = [](double seconds)
  {
    double done = 0.0;
    while (done < seconds)
      done += hasp::ThreadTimeOf(
        []
        {
          for (volatile int n = 0; n < 100'000;)
            n = n + 1;
        }).cpuS;
  };
  const hasp::Timing slept = hasp::ThreadTimeOf(nothing);
  EXPECT_GE(slept.wallS, 0.03);
  EXPECT_LT(slept.cpuS, 0.01);
  const hasp::Timing watched = hasp::ThreadTimeOf([&] { std::jthread other(work, 0.03); });
  EXPECT_LT(watched.cpuS, 0.01); // the other thread's is its own
  EXPECT_GE(hasp::ThreadTimeOf([&] { work(0.02); }).cpuS, 0.02);
}

TEST(Pairing, RatiosOfProcessorTimeTurnWithTheirQuartiles)
{
  hasp::PairedTimes times;
  times.ratio = { 0.5, 1.0, 2.0 };
  times.cpuRatio = { 0.2, 0.25, 0.5 };
  times.a = { 3.0, 2.0 };
  times.pairs = 9;
  const hasp::ReportRow row =
    hasp::CpuRatio("a.simd", times, "plain", { 0.1, "of it" }, "ball", true);
  EXPECT_DOUBLE_EQ(row.value.value(), 4.0);
  EXPECT_DOUBLE_EQ(row.q1.value(), 2.0);
  EXPECT_DOUBLE_EQ(row.q3.value(), 5.0);
  EXPECT_EQ(row.data, "ball; by wall time 1");
  EXPECT_DOUBLE_EQ(row.cpuS.value(), 2.0);
  EXPECT_DOUBLE_EQ(hasp::CpuRatio("a", times, "plain", {}, "").value.value(), 0.25);
}

} // namespace
