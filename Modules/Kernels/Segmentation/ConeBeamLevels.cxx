#include "Segmentation/ConeBeamLevels.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{
namespace
{

/// body(first, last, slot) on pieces of all samples, slots 0 … 63; then join(slot) for each of them
/// in turn, before the next 64 pieces.
template <typename Body, typename Join>
void InPieces(
  std::int64_t size, const ProgressFunction& progress, const Body& body, const Join& join)
{
  constexpr std::int64_t grain = 1 << 16, together = 64 * grain;
  for (std::int64_t from = 0; from < size; from += together)
  {
    ReportProgress(progress, double(from) / double(size));
    const std::int64_t to = std::min(from + together, size);
    ParallelFor(from, to, grain,
      [&](std::int64_t first, std::int64_t last) { body(first, last, (first - from) / grain); });
    for (std::int64_t first = from; first < to; first += grain)
      join((first - from) / grain);
  }
}

struct Range
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double count = 0.0;
  double atLow = 0.0; ///< how many are `low` itself

  void Add(double value)
  {
    this->count += 1.0;
    this->high = std::max(this->high, value);
    if (value < this->low)
    {
      this->low = value;
      this->atLow = 0.0;
    }
    this->atLow += value == this->low;
  }
  void Add(const Range& other)
  {
    this->atLow =
      (this->low <= other.low ? this->atLow : 0.0) + (other.low <= this->low ? other.atLow : 0.0);
    this->low = std::min(this->low, other.low);
    this->high = std::max(this->high, other.high);
    this->count += other.count;
  }
};

constexpr int Bins = 4096;

struct Histogram
{
  double low = 0.0, width = 1.0;
  double below = 0.0; ///< samples below `low`
  double all = 0.0;   ///< also those above the last bin
  std::vector<double> count = std::vector<double>(Bins);

  double Middle(double bin) const { return this->low + (bin + 0.5) * this->width; }
  double Quantile(double share) const
  {
    double sum = this->below;
    for (int b = 0; b < Bins; ++b)
    {
      sum += this->count[b];
      if (sum >= share * this->all)
        return this->Middle(b);
    }
    return this->Middle(Bins - 1);
  }
  /// Samples within `reach` bins of each.
  std::vector<double> Windows(int reach) const
  {
    std::vector<double> sums(Bins + 1), windows(Bins);
    for (int b = 0; b < Bins; ++b)
      sums[b + 1] = sums[b] + this->count[b];
    for (int b = 0; b < Bins; ++b)
      windows[b] = sums[std::min(b + reach, Bins - 1) + 1] - sums[std::max(b - reach, 0)];
    return windows;
  }
  /// Mean of the samples within `reach` bins of one.
  double MeanNear(int bin, int reach) const
  {
    double sum = 0.0, mean = 0.0;
    for (int b = std::max(bin - reach, 0); b <= std::min(bin + reach, Bins - 1); ++b)
    {
      sum += this->count[b];
      mean += this->count[b] * this->Middle(b);
    }
    return mean / sum;
  }
};

/// Looks at the samples of one side of insideAbove.
template <typename T>
class Side
{
public:
  Side(const GridView<const T>& view, double insideAbove, bool inside)
    : Samples(view.data),
      Size(static_cast<std::int64_t>(view.geometry.Size())),
      InsideAbove(insideAbove),
      Inside(inside)
  {
  }

  Range FindRange(const ProgressFunction& progress) const
  {
    std::array<Range, 64> slots;
    Range all;
    InPieces(
      this->Size, progress,
      [&](std::int64_t first, std::int64_t last, std::int64_t slot)
      { this->ForEach(first, last, [&](double value) { slots[slot].Add(value); }); },
      [&](std::int64_t slot)
      {
        all.Add(slots[slot]);
        slots[slot] = Range();
      });
    return all;
  }

  Histogram Count(double low, double high, const ProgressFunction& progress) const
  {
    struct Slot
    {
      std::array<std::uint32_t, Bins> count{};
      std::uint32_t below = 0, all = 0;
    };
    std::vector<Slot> slots(64);
    Histogram histogram;
    histogram.low = low;
    histogram.width = high > low ? (high - low) / Bins : 1.0;
    const auto add = [&](Slot& slot, double value)
    {
      ++slot.all;
      const double bin = (value - low) / histogram.width;
      if (bin < 0.0)
        ++slot.below;
      else if (value <= high)
        ++slot.count[static_cast<int>(std::min(bin, Bins - 1.0))];
    };
    InPieces(
      this->Size, progress,
      [&](std::int64_t first, std::int64_t last, std::int64_t slot)
      { this->ForEach(first, last, [&](double value) { add(slots[slot], value); }); },
      [&](std::int64_t slot)
      {
        for (int b = 0; b < Bins; ++b)
          histogram.count[b] += slots[slot].count[b];
        histogram.below += slots[slot].below;
        histogram.all += slots[slot].all;
        slots[slot] = Slot();
      });
    return histogram;
  }

  /// Bins where the samples are: single ones far off would leave all others in one bin.
  Histogram CountMost(const Range& range, const ProgressFunction& progress) const
  {
    Histogram histogram = this->Count(range.low, range.high, progress);
    constexpr int mostPasses = 8, fewBins = 256;
    for (int pass = 0; pass < mostPasses; ++pass)
    {
      const double low = histogram.Quantile(0.002), high = histogram.Quantile(0.998);
      const double margin = std::max(0.25 * (high - low), histogram.width);
      if (!(high - low < fewBins * histogram.width) || 2.0 * margin >= range.high - range.low)
        break;
      const double from = std::max(low - margin, range.low),
                   to = std::min(high + margin, range.high);
      if (!(to - from > 1e-6 * (std::abs(from) + std::abs(to))))
        break; // float has no finer steps
      histogram = this->Count(from, to, progress);
    }
    return histogram;
  }

private:
  template <typename Visit>
  void ForEach(std::int64_t first, std::int64_t last, const Visit& visit) const
  {
    for (std::int64_t n = first; n < last; ++n)
    {
      const double value = this->Samples[n];
      if (std::isfinite(value) && (value > this->InsideAbove) == this->Inside)
        visit(value);
    }
  }

  const T* Samples;
  std::int64_t Size;
  double InsideAbove;
  bool Inside;
};

/// The lowest plateau with a tenth of the samples, or the next one if that is padding.
std::optional<double> AirOf(const Histogram& outside, const Range& range, double insideAbove)
{
  const double span = insideAbove - outside.Quantile(0.01);
  const int reach = std::clamp(static_cast<int>(0.05 * span / outside.width), 1, Bins / 4);
  const std::vector<double> windows = outside.Windows(reach);
  const bool padded = range.atLow >= 0.1 * range.count;
  std::optional<double> air;
  for (int b = 0; b < Bins; ++b)
  {
    const auto first = windows.begin() + std::max(b - 2 * reach, 0);
    const auto last = windows.begin() + std::min(b + 2 * reach, Bins - 1) + 1;
    if (windows[b] < 0.1 * outside.all || *std::max_element(first, last) > windows[b])
      continue;
    const bool padding =
      padded && std::abs(outside.Middle(b) - range.low) <= (reach + 1) * outside.width;
    if (padding && air)
      continue; // the same plateau again
    air = outside.MeanNear(b, reach);
    if (!padding)
      break;
  }
  return air;
}

template <typename T>
ConeBeamLevels LevelsOf(
  const GridView<const T>& view, double insideAbove, const ProgressFunction& progress)
{
  const Side<T> inside(view, insideAbove, true), outside(view, insideAbove, false);
  const Range patient = inside.FindRange(PartOf(progress, 0.0, 0.2));
  const Range rest = outside.FindRange(PartOf(progress, 0.2, 0.4));
  if (patient.count == 0.0)
    throw std::invalid_argument(
      "cone beam: no sample is > insideAbove, which is " + std::to_string(insideAbove) +
      (rest.count > 0.0 ? "; the largest is " + std::to_string(rest.high) : "; none is finite"));
  ConeBeamLevels levels;
  const Histogram tissue = inside.CountMost(patient, PartOf(progress, 0.4, 0.7));
  if (rest.count >= 0.001 * (patient.count + rest.count))
    levels.air = AirOf(outside.CountMost(rest, PartOf(progress, 0.7, 1.0)), rest, insideAbove);
  levels.lowest = std::max(tissue.Quantile(0.005), patient.low);
  levels.highest = std::min(tissue.Quantile(0.999), patient.high);
  // A window wide enough for cupping and noise: soft tissue is one level nevertheless.
  const double span =
    levels.air ? tissue.Quantile(0.5) - *levels.air : levels.highest - levels.lowest;
  const int reach = std::clamp(static_cast<int>(0.06 * span / tissue.width), 1, Bins / 4);
  const std::vector<double> windows = tissue.Windows(reach);
  const auto strongest = std::max_element(windows.begin(), windows.end()) - windows.begin();
  levels.softTissue =
    std::clamp(tissue.MeanNear(static_cast<int>(strongest), reach), patient.low, patient.high);
  return levels;
}

} // namespace

ConeBeamLevels FindConeBeamLevels(
  const AnyGridView& grid, double insideAbove, const ProgressFunction& progress)
{
  return std::visit([&](const auto& view) { return LevelsOf(view, insideAbove, progress); }, grid);
}

} // namespace hasp
