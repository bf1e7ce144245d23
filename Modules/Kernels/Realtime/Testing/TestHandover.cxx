#include "Realtime/Handover.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <utility>

namespace
{

/// Says how many there are, and on which thread one was freed.
struct Watched
{
  static inline std::atomic<int> Alive{ 0 };
  static inline std::atomic<int> FreedElsewhere{ 0 };

  explicit Watched(std::uint64_t n) : number(n), twice(2 * n) { ++Alive; }
  ~Watched()
  {
    --Alive;
    FreedElsewhere += std::this_thread::get_id() != this->Home;
  }
  std::uint64_t number, twice;
  std::thread::id Home = std::this_thread::get_id();
};

TEST(Handover, NothingIsTakenBeforeAnOffer)
{
  hasp::Handover<Watched> handover;
  EXPECT_EQ(handover.Take(), nullptr);
  EXPECT_EQ(handover.Collect(), nullptr);
  handover.GiveBack(nullptr);
  EXPECT_EQ(handover.Collect(), nullptr);
}

TEST(Handover, TheNewestOfferWinsAndTheOlderComesBack)
{
  hasp::Handover<Watched> handover;
  EXPECT_EQ(handover.Offer(std::make_unique<Watched>(1)), nullptr);
  const auto older = handover.Offer(std::make_unique<Watched>(2));
  ASSERT_NE(older, nullptr);
  EXPECT_EQ(older->number, 1u);
  auto taken = handover.Take();
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->number, 2u);
  EXPECT_EQ(handover.Take(), nullptr) << "it is gone";
  handover.GiveBack(std::move(taken));
  EXPECT_EQ(handover.Collect()->number, 2u);
  EXPECT_EQ(handover.Collect(), nullptr);
}

// Else what HAPTIC gives back second would have nowhere to lie, and it would have to free the
// first.
TEST(Handover, NothingNewIsTakenWhileSomethingLiesOnTheWayBack)
{
  hasp::Handover<Watched> handover;
  handover.Offer(std::make_unique<Watched>(1));
  handover.GiveBack(handover.Take());
  handover.Offer(std::make_unique<Watched>(2));
  EXPECT_EQ(handover.Take(), nullptr);
  EXPECT_EQ(handover.Collect()->number, 1u);
  const auto second = handover.Take();
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->number, 2u);
}

TEST(Handover, NullTakesAnOfferBack)
{
  hasp::Handover<Watched> handover;
  handover.Offer(std::make_unique<Watched>(1));
  EXPECT_EQ(handover.Offer(nullptr)->number, 1u);
  EXPECT_EQ(handover.Take(), nullptr);
}

TEST(Handover, WhatIsOnItsWayIsFreedWithIt)
{
  const int before = Watched::Alive;
  {
    hasp::Handover<Watched> handover;
    handover.Offer(std::make_unique<Watched>(1));
    handover.GiveBack(handover.Take());
    handover.Offer(std::make_unique<Watched>(2));
    EXPECT_EQ(Watched::Alive, before + 2);
  }
  EXPECT_EQ(Watched::Alive, before);
}

// The whole way round, on two threads; the preset tsan looks for races.
TEST(Handover, WhatOneThreadMakesItAloneFrees)
{
  constexpr std::uint64_t Offers = 20'000;
  const int before = Watched::Alive;
  const int elsewhere = Watched::FreedElsewhere;
  std::uint64_t torn = 0, backwards = 0, taken = 0, collected = 0, unseen = 0;
  {
    hasp::Handover<Watched> handover;
    std::atomic<bool> over{ false };
    std::unique_ptr<Watched> last;
    std::thread haptic(
      [&]
      {
        std::unique_ptr<Watched> held;
        std::uint64_t newest = 0;
        for (bool more = true; more;)
        {
          more = !over.load(std::memory_order_acquire); // then once more: the last one counts
          if (auto next = handover.Take())
          {
            ++taken;
            torn += next->twice != 2 * next->number;
            backwards += next->number <= newest;
            newest = next->number;
            std::swap(held, next);
            handover.GiveBack(std::move(next)); // null the first time: there was none before
          }
        }
        last = std::move(held); // what it still holds is freed at home
      });
    for (std::uint64_t n = 1; n <= Offers; ++n)
    {
      unseen += handover.Offer(std::make_unique<Watched>(n)) != nullptr;
      collected += handover.Collect() != nullptr;
    }
    over.store(true, std::memory_order_release);
    haptic.join();
    unseen += handover.Offer(nullptr) != nullptr;
    collected += handover.Collect() != nullptr;
    EXPECT_NE(last, nullptr);
  }
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_GT(taken, 0u);
  EXPECT_EQ(taken + unseen, Offers) << "each is taken or comes back";
  EXPECT_EQ(collected + 1, taken) << "each but the last is given back";
  EXPECT_EQ(Watched::Alive, before);
  EXPECT_EQ(Watched::FreedElsewhere, elsewhere) << "the tick frees nothing";
}

} // namespace
