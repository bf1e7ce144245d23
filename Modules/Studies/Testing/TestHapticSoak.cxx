#include "Studies/HapticSoak.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{

void Print(const hasp::SoakFigures& soak)
{
  std::printf("%llu ticks, %.2f us each: %llu changes, %llu touched, %llu bad poses, %llu bad "
              "contacts, largest force %.3f of %.3f N\n",
    static_cast<unsigned long long>(soak.ticks), 1e6 * soak.cpuS / soak.ticks,
    static_cast<unsigned long long>(soak.changes), static_cast<unsigned long long>(soak.touched),
    static_cast<unsigned long long>(soak.badPoses),
    static_cast<unsigned long long>(soak.badContacts), soak.largestForceN, soak.limitN);
}

// 10 minutes at 1 kHz. A day of it: hasp report stability --soak.
TEST(HapticSoak, TenMinutesOfTicksLeaveNothingWrongOut)
{
  const hasp::SoakFigures soak = hasp::RunSoak(600'000);
  Print(soak);
  EXPECT_EQ(soak.ticks, 600'000U);
  EXPECT_EQ(soak.notFinite, 0U);
  EXPECT_EQ(soak.overLimit, 0U);
  EXPECT_EQ(soak.overSlew, 0U);
  // It has been a hard day.
  EXPECT_GT(soak.touched, 100'000U);
  EXPECT_GT(soak.badPoses, 300U);
  EXPECT_GT(soak.badContacts, 1000U);
  EXPECT_GT(soak.largestForceN, 0.9 * soak.limitN);
}

// Some seconds of CPU: the whole tick, as long as asked for.
TEST(HapticSoak, TenMinutesOfWholeStepsLeaveNothingWrongOut)
{
  const hasp::SoakFigures soak = hasp::RunStepSoak(600'000);
  Print(soak);
  EXPECT_EQ(soak.ticks, 600'000U);
  EXPECT_EQ(soak.notFinite, 0U);
  EXPECT_EQ(soak.overLimit, 0U);
  EXPECT_EQ(soak.overSlew, 0U);
  EXPECT_EQ(soak.badContacts, 0U);
  EXPECT_GT(soak.touched, 100'000U);
  EXPECT_GT(soak.badPoses, 300U);
  EXPECT_GT(soak.largestForceN, 0.9 * soak.limitN);
}

TEST(HapticSoak, IsTheSameTwiceAndCanBeCancelled)
{
  EXPECT_EQ(hasp::RunSoak(20'000, 5).largestForceN, hasp::RunSoak(20'000, 5).largestForceN);
  EXPECT_NE(hasp::RunSoak(20'000, 5).touched, hasp::RunSoak(20'000, 6).touched);
  EXPECT_THROW(hasp::RunSoak(20'000, 1, [](double) { return false; }), hasp::Cancelled);
  const hasp::SoakFigures step = hasp::RunStepSoak(20'000, 5);
  EXPECT_EQ(step.largestForceN, hasp::RunStepSoak(20'000, 5).largestForceN);
  EXPECT_EQ(step.touched, hasp::RunStepSoak(20'000, 5).touched);
  EXPECT_NE(step.touched, hasp::RunStepSoak(20'000, 6).touched);
  EXPECT_THROW(hasp::RunStepSoak(20'000, 1, [](double) { return false; }), hasp::Cancelled);
}

} // namespace
