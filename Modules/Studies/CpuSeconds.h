#pragma once
#include <ctime>

namespace hasp
{

/// That this thread has used: what a hypervisor steals is not in it.
inline double CpuSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace hasp
