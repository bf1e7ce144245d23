#pragma once
#include "Realtime/PeriodicLoop.h"
#include "Realtime/RealTimeScheduling.h"

#include <atomic>
#include <memory>
#include <thread>
#include <utility>

namespace hasp
{

struct LoopSettings
{
  std::int64_t periodNs = 1'000'000; ///< in [100'000, 100'000'000]
  double overrunShare =
    0.8; ///< of a period: a tick that costs more CPU time is an overrun; in [0.01, 0.99]
  int mostExcessPeriods = 50; ///< so many periods of CPU time beyond that share, and real-time
                              ///< scheduling ends; in [1, 1'000'000]
  SchedulingRequest scheduling{};
};

/// CLOCK_MONOTONIC, and the CPU time of the thread that asks.
struct MonotonicClock
{
  std::int64_t NowNs() noexcept;
  std::int64_t CpuNs() noexcept;
  void SleepUntil(std::int64_t ns) noexcept; ///< at once if that has passed; signals do not end it
};

/// A thread that calls one function once a period: RunPeriods on CLOCK_MONOTONIC, with all signals
/// blocked, real-time where the system allows it. The kernel of Linux takes real-time threads off
/// the processor after 95% of each second, and a tick that never ends would hold all others up
/// until then: so a thread that goes on taking more than its share falls back to normal scheduling
/// by itself.
///
/// Threads: RENDER, or whoever owns it, for all that is public here; the tick runs on HAPTIC, which
/// is the thread made here.
/// Cost: nothing before Start; one thread and its stack until Stop.
class LoopThread
{
public:
  LoopThread() = default;
  ~LoopThread() { this->Stop(); }
  LoopThread(const LoopThread&) = delete;
  LoopThread& operator=(const LoopThread&) = delete;

  /// Starts, and waits until the thread has asked the system for what it wants: the report says
  /// what it got. `tick` is bool(const LoopTick&) noexcept; false ends the loop. It is moved in,
  /// and destroyed by Stop on the thread that calls Stop; what it refers to must live until then.
  /// Throws std::invalid_argument if a setting is out of its range, std::logic_error if it runs
  /// already, std::runtime_error if the system gives no thread.
  template <class Tick>
  const SchedulingReport& Start(const LoopSettings& settings, Tick tick)
  {
    static_assert(
      std::is_nothrow_invocable_r_v<bool, Tick&, const LoopTick&>, "a tick is noexcept");
    this->Prepare(settings);
    this->Run = std::make_unique<RunOf<Tick>>(std::move(tick));
    this->Launch();
    return this->Got;
  }

  /// Waits for the tick that is running, and no other begins: within a period, if ticks end. Does
  /// nothing if it does not run.
  void Stop() noexcept;

  /// Whether ticks are still to come: false also after a tick returned false.
  bool Running() const noexcept { return this->Ticking.load(std::memory_order_acquire); }

  /// Whether it had real-time scheduling and lost it for taking too much time.
  bool Dropped() const noexcept { return this->Fallen.load(std::memory_order_relaxed); }

  /// Of all ticks since the last Start.
  RateCounts Rates() const noexcept { return this->Monitor->Read(); }

  /// What the last Start got.
  const SchedulingReport& Scheduling() const noexcept { return this->Got; }

private:
  /// The tick, whatever its type, called where it is known.
  struct AnyRun
  {
    virtual ~AnyRun() = default;
    virtual void Loop(LoopThread& thread) noexcept = 0;
  };
  template <class Tick>
  struct RunOf : AnyRun
  {
    explicit RunOf(Tick&& from) : tick(std::move(from)) {}
    void Loop(LoopThread& thread) noexcept override
    {
      MonotonicClock clock;
      CpuBudget budget(
        thread.Settings.overrunShare, thread.Settings.mostExcessPeriods * thread.Settings.periodNs);
      auto spent = [&](std::int64_t costNs, std::int64_t passedNs) noexcept
      {
        if (!budget.Spend(costNs, passedNs))
          thread.Fall();
      };
      RunPeriods(clock, thread.Settings.periodNs, thread.Settings.overrunShare, *thread.Monitor,
        thread.Stopping, this->tick, spent);
    }
    Tick tick;
  };

  void Prepare(const LoopSettings& settings);
  void Launch();
  void Fall() noexcept;

  LoopSettings Settings;
  SchedulingReport Got;
  std::unique_ptr<RateMonitor> Monitor = std::make_unique<RateMonitor>();
  std::unique_ptr<AnyRun> Run;
  std::atomic<bool> Stopping{ false }, Ticking{ false }, Fallen{ false };
  std::thread Thread;
};

} // namespace hasp
