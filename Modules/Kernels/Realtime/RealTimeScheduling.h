#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hasp
{

enum class MemoryLocking
{
  None,
  Named,     ///< the thread's stack and the ranges that are named
  Everything ///< all pages of the process as they are used; where the limit is small: Named
};

struct MemoryRange
{
  const void* begin = nullptr;
  std::size_t bytes = 0;
};

/// What a thread that must not be late asks of the system.
struct SchedulingRequest
{
  int fifoPriority = 80;  ///< SCHED_FIFO, 1 to 99; 0: not asked
  int core = -1;          ///< the thread stays on it; -1: not asked
  bool exactTimer = true; ///< wake-ups when they are due, not 50 us later
  bool flushDenormals =
    true; ///< numbers below 1e-308 (1e-38) count as 0: they cost 100 cycles each
  MemoryLocking lock = MemoryLocking::Named;
  std::vector<MemoryRange> ranges{}; ///< what the thread reads and writes all the time
};

/// One wish and what became of it.
struct SchedulingAnswer
{
  bool asked = false;
  bool granted = false;
  std::string why; ///< not granted, or less: a sentence, with what to do about it

  bool Refused() const noexcept { return this->asked && !this->granted; }
};

struct SchedulingReport
{
  SchedulingAnswer fifo, core, timer, denormals, memory;
  int priority = 0;            ///< of SCHED_FIFO, as granted; 0: normal scheduling
  std::size_t lockedBytes = 0; ///< of Named; whole pages

  /// What was asked for and not had, a sentence each: what a program tells its user, once.
  std::vector<std::string> Shortfalls() const;
};

/// Holds a thread's wishes: asks for them when made, gives memory and processor state back at the
/// end. Nothing here throws for what the system refuses: the report says it, and the thread runs
/// on.
///
/// Never locks all memory (mlockall with MCL_FUTURE) under a limit: there every later thread and
/// allocation of the program would fail. Under the usual 8 MiB what is named is locked, and pages
/// of it that something else has locked, too, are unlocked with it.
///
/// Threads: make it and end it on the thread it is for, before and after its first and last tick.
/// Takes memory and calls the system: never in a tick.
class RealTimeScheduling
{
public:
  explicit RealTimeScheduling(const SchedulingRequest& request);
  ~RealTimeScheduling();
  RealTimeScheduling(const RealTimeScheduling&) = delete;
  RealTimeScheduling& operator=(const RealTimeScheduling&) = delete;

  const SchedulingReport& Report() const noexcept { return this->Got; }

  /// Back to the scheduling of everybody: for a thread that takes more time than there is, which
  /// under SCHED_FIFO would stop all others. One system call; may be called in a tick.
  static bool DropToNormal() noexcept;

private:
  void AskForFifo(int priority);
  void AskForCore(int core);
  void AskForMemory(const SchedulingRequest& request);
  void Lock(const MemoryRange& range);

  SchedulingReport Got;
  std::vector<MemoryRange> Locked;
  unsigned FloatState = 0;
  bool FloatChanged = false;
  bool AllLocked = false;
};

/// Whether a thread takes more of a processor than it may, over time: CPU time beyond a share of
/// what passed adds up, what is left over pays it back. One late tick is forgiven, a run is not.
/// A value; time is passed in.
class CpuBudget
{
public:
  /// share  of the time, in (0, 1); mostExcessNs  this much beyond it is too much
  CpuBudget(double share, std::int64_t mostExcessNs) noexcept
    : Share(share),
      MostExcessNs(static_cast<double>(mostExcessNs))
  {
  }
  /// True while all is well. `costNs` of CPU time were used in the last `passedNs`.
  bool Spend(std::int64_t costNs, std::int64_t passedNs) noexcept
  {
    this->ExcessNs += static_cast<double>(costNs) - this->Share * static_cast<double>(passedNs);
    this->ExcessNs = this->ExcessNs > 0.0 ? this->ExcessNs : 0.0;
    return this->ExcessNs <= this->MostExcessNs;
  }

private:
  double Share, MostExcessNs;
  double ExcessNs = 0.0;
};

} // namespace hasp
