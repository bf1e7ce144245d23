#include "Model/JobQueue.h"

#include "Model/ErrorText.h"
#include "Realtime/SignalsBlocked.h"

#include <chrono>
#include <new>

namespace hasp
{
namespace
{
constexpr std::chrono::milliseconds BetweenShares{ 100 };

/// What it throws, in words; none: nothing.
template <typename Act>
std::optional<QString> FaultOf(const Act& act)
{
  try
  {
    act();
    return std::nullopt;
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    return JobQueue::tr(
      "there is not enough memory; close other programs or work on a smaller scan");
  }
  catch (const std::exception& error)
  {
    return ErrorText(error);
  }
}
} // namespace

JobQueue::JobQueue(QObject* parent) : QObject(parent) {}

JobQueue::~JobQueue()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Ending = true;
    this->GiveUp = true;
    this->Waiting.clear();
  }
  this->Changed.notify_all();
  if (this->Thread.joinable())
    this->Thread.join();
}

void JobQueue::Add(const QString& what, Work work)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Waiting.push_back({ what, std::move(work) });
    if (!this->Thread.joinable())
    {
      const SignalsBlocked blocked; // they are RENDER's
      this->Thread = std::thread([this] { this->Run(); });
    }
  }
  this->Changed.notify_all();
}

void JobQueue::CancelAll()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Waiting.clear();
    if (!this->Busy)
      return;
    this->GiveUp = true;
    ++this->Round; // also a result that is on its way
  }
}

bool JobQueue::IsIdle() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return !this->Busy && this->Waiting.empty();
}

QString JobQueue::What() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Running;
}

double JobQueue::Share() const
{
  return this->Done.load(std::memory_order_relaxed);
}

void JobQueue::Run()
{
  std::unique_lock<std::mutex> lock(this->Guard);
  for (;;)
  {
    this->Changed.wait(
      lock, [this] { return this->Ending || (!this->Busy && !this->Waiting.empty()); });
    if (this->Ending)
      return;
    const Job job = std::move(this->Waiting.front());
    this->Waiting.pop_front();
    this->Running = job.what;
    this->Busy = true;
    this->GiveUp = false;
    this->Done = 0.0;
    const unsigned long long round = this->Round;
    lock.unlock();
    QMetaObject::invokeMethod(
      this, [this, what = job.what] { Q_EMIT this->Began(what); }, Qt::QueuedConnection);
    const Result result = this->DoJob(job);
    QMetaObject::invokeMethod(
      this, [this, what = job.what, result, round] { this->Deliver(what, result, round); },
      Qt::QueuedConnection);
    lock.lock();
  }
}

JobQueue::Result JobQueue::DoJob(const Job& job)
{
  auto told = std::chrono::steady_clock::now();
  const auto progress = [&](double share)
  {
    this->Done.store(share, std::memory_order_relaxed);
    const auto now = std::chrono::steady_clock::now();
    if (now - told >= BetweenShares)
    {
      told = now;
      QMetaObject::invokeMethod(
        this, [this, share] { Q_EMIT this->Progressed(share); }, Qt::QueuedConnection);
    }
    return !this->GiveUp;
  };
  Result result;
  try
  {
    result.error = FaultOf([&] { result.finish = job.work(progress); });
  }
  catch (const Cancelled&) // neither
  {
  }
  return result;
}

/// What was said of it may throw, too: the queue goes on.
void JobQueue::Deliver(const QString& what, const Result& result, unsigned long long round)
{
  this->Delivered = what;
  try
  {
    this->Tell(what, result, round);
  }
  catch (...)
  {
    this->Conclude(what);
    throw;
  }
  this->Conclude(what);
}

void JobQueue::Tell(const QString& what, const Result& result, unsigned long long round)
{
  if (round != this->Round || (!result.finish && !result.error))
    Q_EMIT this->GaveUp(what);
  else if (result.error)
    Q_EMIT this->Failed(what, *result.error);
  else
    this->DoFinish(what, result.finish);
}

void JobQueue::DoFinish(const QString& what, const Finish& finish)
{
  try
  {
    if (const auto fault = FaultOf(finish))
      Q_EMIT this->Failed(what, *fault);
  }
  catch (const Cancelled&)
  {
    Q_EMIT this->GaveUp(what);
  }
}

void JobQueue::Conclude(const QString& what)
{
  this->Delivered.clear();
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Busy = false;
    this->Running.clear();
  }
  this->Changed.notify_all();
  Q_EMIT this->Ended(what);
}

} // namespace hasp
