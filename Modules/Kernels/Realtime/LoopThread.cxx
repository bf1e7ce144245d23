#include "Realtime/LoopThread.h"

#include "Realtime/SignalsBlocked.h"

#include <time.h>

#include <cerrno>
#include <latch>
#include <stdexcept>
#include <string>
#include <system_error>

namespace hasp
{

namespace
{
constexpr std::int64_t SecondNs = 1'000'000'000;

std::int64_t Read(clockid_t clock) noexcept
{
  timespec time{};
  clock_gettime(clock, &time);
  return time.tv_sec * SecondNs + time.tv_nsec;
}

template <class Value>
void Check(const char* what, Value value, Value least, Value most)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument(std::string("loop: ") + what + " is " + std::to_string(value) +
                                ", must be in [" + std::to_string(least) + ", " +
                                std::to_string(most) + "]");
}
} // namespace

std::int64_t MonotonicClock::NowNs() noexcept
{
  return Read(CLOCK_MONOTONIC);
}

std::int64_t MonotonicClock::CpuNs() noexcept
{
  return Read(CLOCK_THREAD_CPUTIME_ID);
}

void MonotonicClock::SleepUntil(std::int64_t ns) noexcept
{
  const timespec until{ ns / SecondNs, ns % SecondNs };
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR)
  {
  }
}

void LoopThread::Prepare(const LoopSettings& settings)
{
  if (this->Thread.joinable() && this->Running())
    throw std::logic_error("loop: it runs already; stop it first");
  Check<std::int64_t>("periodNs", settings.periodNs, 100'000, 100'000'000);
  Check("overrunShare", settings.overrunShare, 0.01, 0.99);
  Check("mostExcessPeriods", settings.mostExcessPeriods, 1, 1'000'000);
  Check("fifoPriority", settings.scheduling.fifoPriority, 0, 99);
  this->Stop(); // a loop that ended by itself is still to be joined
  this->Settings = settings;
  this->Monitor = std::make_unique<RateMonitor>();
}

void LoopThread::Launch()
{
  this->Stopping = false;
  this->Fallen = false;
  this->Ticking = true;
  std::latch ready(1);
  const SignalsBlocked inherited;
  try
  {
    this->Thread = std::thread(
      [this, &ready]
      {
        const RealTimeScheduling scheduling(this->Settings.scheduling);
        this->Got = scheduling.Report();
        ready.count_down(); // the last that is known of `ready` here
        this->Run->Loop(*this);
        this->Ticking.store(false, std::memory_order_release);
      });
  }
  catch (const std::system_error& error)
  {
    this->Ticking = false;
    this->Run.reset();
    throw std::runtime_error(
      std::string("loop: the system gives no thread: ") + error.what() +
      "; is memory locked under a small limit (ulimit -l), or are there too many threads?");
  }
  ready.wait();
}

void LoopThread::Stop() noexcept
{
  if (!this->Thread.joinable())
    return;
  this->Stopping.store(true, std::memory_order_relaxed);
  this->Thread.join();
  this->Run.reset();
}

void LoopThread::Fall() noexcept
{
  if (this->Fallen.load(std::memory_order_relaxed) || this->Got.priority == 0)
    return;
  RealTimeScheduling::DropToNormal();
  this->Fallen.store(true, std::memory_order_relaxed);
}

} // namespace hasp
