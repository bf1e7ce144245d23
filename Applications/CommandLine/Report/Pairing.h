#pragma once
#include <functional>
#include <vector>

namespace hasp
{

/// One run. Wall time is what the user waits for; CPU time (all threads of the process) stays
/// comparable where other jobs or a hypervisor blur the wall.
struct Timing
{
  double wallS = 0.0;
  double cpuS = 0.0;
};

/// Runs `work` once. Whoever draws calls glFinish in it.
Timing TimeOf(const std::function<void()>& work);
/// The same with the CPU time of the calling thread alone, to the nanosecond: for work of one
/// thread.
Timing ThreadTimeOf(const std::function<void()>& work);

/// Median and quartiles of figures; linear between ranks.
struct Quartiles
{
  double q1 = 0.0;
  double median = 0.0;
  double q3 = 0.0;
};

/// Throws std::invalid_argument if there are none.
Quartiles QuartilesOf(std::vector<double> figures);

struct PairSettings
{
  int warmUps = 2; ///< pairs thrown away first, >= 1
  int pairs = 9;   ///< pairs that count, >= 9
};

struct PairedTimes
{
  Quartiles ratio;    ///< of wall A / wall B, taken pair by pair
  Quartiles cpuRatio; ///< of CPU A / CPU B, pair by pair
  Timing a;           ///< medians of each
  Timing b;
  int pairs = 0;
};

/// Measures A and B in turn, A B A B ..., so that what disturbs the machine disturbs both, and
/// takes the ratio of each pair. (The ratio of two medians would mix runs of different moments.)
/// Throws std::invalid_argument for too few pairs or warm-ups, std::runtime_error if a B took no
/// measurable time: repeat the work inside until it does.
PairedTimes ComparePairs(const std::function<Timing()>& a, const std::function<Timing()>& b,
  const PairSettings& settings = {});

} // namespace hasp
