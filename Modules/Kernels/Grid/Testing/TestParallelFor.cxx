#include "Grid/ParallelFor.h"
#include "Grid/ThreadLimit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace
{

TEST(ParallelFor, CoversTheRangeOnceInPiecesOfTheGrain)
{
  std::vector<std::atomic<int>> hits(1003);
  std::atomic<bool> aligned{ true };
  hasp::ParallelFor(3, 1003, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      if ((first - 3) % 64 != 0 || last - first > 64)
        aligned = false;
      for (std::int64_t i = first; i < last; ++i)
        ++hits[i];
    });
  EXPECT_TRUE(aligned);
  for (int i = 0; i < 1003; ++i)
    EXPECT_EQ(hits[i], i < 3 ? 0 : 1);
}

TEST(ParallelFor, NothingToDoAndFaults)
{
  hasp::ParallelFor(5, 5, 1, [](std::int64_t, std::int64_t) { FAIL(); });
  EXPECT_THROW(
    hasp::ParallelFor(0, 1, 0, [](std::int64_t, std::int64_t) {}), std::invalid_argument);
  const auto fail = [](std::int64_t, std::int64_t) { throw std::runtime_error("body"); };
  EXPECT_THROW(hasp::ParallelFor(0, 10, 1, fail), std::runtime_error);
  EXPECT_GE(hasp::ParallelThreads(), 1);
}

TEST(ParallelFor, UsesAsManyThreadsAsItIsLimitedTo)
{
  for (const int threads : { 1, 2, 4 })
  {
    int seen = 0;
    hasp::WithThreadLimit(threads, [&] { seen = hasp::ParallelThreads(); });
    EXPECT_EQ(seen, hasp::ParallelThreads() == 1 && seen == 1 ? 1 : threads); // 1 without oneTBB
  }
  EXPECT_THROW(hasp::WithThreadLimit(-1, [] {}), std::invalid_argument);
  EXPECT_THROW(hasp::WithThreadLimit(2, [] { throw std::runtime_error("reaches the caller"); }),
    std::runtime_error);
}

} // namespace
