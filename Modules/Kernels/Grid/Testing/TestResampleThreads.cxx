#include "Grid/ResampleStack.h"
#include "WithThreads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

TEST(ResampleStack, AnyNumberOfThreadsGivesTheSameBits)
{
  hasp::SliceStack stack; // tilted by 11 degrees or so, with two gaps
  stack.dims = { 40, 44 };
  std::vector<float> samples;
  for (int k = 0; k < 30; ++k)
    if (k != 9 && k != 10 && k != 20)
    {
      stack.origins.emplace_back(0.0, 0.2 * k, k);
      for (int j = 0; j < 44; ++j)
        for (int i = 0; i < 40; ++i)
          samples.push_back(
            float(std::tanh(12.0 - std::hypot(i - 20.0, std::hypot(j - 22.0, k - 15.0)))));
    }
  const auto plan = hasp::PlanResampling(stack);
  std::vector<float> first;
  hasp::ResampleRecord firstRecord;
  for (const int threads : { 1, 2, 5 })
  {
    std::vector<float> result(plan.geometry.Size());
    const auto record = hasp::testing::WithThreads(
      threads, [&] { return hasp::Resample(plan, samples.data(), result.data()); });
    if (threads == 1)
    {
      first = result;
      firstRecord = record;
      EXPECT_GT(record.edgesJudged, 100);
    }
    EXPECT_EQ(result, first);
    EXPECT_EQ(record.error50, firstRecord.error50);
    EXPECT_EQ(record.error95, firstRecord.error95);
    EXPECT_EQ(record.edgesJudged, firstRecord.edgesJudged);
  }
}

} // namespace
