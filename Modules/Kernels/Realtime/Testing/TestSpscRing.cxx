#include "Realtime/SpscRing.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

namespace
{

using Words = std::array<std::uint64_t, 19>; // a recorded tick's size

TEST(SpscRing, HoldsAtLeastWhatWasAskedFor)
{
  EXPECT_EQ(hasp::SpscRing<int>(0).Capacity(), 2u);
  EXPECT_EQ(hasp::SpscRing<int>(4).Capacity(), 4u);
  EXPECT_EQ(hasp::SpscRing<int>(5).Capacity(), 8u);
}

TEST(SpscRing, FullRefusesTheNewAndKeepsTheOld)
{
  hasp::SpscRing<int> ring(4);
  int value = -1;
  EXPECT_FALSE(ring.Pop(value));
  EXPECT_EQ(value, -1);
  for (int round = 0; round < 5; ++round) // around the end and over it
  {
    for (int n = 0; n < 4; ++n)
      EXPECT_TRUE(ring.Push(10 * round + n));
    EXPECT_FALSE(ring.Push(99));
    for (int n = 0; n < 3; ++n)
    {
      ASSERT_TRUE(ring.Pop(value));
      EXPECT_EQ(value, 10 * round + n);
    }
    EXPECT_TRUE(ring.Push(7));
    ASSERT_TRUE(ring.Pop(value));
    EXPECT_EQ(value, 10 * round + 3);
    ASSERT_TRUE(ring.Pop(value));
    EXPECT_EQ(value, 7);
    EXPECT_FALSE(ring.Pop(value));
  }
}

/// Every value that was not refused arrives once, whole and in order.
TEST(SpscRing, NothingIsTornLostOrTwiceBetweenThreads)
{
  constexpr std::uint64_t Pushed = 30'000;
  hasp::SpscRing<Words> ring(64);
  std::uint64_t torn = 0, disordered = 0, got = 0;
  std::jthread writer(
    [&]
    {
      Words words;
      for (std::uint64_t n = 1; n <= Pushed;)
      {
        words.fill(n);
        if (ring.Push(words))
          ++n;
        else
          std::this_thread::yield();
      }
    });
  Words words;
  while (got < Pushed)
  {
    if (!ring.Pop(words))
    {
      std::this_thread::yield();
      continue;
    }
    ++got;
    disordered += words.front() != got;
    for (const std::uint64_t word : words)
      torn += word != words.front();
  }
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(disordered, 0u);
  EXPECT_FALSE(ring.Pop(words));
}

} // namespace
