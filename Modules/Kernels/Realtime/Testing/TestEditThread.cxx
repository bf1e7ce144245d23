#include "Realtime/EditThread.h"

#include <gtest/gtest.h>

#include <latch>
#include <memory>
#include <random>
#include <vector>

namespace
{

using hasp::EditThread;

/// A list that edits write at the end of, on the thread.
struct List
{
  std::vector<int> values;
  std::vector<EditThread::Ticket> tickets;
  EditThread thread{ [this](EditThread::Ticket ticket)
    {
      if (tickets.empty() || tickets.back() != ticket)
        return; // had failed
      values.pop_back();
      tickets.pop_back();
    } };

  EditThread::Ticket Append(int value)
  {
    const EditThread::Ticket ticket = ++this->last;
    this->thread.Add(ticket,
      [this, value, ticket](const EditThread::Progress& progress)
      {
        if (value < 0 || !progress(0.5))
          return false;
        values.push_back(value);
        tickets.push_back(ticket);
        return true;
      });
    return ticket;
  }
  EditThread::Ticket last = 0; ///< the adding thread's own
};

TEST(EditThread, WithoutEditsThereIsNoThread)
{
  int undone = 0;
  EditThread thread([&](EditThread::Ticket) { ++undone; });
  EXPECT_TRUE(thread.Idle());
  thread.Wait();
  thread.TakeBack(1);
  EXPECT_TRUE(thread.Idle());
  EXPECT_EQ(undone, 0);
}

TEST(EditThread, EditsAreMadeInTheirOrder)
{
  List list;
  for (int n = 0; n < 100; ++n)
    list.Append(n);
  list.thread.Wait();
  EXPECT_TRUE(list.thread.Idle());
  ASSERT_EQ(list.values.size(), 100u);
  for (int n = 0; n < 100; ++n)
    EXPECT_EQ(list.values[n], n);
}

/// An edit that is in the middle of its work until it is told to go on.
struct Held
{
  std::latch begun{ 1 }, goOn{ 1 };
  bool goOnIsTold = true;
  EditThread::Edit Edit(bool ends)
  {
    return [this, ends](const EditThread::Progress& progress)
    {
      progress(0.25);
      this->begun.count_down();
      this->goOn.wait();
      this->goOnIsTold = progress(0.75);
      return ends || this->goOnIsTold;
    };
  }
};

TEST(EditThread, WhatIsMadeIsGivenUpAndWhatWaitsIsDropped)
{
  std::vector<EditThread::Ticket> undone;
  EditThread thread([&](EditThread::Ticket ticket) { undone.push_back(ticket); });
  Held held;
  bool second = false;
  thread.Add(1, held.Edit(false));
  thread.Add(2, [&](const EditThread::Progress&) { return second = true; });
  held.begun.wait();
  EXPECT_FALSE(thread.Idle());
  EXPECT_EQ(thread.Share(), 0.25);
  thread.TakeBack(2);
  thread.TakeBack(1);
  held.goOn.count_down();
  thread.Wait();
  EXPECT_FALSE(held.goOnIsTold);
  EXPECT_FALSE(second);
  EXPECT_TRUE(undone.empty()) << "nothing was done";
}

TEST(EditThread, WhatEndsAllTheSameIsTakenBackBeforeTheNextBegins)
{
  std::vector<int> order;
  EditThread thread([&](EditThread::Ticket) { order.push_back(-1); });
  Held held;
  thread.Add(1, held.Edit(true));
  thread.Add(2,
    [&](const EditThread::Progress& progress)
    {
      order.push_back(progress(0.0) ? 2 : 0); // nobody gives this one up
      return true;
    });
  held.begun.wait();
  thread.TakeBack(1);
  held.goOn.count_down();
  thread.Wait();
  EXPECT_EQ(order, (std::vector<int>{ -1, 2 }));
}

TEST(EditThread, ItsEndGivesUpWhatIsMade)
{
  bool second = false;
  int undone = 0;
  Held held;
  auto thread = std::make_unique<EditThread>([&](EditThread::Ticket) { ++undone; });
  thread->Add(1, held.Edit(true));
  thread->Add(2, [&](const EditThread::Progress&) { return second = true; });
  held.begun.wait();
  std::thread ends([&] { thread.reset(); });
  held.goOn.count_down();
  ends.join();
  EXPECT_FALSE(second && !held.goOnIsTold);
  EXPECT_EQ(undone, 0);
}

// However fast the thread is: what stands at the end is what was added and not taken back, since
// the newest are taken back first.
TEST(EditThread, WhatIsTakenBackIsGoneWheneverThatIsAsked)
{
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round)
  {
    List list;
    std::vector<std::pair<EditThread::Ticket, int>> stand;
    for (int n = 0; n < 60; ++n)
    {
      if (random() % 3 != 0 || stand.empty())
      {
        const int value = random() % 8 ? n : -1; // fails
        stand.emplace_back(list.Append(value), value);
      }
      else
      {
        list.thread.TakeBack(stand.back().first);
        stand.pop_back();
      }
      if (random() % 16 == 0)
        list.thread.Wait();
    }
    list.thread.Wait();
    std::vector<int> truth;
    for (const auto& [ticket, value] : stand)
      if (value >= 0)
        truth.push_back(value);
    ASSERT_EQ(list.values, truth) << round;
  }
}

} // namespace
