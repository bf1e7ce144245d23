#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace hasp
{

/// What a run of a program cost, seen from outside.
struct MeasuredChild
{
  int exitCode = -1; ///< 128 + signal if one ended it
  bool late = false; ///< it was ended for taking too long
  double seconds = 0.0, cpuSeconds = 0.0;
  std::size_t heldBytes = 0;     ///< most anonymous and shared memory resident, sampled every 10 ms
  std::size_t residentBytes = 0; ///< most resident at all, mapped files too (VmHWM)
  std::string output;            ///< standard output
  std::string error;             ///< and standard error
};

struct ChildSettings
{
  std::string program = "/proc/self/exe"; ///< path; by default this very program
  double limitS = 0.0;                    ///< ended (SIGKILL) after this time; 0: never
};

/// Runs a program with these arguments and waits for it. Throws std::runtime_error if it cannot
/// be started or the system does not tell what it holds (only Linux does). Any thread.
MeasuredChild RunMeasured(
  const std::vector<std::string>& arguments, const ChildSettings& settings = {});

} // namespace hasp
