#include "Realtime/RealTimeScheduling.h"

#include <gtest/gtest.h>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

namespace
{

using namespace hasp;

// Sanitizers answer mlock themselves and lock nothing: what the kernel says is then no truth.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr bool LocksMemory = false;
#else
constexpr bool LocksMemory = true;
#endif

int Policy()
{
  return sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
}

/// kB of memory that the kernel says this process has locked: another source than our report.
long LockedKb()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmLck:")
    {
      long kb = -1;
      status >> kb;
      return kb;
    }
  return -1;
}

const SchedulingRequest Nothing{ .fifoPriority = 0,
  .exactTimer = false,
  .flushDenormals = false,
  .lock = MemoryLocking::None };

/// On a thread of its own: what is asked for stays with that.
template <class Body>
void OnThread(const Body& body)
{
  std::thread(body).join();
}

TEST(RealTimeScheduling, WhatIsNotAskedForIsNotDone)
{
  OnThread(
    []
    {
      const RealTimeScheduling scheduling(Nothing);
      const SchedulingReport& got = scheduling.Report();
      EXPECT_TRUE(got.Shortfalls().empty());
      EXPECT_FALSE(got.fifo.asked || got.core.asked || got.timer.asked || got.denormals.asked ||
                   got.memory.asked);
      EXPECT_EQ(got.priority, 0);
      EXPECT_EQ(got.lockedBytes, 0u);
      EXPECT_EQ(Policy(), SCHED_OTHER);
    });
}

/// Whoever runs this, root or not: the report says what the kernel says.
TEST(RealTimeScheduling, TheReportIsWhatTheKernelSays)
{
  OnThread(
    []
    {
      SchedulingRequest request = Nothing;
      request.fifoPriority = 5;
      {
        const RealTimeScheduling scheduling(request);
        const SchedulingReport& got = scheduling.Report();
        EXPECT_EQ(got.fifo.granted, Policy() == SCHED_FIFO);
        EXPECT_EQ(got.priority > 0, got.fifo.granted);
        EXPECT_EQ(got.fifo.granted, got.fifo.why.empty());
        sched_param param{};
        sched_getparam(0, &param);
        EXPECT_EQ(param.sched_priority, got.priority);
        int child = -1; // a thread that this one starts is no real-time thread
        OnThread([&] { child = Policy(); });
        EXPECT_EQ(child, SCHED_OTHER);
      }
      EXPECT_EQ(Policy(), SCHED_OTHER) << "given back";
    });
}

TEST(RealTimeScheduling, DenormalsAreFlushedOnThisThreadUntilTheEnd)
{
#if defined(__SSE__)
  OnThread(
    []
    {
      volatile double tiny = 3e-308, tinier = 0;
      SchedulingRequest request = Nothing;
      request.flushDenormals = true;
      {
        const RealTimeScheduling scheduling(request);
        EXPECT_TRUE(scheduling.Report().denormals.granted);
        tinier = tiny / 4.0;
        EXPECT_EQ(tinier, 0.0);
        OnThread([&] { tinier = tiny / 4.0; }); // a new thread takes over the state of its maker
      }
      tinier = tiny / 4.0;
      EXPECT_GT(tinier, 0.0) << "given back";
    });
  volatile double tiny = 3e-308;
  volatile double tinier = tiny / 4.0;
  EXPECT_GT(tinier, 0.0) << "not this thread's";
#else
  GTEST_SKIP() << "known for SSE and one compiler of ARM64 alone";
#endif
}

TEST(RealTimeScheduling, NamedMemoryIsLockedAndUnlocked)
{
  if (!LocksMemory)
    GTEST_SKIP() << "a sanitizer stands before mlock";
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t bytes = 64 * page;
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  OnThread(
    [&]
    {
      const long before = LockedKb();
      SchedulingRequest request = Nothing;
      request.lock = MemoryLocking::Named;
      request.ranges = { { memory, bytes }, { nullptr, 0 } };
      {
        const RealTimeScheduling scheduling(request);
        const SchedulingReport& got = scheduling.Report();
        ASSERT_TRUE(got.memory.granted) << got.memory.why;
        EXPECT_EQ((LockedKb() - before) * 1024, static_cast<long>(got.lockedBytes));
        EXPECT_GE(got.lockedBytes, bytes + (std::size_t(64) << 10)) << "and the stack";
        EXPECT_LE(got.lockedBytes, bytes + (std::size_t(64) << 10) + 2 * page);
      }
      EXPECT_EQ(LockedKb(), before);
    });
  munmap(memory, bytes);
}

TEST(RealTimeScheduling, WhatIsNoMemoryAndNoCoreIsSaid)
{
  OnThread(
    []
    {
      SchedulingRequest request = Nothing;
      request.lock = MemoryLocking::Named;
      request.ranges = { { reinterpret_cast<const void*>(std::uintptr_t(4096)), 4096 } };
      request.core = 100'000;
      const RealTimeScheduling scheduling(request);
      const auto texts = scheduling.Report().Shortfalls();
      ASSERT_EQ(texts.size(), LocksMemory ? 2u : 1u);
      EXPECT_NE(texts[0].find("core 100000"), std::string::npos) << texts[0];
      for (std::size_t text = 1; text < texts.size(); ++text)
        EXPECT_NE(texts[text].find("4096 bytes are not locked"), std::string::npos) << texts[text];
    });
}

TEST(RealTimeScheduling, StaysOnTheCoreItIsGiven)
{
  OnThread(
    []
    {
      cpu_set_t allowed;
      CPU_ZERO(&allowed);
      ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
      int last = 0;
      for (int core = 0; core < CPU_SETSIZE; ++core)
        last = CPU_ISSET(core, &allowed) ? core : last;
      SchedulingRequest request = Nothing;
      request.core = last;
      const RealTimeScheduling scheduling(request);
      EXPECT_EQ(scheduling.Report().core.granted, CPU_COUNT(&allowed) > 1);
      if (scheduling.Report().core.granted)
      {
        EXPECT_EQ(sched_getcpu(), last);
      }
    });
}

/// In a process of its own, as an ordinary user with the usual limits. Its exit code says which
/// promise was broken.
int AsOrdinaryUser()
{
  const rlimit none{ 0, 0 }, small{ 1 << 20, 1 << 20 };
  setrlimit(RLIMIT_RTPRIO, &none);
  setrlimit(RLIMIT_MEMLOCK, &small);
  if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0)
    return 1;
  int failed = 0;
  const auto body = [&failed]
  {
    SchedulingRequest request;
    request.lock = MemoryLocking::Everything;
    const RealTimeScheduling scheduling(request);
    const SchedulingReport& got = scheduling.Report();
    if (!got.fifo.Refused() || got.fifo.why.find("rtprio") == std::string::npos ||
        got.priority != 0)
      failed = 2;
    else if (!got.memory.Refused() || got.memory.why.find("1048576") == std::string::npos)
      failed = 3;
    else if (LockedKb() > 80) // the stack alone
      failed = 4;
    else if (got.lockedBytes == 0)
      failed = 5;
    // The trap: with all future memory locked, this thread (8 MiB of stack) could not start.
    try
    {
      std::thread([] {}).join();
    }
    catch (const std::exception&)
    {
      failed = 6;
    }
  };
  std::thread(body).join();
  return failed;
}

TEST(RealTimeScheduling, AnOrdinaryUserIsToldAndRunsOn)
{
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
    _exit(AsOrdinaryUser());
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(RealTimeScheduling, CanBeDroppedWhileItRuns)
{
  OnThread(
    []
    {
      SchedulingRequest request = Nothing;
      request.fifoPriority = 3;
      const RealTimeScheduling scheduling(request);
      EXPECT_TRUE(RealTimeScheduling::DropToNormal());
      EXPECT_EQ(Policy(), SCHED_OTHER);
    });
}

} // namespace
