#pragma once
// Runs something with a given number of threads. Only with oneTBB: without it there is one anyway.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace hasp::testing
{

/// What `make()` returns when ParallelFor may use `threads` of them, also beyond the machine's
/// cores.
template <typename Make>
auto WithThreads(int threads, Make make)
{
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  return arena.execute(make);
}

} // namespace hasp::testing
