#pragma once
#include <functional>

/// Runs a piece of work in a child process of which the kernel shows each system call to this one,
/// which lets some of them fail: not only those that a library asks for by name, all of them.
/// Linux on x86-64. Calls that concern memory, signals and threads alone are let through.
namespace faults
{

enum class Way
{
  Error, ///< the call fails with EIO
  Full,  ///< it and all behind it fail with ENOSPC; closing still closes
  Kill   ///< the process is killed before it
};

struct Run
{
  int calls = 0;       ///< of the work, so far as it came
  bool killed = false; ///< else it ended by itself:
  int status = -1;     ///< what `after` gave
};

/// `before`, then `work` with its `call`-th call (1 and up) failing, then `after`, whose value is
/// the child's exit code. What any of them throws ends the child with 100.
Run InChild(const std::function<void()>& before, const std::function<void()>& work,
  const std::function<int()>& after, int call, Way way);

/// Whether a process may be watched here: containers can forbid it.
bool AreAllowed();

} // namespace faults
