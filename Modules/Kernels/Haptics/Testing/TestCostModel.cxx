#include "Haptics/CostModel.h"
#include "Testing/Dice.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

namespace
{

using namespace hasp;

constexpr std::array<std::uint32_t, 5> Pyramid = { 256, 768, 3072, 12288, 49152 };

std::uint32_t Upto(int levels)
{
  std::uint32_t sum = 0;
  for (int n = 0; n < levels; ++n)
    sum += Pyramid[n];
  return sum;
}

TEST(CostModel, RefusesSettingsOutOfRange)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
    EXPECT_THROW(CostModel({ .firstUsPerPoint = bad }), std::invalid_argument);
  for (const double bad : { 0.0, -0.1, 1.1, nan })
  {
    EXPECT_THROW(CostModel({ .share = bad }), std::invalid_argument);
    EXPECT_THROW(CostModel({ .roomToAdd = bad }), std::invalid_argument);
  }
  EXPECT_THROW(CostModel({ .coarseLevels = -1 }), std::invalid_argument);
}

TEST(CostModel, LearnsNothingFromNonsense)
{
  CostModel model;
  const double before = model.UsPerPoint();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  model.Measure(0, 100.0);
  for (const double bad : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
    model.Measure(1000, bad);
  EXPECT_EQ(model.UsPerPoint(), before);
  for (const double bad : { 0.0, -1.0, nan })
  {
    EXPECT_EQ(model.Points(bad), 0U);
    EXPECT_EQ(model.Levels(Pyramid, bad), 1); // the coarse one, always
  }
  EXPECT_EQ(model.Points(std::numeric_limits<double>::infinity()),
    std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(model.Levels({}, 400.0), 0);
}

TEST(CostModel, FindsTheCost)
{
  for (const double truth : { 0.002, 0.01, 0.2 })
  {
    CostModel model({ .firstUsPerPoint = 0.02 });
    for (int tick = 0; tick < 300; ++tick)
      model.Measure(5000, 5000 * truth);
    EXPECT_NEAR(model.UsPerPoint(), truth, 1e-3 * truth);
    EXPECT_NEAR(model.Points(400.0), 400.0 / truth, 2e-3 * 400.0 / truth);
  }
}

TEST(CostModel, AMomentWithoutTheCoreCostsLittle)
{
  CostModel model({ .firstUsPerPoint = 0.01 });
  model.Measure(5000, 20'000.0); // 20 ms instead of 50 us
  EXPECT_LE(model.UsPerPoint(), 0.01 * 1.16);
}

TEST(CostModel, FollowsASlowerCore)
{
  CostModel model({ .firstUsPerPoint = 0.01 });
  int ticks = 0;
  for (; model.UsPerPoint() < 0.018 && ticks < 1000; ++ticks)
    model.Measure(5000, 5000 * 0.02);
  EXPECT_LT(ticks, 50);
}

/// A step that takes as long as its points, with noise: it must settle, and keep its budget.
TEST(CostModel, LevelsSettleWithinTheBudget)
{
  for (const double us : { 0.003, 0.01, 0.03, 0.5 })
    for (const double budget : { 100.0, 400.0 })
    {
      CostModel model;
      Dice dice(11);
      int changes = 0, before = 0, most = 0;
      for (int tick = 0; tick < 2000; ++tick)
      {
        const int levels = model.Levels(Pyramid, budget);
        ASSERT_GE(levels, 1);
        ASSERT_LE(levels, before + 1);
        if (tick >= 200 && levels != before)
          ++changes;
        before = levels;
        most = std::max(most, levels);
        const double spent = us * Upto(levels) * (0.8 + 0.4 * dice());
        if (tick >= 200 && levels > 1)
        {
          EXPECT_LE(spent, 1.25 * budget);
        }
        model.Measure(Upto(levels), spent);
      }
      EXPECT_LE(changes, 1) << us << " " << budget;
      // No level is left out that has room.
      if (before < 5)
      {
        EXPECT_GT(us * Upto(before + 1), 0.75 * budget) << us << " " << budget;
      }
    }
}

TEST(CostModel, CoarseLevelsAreNeverStarved)
{
  CostModel model({ .firstUsPerPoint = 10.0, .coarseLevels = 2 });
  for (int tick = 0; tick < 100; ++tick)
  {
    EXPECT_EQ(model.Levels(Pyramid, 1.0), 2);
    model.Measure(Upto(2), 10.0 * Upto(2));
  }
  EXPECT_EQ(model.Levels(std::span(Pyramid).first(1), 1.0), 1); // a shell with fewer levels
}

TEST(CostModel, LevelsAreDroppedAtOnceAndAddedOneByOne)
{
  CostModel model({ .firstUsPerPoint = 0.001 });
  for (int levels = 1; levels <= 5; ++levels)
    EXPECT_EQ(model.Levels(Pyramid, 400.0), levels);
  EXPECT_EQ(model.Levels(Pyramid, 1.5), 2); // 1.0 us
  EXPECT_EQ(model.Levels(Pyramid, 400.0), 3);
}

} // namespace
