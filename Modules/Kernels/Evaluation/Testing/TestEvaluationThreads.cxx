// The same bits on any number of threads.
#include "Evaluation/StepAndGap.h"
#include "Grid/Testing/WithThreads.h"
#include "PartMeshes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

template <typename Figures>
bool SameBits(const Figures& a, const Figures& b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(EvaluationThreads, DistancesAreTheSameBits)
{
  const hasp::MeasuredSurface ball(parttest::Ball(10, 30)), other(parttest::Ball(11, 21));
  const hasp::RigidPose pose{ { 1, 2, 3 }, hasp::TurnBy({ 0.3, 0.2, 0.1 }) };
  const auto measure = [&](int threads)
  {
    return hasp::testing::WithThreads(
      threads, [&] { return hasp::MeasureSurfaceDifference(ball, pose, other, {}); });
  };
  const auto one = measure(1);
  for (const int threads : { 2, 5 })
    EXPECT_TRUE(SameBits(one, measure(threads))) << threads;
}

TEST(EvaluationThreads, StepsAndGapsAreTheSameBits)
{
  const hasp::MeasuredSurface ball(parttest::Ball(10, 30)), other(parttest::Ball(10, 21));
  const hasp::RigidPose pose{ { 0, 0, 20.5 }, hasp::TurnBy({ 0.3, 0.2, 0.1 }) };
  const auto measure = [&](int threads)
  {
    return hasp::testing::WithThreads(
      threads, [&] { return hasp::MeasureStepAndGap(ball, pose, other, {}); });
  };
  const auto one = measure(1);
  EXPECT_GT(one.gap.samples, 0U);
  for (const int threads : { 2, 5 })
    EXPECT_TRUE(SameBits(one, measure(threads))) << threads;
}

} // namespace
