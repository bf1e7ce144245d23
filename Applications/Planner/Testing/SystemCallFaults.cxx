#include "SystemCallFaults.h"

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <stdexcept>

namespace faults
{
namespace
{

constexpr int Threw = 100;

bool IsSpared(long long number)
{
  constexpr std::array<long long, 15> spared{ SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap,
    SYS_mprotect, SYS_madvise, SYS_futex, SYS_rt_sigprocmask, SYS_rt_sigaction, SYS_rt_sigreturn,
    SYS_getpid, SYS_gettid, SYS_tgkill, SYS_exit, SYS_exit_group };
  return std::find(spared.begin(), spared.end(), number) != spared.end();
}

/// Until the child stops or ends; its status.
int Wait(pid_t child)
{
  int status = 0;
  if (waitpid(child, &status, 0) != child)
    throw std::runtime_error("the child is gone");
  return status;
}

bool Ended(int status)
{
  return WIFEXITED(status) || WIFSIGNALED(status);
}

bool StopsBy(int status, int signal)
{
  return WIFSTOPPED(status) && WSTOPSIG(status) == signal;
}

void Go(pid_t child, int request, long signal = 0)
{
  if (ptrace(static_cast<__ptrace_request>(request), child, nullptr, signal) != 0)
    throw std::runtime_error("the child cannot go on");
}

/// Of a child that stands before a call: what the call is to give instead of what it would.
void Pretend(pid_t child, user_regs_struct entry, int error)
{
  if (entry.orig_rax != SYS_close) // a descriptor is gone, whatever close says
  {
    entry.orig_rax = static_cast<unsigned long long>(-1); // no such call
    ptrace(PTRACE_SETREGS, child, nullptr, &entry);
  }
  Go(child, PTRACE_SYSCALL);
  if (!StopsBy(Wait(child), SIGTRAP | 0x80))
    throw std::runtime_error("a call does not return");
  user_regs_struct exit{};
  ptrace(PTRACE_GETREGS, child, nullptr, &exit);
  exit.rax = static_cast<unsigned long long>(-error);
  ptrace(PTRACE_SETREGS, child, nullptr, &exit);
}

/// From the first SIGSTOP to the second. False: the child has been killed.
bool Watch(pid_t child, int call, Way way, Run& run)
{
  for (long signal = 0;;)
  {
    Go(child, PTRACE_SYSCALL, signal);
    const int status = Wait(child);
    if (StopsBy(status, SIGSTOP))
      return true;
    signal = WIFSTOPPED(status) && !StopsBy(status, SIGTRAP | 0x80) ? WSTOPSIG(status) : 0;
    if (signal != 0)
      continue; // a signal of the child's own, SIGXFSZ for one
    if (!StopsBy(status, SIGTRAP | 0x80))
      throw std::runtime_error("the child ended within its work");
    user_regs_struct entry{};
    ptrace(PTRACE_GETREGS, child, nullptr, &entry);
    const bool counts = !IsSpared(static_cast<long long>(entry.orig_rax));
    run.calls += counts ? 1 : 0;
    if (counts && (run.calls == call || (way == Way::Full && run.calls > call)))
    {
      if (way == Way::Kill)
        return false;
      Pretend(child, entry, way == Way::Full ? ENOSPC : EIO);
      continue;
    }
    Go(child, PTRACE_SYSCALL);
    Wait(child); // its return
  }
}

[[noreturn]] void RunChild(const std::function<void()>& before, const std::function<void()>& work,
  const std::function<int()>& after)
{
  int status = Threw;
  try
  {
    before();
    ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    raise(SIGSTOP);
    work();
    raise(SIGSTOP);
    status = after();
  }
  catch (const std::exception&)
  {
  }
  _exit(status);
}

} // namespace

Run InChild(const std::function<void()>& before, const std::function<void()>& work,
  const std::function<int()>& after, int call, Way way)
{
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no child process");
  if (child == 0)
    RunChild(before, work, after);
  Run run;
  int status = Wait(child);
  if (StopsBy(status, SIGSTOP))
  {
    ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    run.killed = !Watch(child, call, way, run);
    if (run.killed)
      kill(child, SIGKILL);
    else
      Go(child, PTRACE_CONT);
    status = Wait(child);
  }
  if (!Ended(status))
    throw std::runtime_error("the child stops where it should end");
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

bool AreAllowed()
{
  const pid_t child = fork();
  if (child == 0)
  {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0)
      raise(SIGSTOP);
    _exit(1);
  }
  const int status = Wait(child);
  if (Ended(status))
    return false;
  kill(child, SIGKILL);
  Wait(child);
  return true;
}

} // namespace faults
