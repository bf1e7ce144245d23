#include "Isosurface/ClusterRing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <numeric>
#include <random>
#include <stdexcept>

namespace
{

/// A cluster of so many words, which count on from `first`.
hasp::ClusterLayer Layer(std::size_t words, std::uint32_t first)
{
  hasp::ClusterLayer layer;
  layer.clusters.resize(1);
  layer.corners.resize(words);
  std::iota(layer.corners.begin(), layer.corners.end(), first);
  return layer;
}

struct Expected
{
  std::uint32_t number, first;
  std::size_t words;
  bool live;
};

/// Against a plain queue, over many turns: what is not dropped is there, bit for bit.
TEST(ClusterRing, HoldsTheYoungestThatFit)
{
  for (const std::size_t words : { 729U, 2000U, 100'000U })
  {
    hasp::ClusterRing ring(50, words);
    std::mt19937 random(5);
    std::deque<Expected> queue;
    std::uint32_t next = 0;
    for (int n = 0; n < 5000; ++n)
    {
      const std::size_t length = 1 + random() % (n % 7 ? 100 : 729);
      const auto dropped = [&](std::uint32_t number)
      {
        while (!queue.front().live)
          queue.pop_front();
        EXPECT_EQ(queue.front().number, number);
        queue.pop_front();
      };
      const std::uint32_t number =
        ring.Add({ { n, 0, 0 }, 0 }, Layer(length, next), std::uint32_t(n), dropped);
      queue.push_back({ number, next, length, true });
      next += 1000;
      if (Expected& removed = queue[random() % queue.size()]; removed.live && random() % 4 == 0)
      {
        ring.Remove(removed.number);
        removed.live = false;
      }
      std::vector<std::uint32_t> numbers;
      for (const Expected& e : queue)
      {
        if (!e.live)
          continue;
        numbers.push_back(e.number);
        const auto& record = ring[e.number];
        ASSERT_EQ(record.words, e.words);
        for (std::size_t w = 0; w < e.words; ++w)
          ASSERT_EQ(ring.Words(record)[w], e.first + w) << "after " << n << " clusters";
      }
      ASSERT_EQ(ring.Numbers(), numbers);
      ASSERT_EQ(ring.Live(), numbers.size());
    }
    EXPECT_GE(queue.size(), words == 729 ? 1U : 10U); // not everything is thrown out for each
  }
}

/// By trial: a record is old if adding half of what fits drops it. Limited by records, or by words.
TEST(ClusterRing, KnowsWhatItWillSoonDrop)
{
  constexpr std::size_t length = 10;
  for (const auto& [records, words] : { std::pair(100U, 100'000U), std::pair(10'000U, 1000U) })
    for (const int added : { 1, 40, 60, 99, 100, 101, 130, 175, 260 })
    {
      hasp::ClusterRing ring(records, words);
      const auto add = [&](std::vector<std::uint32_t>* dropped)
      {
        return ring.Add({}, Layer(length, 0), 0,
          [&](std::uint32_t number)
          {
            if (dropped)
              dropped->push_back(number);
          });
      };
      for (int n = 0; n < added; ++n)
        add(nullptr);
      std::vector<std::uint32_t> old, dropped;
      for (const std::uint32_t number : ring.Numbers())
        if (ring.Old(number))
          old.push_back(number);
      for (int n = 0; n < 50; ++n) // of 100, whichever is short
        add(&dropped);
      EXPECT_EQ(old, dropped) << records << " records, " << added << " added";
    }
}

TEST(ClusterRing, KnowsWhatItHolds)
{
  hasp::ClusterRing ring(4, 1000);
  const std::uint32_t number = ring.Add({}, Layer(5, 10), 0, [](std::uint32_t) {});
  EXPECT_TRUE(ring.Holds(number, Layer(5, 10)));
  EXPECT_FALSE(ring.Holds(number, Layer(5, 11)));
  EXPECT_FALSE(ring.Holds(number, Layer(6, 10)));
  hasp::ClusterLayer other = Layer(5, 10);
  other.clusters[0].active[3] = 1;
  EXPECT_FALSE(ring.Holds(number, other));
}

TEST(ClusterRing, RefusesWhatHoldsNothing)
{
  EXPECT_THROW(hasp::ClusterRing(0, 1000), std::invalid_argument);
  EXPECT_THROW(hasp::ClusterRing(10, 728), std::invalid_argument);
}

} // namespace
