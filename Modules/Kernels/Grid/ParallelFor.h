#pragma once
#include <cstdint>
#include <functional>

namespace hasp
{

/// Calls body(first, last) on disjoint pieces that cover [begin, end), each of at most `grain`
/// items, on all cores with oneTBB and on the calling thread without it (HASP_ENABLE_TBB=OFF).
///
/// The pieces are the same whatever the number of threads, so a body that writes only to slots of
/// its own piece gives the same result everywhere. An exception in a body reaches the caller.
void ParallelFor(std::int64_t begin, std::int64_t end, std::int64_t grain,
  const std::function<void(std::int64_t, std::int64_t)>& body);

/// Threads ParallelFor may use: 1 without oneTBB.
int ParallelThreads();

} // namespace hasp
