#pragma once
#include "MeasuredRows.h"

#if HASP_WITH_TBB
#include "Grid/Testing/WithThreads.h"
#endif

namespace hasp
{

/// Runs something with that many threads; with one where there is no oneTBB.
template <typename Make>
auto OnThreads(int threads, Make make)
{
#if HASP_WITH_TBB
  return testing::WithThreads(threads, make);
#else
  static_cast<void>(threads);
  return make();
#endif
}

/// A and B in turn, on that many threads each.
inline PairedTimes RaceOnThreads(
  int threads, const std::function<void()>& a, const std::function<void()>& b, int pairs)
{
  PairSettings settings;
  settings.pairs = pairs;
  return OnThreads(threads,
    [&] { return ComparePairs([&] { return TimeOf(a); }, [&] { return TimeOf(b); }, settings); });
}

} // namespace hasp
