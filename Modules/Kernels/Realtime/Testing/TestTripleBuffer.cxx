#include "Realtime/TripleBuffer.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <thread>

namespace
{

/// A value that shows when it is made of two: every word follows from the first.
struct Redundant
{
  std::array<std::uint64_t, 31> words{}; // 248 bytes: a haptic snapshot's size

  static Redundant Of(std::uint64_t number)
  {
    Redundant value;
    for (std::size_t w = 0; w < value.words.size(); ++w)
      value.words[w] = number * (2 * w + 1) ^ (w * 0x9E3779B97F4A7C15ull);
    return value;
  }
  std::uint64_t Number() const { return this->words[0]; }
  bool Whole() const { return this->words == Of(this->Number()).words; }
};

TEST(TripleBuffer, NothingBeforeTheFirstWrite)
{
  hasp::TripleBuffer<int> buffer;
  EXPECT_EQ(buffer.Latest(), nullptr);
  EXPECT_FALSE(buffer.Update());
  EXPECT_EQ(buffer.Latest(), nullptr);
}

TEST(TripleBuffer, LatestChangesWithUpdateAlone)
{
  hasp::TripleBuffer<int> buffer;
  buffer.Write(7);
  EXPECT_EQ(buffer.Latest(), nullptr);
  ASSERT_TRUE(buffer.Update());
  EXPECT_EQ(*buffer.Latest(), 7);
  buffer.Write(8);
  EXPECT_EQ(*buffer.Latest(), 7);
}

TEST(TripleBuffer, TheLastValueIsKept)
{
  hasp::TripleBuffer<int> buffer;
  buffer.Write(7);
  ASSERT_TRUE(buffer.Update());
  for (int again = 0; again < 5; ++again)
  {
    EXPECT_FALSE(buffer.Update());
    ASSERT_NE(buffer.Latest(), nullptr);
    EXPECT_EQ(*buffer.Latest(), 7);
  }
}

TEST(TripleBuffer, TheNewestWins)
{
  for (int writes = 1; writes < 10; ++writes) // each number of writes leaves the slots elsewhere
  {
    hasp::TripleBuffer<int> buffer;
    for (int round = 0; round < 5; ++round)
    {
      for (int w = 0; w < writes; ++w)
        buffer.Write(100 * round + w);
      ASSERT_TRUE(buffer.Update());
      EXPECT_EQ(*buffer.Latest(), 100 * round + writes - 1);
      EXPECT_FALSE(buffer.Update());
    }
  }
}

/// One thread writes as fast as it can, another looks as fast as it can: no value is torn, none
/// comes out of order, what Update calls new is new, and the last one arrives.
TEST(TripleBuffer, NothingIsTornAndOrderIsKept)
{
  // Where both threads share a core they change places a few hundred times a second: then the time
  // ends the test, but not before the reader has met values of several turns.
  constexpr std::uint64_t Enough = 50'000, Least = 5;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
  hasp::TripleBuffer<Redundant> buffer;
  std::uint64_t written = 0; // read after the writer has ended
  std::jthread writer(
    [&](const std::stop_token& stop)
    {
      while (!stop.stop_requested())
        buffer.Write(Redundant::Of(++written));
    });
  std::uint64_t last = 0, seen = 0, torn = 0, backwards = 0, changed = 0;
  while (seen < Enough && (seen < Least || std::chrono::steady_clock::now() < end))
  {
    const std::uint64_t before = last;
    const bool fresh = buffer.Update();
    const Redundant* value = buffer.Latest();
    if (!value)
      continue;
    torn += !value->Whole();
    last = value->Number();
    backwards += fresh && last <= before;
    changed += !fresh && last != before;
    seen += fresh;
  }
  writer.request_stop();
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(changed, 0u);
  EXPECT_GE(seen, Least);
  buffer.Update();
  EXPECT_EQ(buffer.Latest()->Number(), written);
  RecordProperty("seen", std::to_string(seen));
}

} // namespace
