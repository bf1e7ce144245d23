#pragma once
#include <cstdint>

namespace hasp
{

enum class Confinement
{
  None,     ///< some limit could not be set: do not go on
  Limits,   ///< limits hold; the kernel (or this build) filters no system calls
  Filtered, ///< limits, and any system call that parsing does not need ends the process
};

/// Gives up what a process that only parses files does not need, for good. To be called once, by
/// the only thread, before the first file of unknown origin is opened.
///
/// Limits, everywhere: no core file, no file can grow, 16 descriptors (all above the standard three
/// are closed), no process or thread more (root is exempt from this one), no rights through setuid
/// programs, `processorSeconds`, and `memoryBytes` of addresses on top of those in use now - so
/// what the program and its libraries take on this machine is measured, not guessed.
///
/// Filter, where libseccomp was there to build with and the kernel agrees (some containers do not):
/// only reading files, memory without code, clocks and ending are left. Anything else - a program,
/// a process, a thread, a socket, opening to write, removing, renaming, tracing, signals to others
/// - ends the process with SIGSYS.
Confinement EnterSandbox(std::uint64_t memoryBytes, std::uint64_t processorSeconds);

} // namespace hasp
