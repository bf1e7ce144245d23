#include "Segmentation/GreyHistogram.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace hasp
{
namespace
{

constexpr std::size_t MostBins = 65536;
constexpr std::int64_t Grain = 1 << 20;

/// Pieces of the samples side by side; progress between groups of them.
template <typename Body>
void ForPieces(std::size_t samples, const ProgressFunction& progress, Body&& body)
{
  const auto end = static_cast<std::int64_t>(samples);
  for (std::int64_t from = 0; from < end; from += 16 * Grain)
  {
    ReportProgress(progress, double(from) / double(end));
    ParallelFor(from, std::min(from + 16 * Grain, end), Grain, body);
  }
}

struct Range
{
  double low = HUGE_VAL, high = -HUGE_VAL;
};

template <typename T>
Range FiniteRange(const GridView<const T>& grid, const ProgressFunction& progress)
{
  const std::size_t samples = grid.geometry.Size();
  std::vector<Range> pieces((samples + Grain - 1) / Grain);
  ForPieces(samples, progress,
    [&](std::int64_t first, std::int64_t last)
    {
      Range range;
      for (std::int64_t n = first; n < last; ++n)
        if (const double value = grid.data[n]; std::isfinite(value))
          range = { std::min(range.low, value), std::max(range.high, value) };
      pieces[static_cast<std::size_t>(first / Grain)] = range;
    });
  Range all;
  for (const Range& range : pieces)
    all = { std::min(all.low, range.low), std::max(all.high, range.high) };
  return all;
}

/// Counts into bins from `lowest` on; what lies beyond them is left out.
template <typename T>
GreyHistogram Count(const GridView<const T>& grid, double lowest, double binWidth, std::size_t bins,
  const ProgressFunction& progress)
{
  std::vector<std::atomic<std::uint64_t>> counts(bins);
  ForPieces(grid.geometry.Size(), progress,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<std::uint32_t> piece(bins);
      for (std::int64_t n = first; n < last; ++n)
      {
        const double bin = std::floor((double(grid.data[n]) - lowest) / binWidth);
        if (bin >= 0.0 && bin < double(bins)) // false for NaN
          ++piece[static_cast<std::size_t>(bin)];
      }
      for (std::size_t b = 0; b < bins; ++b)
        if (piece[b] > 0)
          counts[b].fetch_add(piece[b], std::memory_order_relaxed); // a sum has no order
    });
  return { lowest, binWidth, { counts.begin(), counts.end() } };
}

/// The bins within which all but 0.01 % at each end lie: first and one beyond the last.
std::pair<std::size_t, std::size_t> BulkOf(const GreyHistogram& histogram)
{
  std::uint64_t all = 0;
  for (const std::uint64_t count : histogram.counts)
    all += count;
  const std::uint64_t few = all / 10000;
  std::size_t first = 0, last = histogram.counts.size();
  for (std::uint64_t sum = histogram.counts[first]; sum <= few;)
    sum += histogram.counts[++first];
  for (std::uint64_t sum = histogram.counts[last - 1]; sum <= few;)
    sum += histogram.counts[--last - 1];
  return { first, last };
}

GreyHistogram Trimmed(GreyHistogram histogram)
{
  const auto full = [](std::uint64_t count) { return count > 0; };
  std::vector<std::uint64_t>& counts = histogram.counts;
  const auto first = std::find_if(counts.begin(), counts.end(), full);
  histogram.lowest += histogram.binWidth * double(first - counts.begin());
  counts.erase(counts.begin(), first);
  while (!counts.empty() && counts.back() == 0)
    counts.pop_back();
  return histogram;
}

template <typename T>
GreyHistogram HistogramOf(const GridView<const T>& grid, const ProgressFunction& progress)
{
  Range range = FiniteRange(grid, PartOf(progress, 0.0, 0.4));
  if (!(range.low <= range.high))
    return {};
  if (std::is_integral_v<T> || range.low == range.high)
    return Count(grid, range.low - 0.5, 1.0, std::size_t(range.high - range.low) + 1,
      PartOf(progress, 0.4, 1.0));
  GreyHistogram whole;
  double done = 0.4;
  for (int pass = 1;; ++pass, done += 0.5 * (1.0 - done))
  {
    // A little wider, so that the largest value has a bin; halves first, so that nothing overflows.
    const double width = (range.high / MostBins - range.low / MostBins) * (1.0 + 1e-9);
    GreyHistogram histogram =
      Count(grid, range.low, width, MostBins, PartOf(progress, done, 0.5 + 0.5 * done));
    const auto [first, last] = BulkOf(histogram);
    const Range bulk{ range.low + double(first) * width, range.low + double(last) * width };
    // Floats have 24 bits: below that nothing is left to be told apart.
    const double most = std::max(std::abs(bulk.low), std::abs(bulk.high));
    const bool oneValue = bulk.high - bulk.low < 1e-7 * most || pass == 16;
    if (last - first >= 256)
      return Trimmed(std::move(histogram));
    if (oneValue) // so the few are all that there is besides
      return Trimmed(std::move(pass == 1 ? histogram : whole));
    if (pass == 1)
      whole = std::move(histogram);
    range = bulk;
  }
}

} // namespace

GreyHistogram CountGreyValues(const AnyGridView& grid, const ProgressFunction& progress)
{
  GreyHistogram histogram =
    std::visit([&](const auto& view) { return HistogramOf(view, progress); }, grid);
  ReportProgress(progress, 1.0);
  return histogram;
}

} // namespace hasp
