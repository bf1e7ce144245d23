#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

namespace hasp
{

/// How often which time was seen: what NanosecondHistogram held at one moment. A plain value of
/// 8 KiB; any thread.
struct NanosecondCounts
{
  /// 0 to 31 ns one by one, then 32 bins an octave up to 2^36 ns (69 s), where the last one takes
  /// all that is longer.
  static constexpr int Bins = 1024;
  std::array<std::uint64_t, Bins> counts{};
  std::uint64_t total = 0; ///< of all bins
  double sumNs = 0.0;
  std::int64_t leastNs = 0, mostNs = 0; ///< exact; 0 while there is none

  double MeanNs() const noexcept;

  /// The time that `share` (in [0, 1]) of all are not above: nearest rank, the middle of its bin,
  /// so right within 1/64 of itself, and never outside [leastNs, mostNs]. 0 while there is none.
  double PercentileNs(double share) const noexcept;

  /// How many were longer than the bin that `ns` is in.
  std::uint64_t Above(std::int64_t ns) const noexcept;

  /// What came since `earlier` of the same histogram. leastNs and mostNs are then the edges of the
  /// bins they are in.
  NanosecondCounts Since(const NanosecondCounts& earlier) const noexcept;

  static int BinOf(std::int64_t ns) noexcept;
  static std::int64_t FirstOf(int bin) noexcept; ///< the shortest time in that bin
};

/// Times counted while they happen. Fixed memory (8 KiB), however many there are.
///
/// Threads: Add on one, Read on any other at the same time; neither waits, all of it is atomic.
/// What Read gives is no instant between two Adds: a bin may be one ahead of the sum. Its total is
/// that of its bins. Cost: about 5 ns an Add, 4 us a Read.
class NanosecondHistogram
{
public:
  /// What is negative counts as 0.
  void Add(std::int64_t ns) noexcept;
  NanosecondCounts Read() const noexcept;

private:
  std::array<std::atomic<std::uint64_t>, NanosecondCounts::Bins> Counts{};
  std::atomic<double> SumNs{ 0.0 };
  std::atomic<std::int64_t> LeastNs{ std::numeric_limits<std::int64_t>::max() };
  std::atomic<std::int64_t> MostNs{ 0 };

  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  static_assert(std::atomic<double>::is_always_lock_free);
};

} // namespace hasp
