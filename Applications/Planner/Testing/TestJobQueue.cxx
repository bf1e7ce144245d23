// Long work, one job after the other, however each of them ends.
#include "Grid/Progress.h"
#include "Model/JobQueue.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

using namespace hasp;

namespace
{

constexpr int MostMs = 20000;

/// Qt's events without a window: what a throwing slot throws comes out of Run.
class JobQueueTest : public ::testing::Test
{
protected:
  JobQueueTest()
  {
    QObject::connect(&this->jobs, &JobQueue::Failed,
      [this](const QString& what, const QString& text)
      { this->told.push_back(what.toStdString() + " failed: " + text.toStdString()); });
    QObject::connect(&this->jobs, &JobQueue::GaveUp,
      [this](const QString& what) { this->told.push_back(what.toStdString() + " given up"); });
    QObject::connect(&this->jobs, &JobQueue::Ended,
      [this](const QString& what) { this->told.push_back(what.toStdString() + " ended"); });
  }
  /// Until nothing is to be done.
  void Run()
  {
    QElapsedTimer since;
    since.start();
    while (!this->jobs.IsIdle() && since.elapsed() < MostMs)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 10);
    EXPECT_TRUE(this->jobs.IsIdle());
  }
  /// A job that only says what its result is used for.
  JobQueue::Work Tells(const std::string& text)
  {
    return [this, text](const ProgressFunction&) -> JobQueue::Finish
    { return [this, text] { this->told.push_back(text); }; };
  }

  int count = 1;
  char name[5] = "test", *names[2] = { this->name, nullptr };
  QCoreApplication application{ this->count, this->names };
  JobQueue jobs;
  std::vector<std::string> told;
};

using Told = std::vector<std::string>;

TEST_F(JobQueueTest, JobsAreDoneInTheirOrder)
{
  this->jobs.Add("A", this->Tells("a"));
  this->jobs.Add("B", this->Tells("b"));
  this->Run();
  EXPECT_EQ(this->told, (Told{ "a", "A ended", "b", "B ended" }));
}

TEST_F(JobQueueTest, WhatThrowsIsToldAndTheNextOneIsDone)
{
  this->jobs.Add(
    "A", [](const ProgressFunction&) -> JobQueue::Finish { throw std::runtime_error("no room"); });
  this->jobs.Add("B",
    [](const ProgressFunction&) -> JobQueue::Finish
    { return [] { throw std::runtime_error("no place"); }; });
  this->jobs.Add("C", [](const ProgressFunction&) -> JobQueue::Finish { throw Cancelled(); });
  this->jobs.Add(
    "D", [](const ProgressFunction&) -> JobQueue::Finish { return [] { throw Cancelled(); }; });
  this->jobs.Add("E", this->Tells("e"));
  this->Run();
  EXPECT_EQ(this->told, (Told{ "A failed: no room", "A ended", "B failed: no place", "B ended",
                          "C given up", "C ended", "D given up", "D ended", "e", "E ended" }));
}

/// It comes out where the event is handled, and the queue is not stuck.
TEST_F(JobQueueTest, AJobWhoseFaultCannotBeToldIsNotTheLast)
{
  QObject::connect(&this->jobs, &JobQueue::Failed,
    [](const QString&, const QString&) { throw std::runtime_error("the disk is full"); });
  this->jobs.Add(
    "A", [](const ProgressFunction&) -> JobQueue::Finish { throw std::runtime_error("no room"); });
  this->jobs.Add("B", this->Tells("b"));
  EXPECT_THROW(this->Run(), std::runtime_error);
  EXPECT_TRUE(this->jobs.Delivering().isEmpty());
  this->Run();
  EXPECT_EQ(this->told, (Told{ "A failed: no room", "A ended", "b", "B ended" }));
}

TEST_F(JobQueueTest, WhatIsCancelledIsNeverUsed)
{
  this->jobs.Add("A",
    [this](const ProgressFunction& progress) -> JobQueue::Finish
    {
      while (progress(0.5))
      {
      } // until it is given up
      return [this] { this->told.push_back("a"); };
    });
  this->jobs.Add("B", this->Tells("b"));
  while (this->jobs.What().isEmpty())
    QCoreApplication::processEvents();
  this->jobs.CancelAll();
  this->Run();
  EXPECT_EQ(this->told, (Told{ "A given up", "A ended" }));
}

} // namespace
