#pragma once
#include <string>

/// Takes the place of the C library's open, write, fsync, fdatasync, ftruncate, fcntl, close,
/// rename, unlink and mkdir in a test program, also for the libraries that it loads. They do what
/// they always do but while armed.
namespace failing
{
enum class Way
{
  Error, ///< the call fails with ENOSPC
  Gone,  ///< it and all behind it do
  Crash  ///< the program ends before it, a write half done
};

/// The `call`-th call from now, 1 and up, fails so. 0: none does, they are counted.
void Arm(int call, Way way);
/// Which calls there were since, each with a space behind it.
std::string Disarm();
} // namespace failing
