#include "Grid/ParallelFor.h"
#include "Grid/SideBySide.h"
#include "Grid/ThreadLimit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
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

TEST(SideBySide, RunsBothAndOneOfThemOnTheCallersThread)
{
  for (const int threads : { 1, 2, 4 })
    hasp::WithThreadLimit(threads,
      []
      {
        std::atomic<int> beside{ 0 }, here{ 0 };
        const auto caller = std::this_thread::get_id();
        hasp::SideBySide([&] { hasp::ParallelFor(0, 100, 1, [&](auto, auto) { ++beside; }); },
          [&]
          {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            hasp::ParallelFor(0, 100, 1, [&](auto, auto) { ++here; });
          });
        EXPECT_EQ(beside, 100);
        EXPECT_EQ(here, 100);
      });
}

TEST(SideBySide, FaultsReachTheCallerWhenBothHaveEnded)
{
  std::atomic<int> ended{ 0 };
  const auto fine = [&] { ++ended; };
  const auto failing = [&](const char* text)
  {
    return [&ended, text]
    {
      ++ended;
      throw std::runtime_error(text);
    };
  };
  const auto fault = [](const auto& beside, const auto& here) -> std::string
  {
    try
    {
      hasp::SideBySide(beside, here);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(failing("beside"), fine), "beside");
  EXPECT_EQ(fault(fine, failing("here")), "here");
  EXPECT_EQ(fault(failing("beside"), failing("here")), "here");
  EXPECT_EQ(ended, 6);
}

} // namespace
