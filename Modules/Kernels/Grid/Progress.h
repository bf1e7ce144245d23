#pragma once
#include <functional>
#include <stdexcept>

namespace hasp
{

/// Called now and then with the share done, in [0,1], from the thread that called the kernel.
/// Return false to cancel: the kernel then throws Cancelled and leaves its inputs untouched.
/// An empty function means: no progress, never cancelled.
using ProgressFunction = std::function<bool(double)>;

struct Cancelled : std::runtime_error
{
  Cancelled() : std::runtime_error("cancelled") {}
};

inline void ReportProgress(const ProgressFunction& progress, double share)
{
  if (progress && !progress(share))
    throw Cancelled();
}

} // namespace hasp
