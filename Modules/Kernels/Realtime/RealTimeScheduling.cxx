#include "Realtime/RealTimeScheduling.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace hasp
{

namespace
{
constexpr std::size_t StackBytes = std::size_t(64)
                                   << 10; // a tick's; pthreads have 128 KiB at least

std::string ErrorText(int error)
{
  char text[128] = {};
  return strerror_r(error, text, sizeof text); // the GNU one: any thread
}

std::string LimitText(rlim_t limit)
{
  return limit == RLIM_INFINITY ? "unlimited" : std::to_string(limit);
}

rlim_t Limit(__rlimit_resource what)
{
  rlimit limit{};
  return getrlimit(what, &limit) == 0 ? limit.rlim_cur : 0;
}

SchedulingAnswer Granted()
{
  return { true, true, {} };
}

SchedulingAnswer Refused(std::string why)
{
  return { true, false, std::move(why) };
}

#if defined(__SSE__)
constexpr unsigned FlushBits = 0x8040; // results (FTZ) and operands (DAZ)
unsigned FloatRegister()
{
  return __builtin_ia32_stmxcsr();
}
void SetFloatRegister(unsigned bits)
{
  __builtin_ia32_ldmxcsr(bits);
}
#elif defined(__aarch64__) && defined(__GNUC__) && !defined(__clang__)
constexpr unsigned FlushBits = 1u << 24; // FZ
unsigned FloatRegister()
{
  return __builtin_aarch64_get_fpcr();
}
void SetFloatRegister(unsigned bits)
{
  __builtin_aarch64_set_fpcr(bits);
}
#else
constexpr unsigned FlushBits = 0; // not known here
unsigned FloatRegister()
{
  return 0;
}
void SetFloatRegister(unsigned) {}
#endif

/// The part of this thread's stack that ticks will use, every page of it written to.
[[gnu::noinline]] MemoryRange TouchStack()
{
  [[maybe_unused]] volatile unsigned char below[StackBytes];
  for (std::size_t at = 0; at < StackBytes; at += 1024)
    below[at] = 0;
  return { static_cast<const char*>(__builtin_frame_address(0)) - StackBytes, StackBytes };
}
} // namespace

RealTimeScheduling::RealTimeScheduling(const SchedulingRequest& request)
{
  if (request.core >= 0)
    this->AskForCore(request.core);
  if (request.exactTimer)
    this->Got.timer = prctl(PR_SET_TIMERSLACK, 1UL) == 0
                        ? Granted()
                        : Refused("wake-ups come up to 50 us late: " + ErrorText(errno));
  if (request.flushDenormals)
  {
    this->FloatState = FloatRegister();
    this->FloatChanged = FlushBits != 0;
    SetFloatRegister(this->FloatState | FlushBits);
    this->Got.denormals =
      FlushBits != 0 ? Granted() : Refused("denormal numbers stay: not known for this processor");
  }
  if (request.lock != MemoryLocking::None)
    this->AskForMemory(request);
  if (request.fifoPriority != 0)
    this->AskForFifo(request.fifoPriority); // last: what is above takes its time as everybody does
}

RealTimeScheduling::~RealTimeScheduling()
{
  if (this->Got.priority > 0)
    DropToNormal();
  if (this->AllLocked)
    munlockall();
  for (const MemoryRange& range : this->Locked)
    munlock(range.begin, range.bytes);
  if (this->FloatChanged)
    SetFloatRegister(this->FloatState);
}

void RealTimeScheduling::AskForCore(int core)
{
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  if (core >= CPU_SETSIZE || !CPU_ISSET(core, &allowed))
  {
    this->Got.core = Refused("core " + std::to_string(core) + " is none that this process may use");
    return;
  }
  if (CPU_COUNT(&allowed) < 2)
  {
    this->Got.core = Refused("there is one core alone: a pinned thread would gain nothing");
    return;
  }
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  const int error = pthread_setaffinity_np(pthread_self(), sizeof one, &one);
  this->Got.core =
    error == 0 ? Granted() : Refused("the thread stays on no core: " + ErrorText(error));
}

void RealTimeScheduling::AskForFifo(int priority)
{
  const auto set = [](int to)
  {
    const sched_param param{ to };
    // Threads that this one starts do not inherit it: pictures never run so.
    return pthread_setschedparam(pthread_self(), SCHED_FIFO | SCHED_RESET_ON_FORK, &param);
  };
  int error = set(priority);
  const rlim_t most = Limit(RLIMIT_RTPRIO);
  if (error == EPERM && most > 0 && most < static_cast<rlim_t>(priority))
  {
    priority = static_cast<int>(most);
    error = set(priority);
  }
  if (error == 0)
  {
    this->Got.fifo = Granted();
    this->Got.priority = priority;
    return;
  }
  this->Got.fifo =
    Refused("no real-time scheduling (SCHED_FIFO " + std::to_string(priority) +
            "): " + ErrorText(error) + "; the limit of real-time priorities is " + LimitText(most) +
            (error == EPERM ? ", raise it (rtprio in limits.conf) or give CAP_SYS_NICE" : ""));
}

void RealTimeScheduling::AskForMemory(const SchedulingRequest& request)
{
  std::string why;
  if (request.lock == MemoryLocking::Everything)
  {
    // On fault: an 8 MiB stack that a thread never uses stays unused.
    if (Limit(RLIMIT_MEMLOCK) != RLIM_INFINITY)
      why =
        "not all memory is locked: the limit is " + LimitText(Limit(RLIMIT_MEMLOCK)) +
        " bytes, and must be unlimited (memlock in limits.conf), or later threads could not start";
    else if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0)
      why = "not all memory is locked: " + ErrorText(errno);
    else
      this->AllLocked = true;
  }
  this->Got.memory = why.empty() ? Granted() : Refused(why);
  if (this->AllLocked)
  {
    TouchStack();
    return;
  }
  this->Lock(TouchStack());
  for (const MemoryRange& range : request.ranges)
    this->Lock(range);
}

void RealTimeScheduling::Lock(const MemoryRange& range)
{
  if (range.bytes == 0)
    return;
  if (mlock(range.begin, range.bytes) == 0)
  {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(range.begin);
    this->Got.lockedBytes += (begin + range.bytes + page - 1) / page * page - begin / page * page;
    this->Locked.push_back(range);
    return;
  }
  const int error = errno;
  std::string& why = this->Got.memory.why;
  this->Got.memory.granted = false;
  why += (why.empty() ? "" : "; ") + std::to_string(range.bytes) +
         " bytes are not locked: " + ErrorText(error) + ", the limit is " +
         LimitText(Limit(RLIMIT_MEMLOCK)) + " bytes in all";
}

bool RealTimeScheduling::DropToNormal() noexcept
{
  const sched_param param{ 0 };
  // The flag stays: who has no CAP_SYS_NICE may not take it back.
  return pthread_setschedparam(pthread_self(), SCHED_OTHER | SCHED_RESET_ON_FORK, &param) == 0;
}

std::vector<std::string> SchedulingReport::Shortfalls() const
{
  std::vector<std::string> texts;
  for (const SchedulingAnswer* answer :
    { &this->fifo, &this->core, &this->timer, &this->denormals, &this->memory })
    if (answer->Refused())
      texts.push_back(answer->why);
  return texts;
}

} // namespace hasp
