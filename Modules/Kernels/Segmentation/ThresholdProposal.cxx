#include "Segmentation/ThresholdProposal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

/// A grey value and how often it occurs; in order.
struct Level
{
  double value;
  double count;
};
using Levels = std::vector<Level>;

Levels LevelsOf(const GreyHistogram& histogram)
{
  Levels levels;
  for (std::size_t b = 0; b < histogram.counts.size(); ++b)
    if (histogram.counts[b] > 0)
      levels.push_back({ histogram.Middle(b), double(histogram.counts[b]) });
  return levels;
}

double Quantile(const Levels& levels, double share)
{
  double all = 0.0, sum = 0.0;
  for (const Level& level : levels)
    all += level.count;
  for (const Level& level : levels)
    if ((sum += level.count) >= share * all)
      return level.value;
  return levels.back().value;
}

/// A lowest value far below all others is what a scan was filled up with. More than one may be.
void LeavePaddingOut(Levels& levels)
{
  constexpr std::size_t fewest = 16;
  while (levels.size() > fewest)
  {
    const double range = Quantile(levels, 0.995) - levels[1].value;
    if (!(levels[1].value - levels[0].value > 0.02 * range))
      return;
    levels.erase(levels.begin());
  }
}

/// Cuts what is far brighter than nearly all others down.
void CutMetal(Levels& levels)
{
  const double bright = Quantile(levels, 0.95);
  const double most =
    std::max(Quantile(levels, 0.99), bright + 0.5 * (bright - Quantile(levels, 0.05)));
  if (most <= levels.front().value)
    return; // nearly all are one value: the others are all there is to tell apart
  for (Level& level : levels)
    level.value = std::min(level.value, most);
}

/// At most `most` levels: neighbours become one, at their mean.
Levels Coarser(const Levels& levels, int most)
{
  const double low = levels.front().value, step = (levels.back().value - low) / most;
  Levels coarse;
  int last = -1;
  for (const Level& level : levels)
  {
    const int bin = std::min(most - 1, static_cast<int>((level.value - low) / step));
    if (bin != last)
      coarse.push_back({ 0.0, 0.0 });
    last = bin;
    coarse.back().value += level.value * level.count;
    coarse.back().count += level.count;
  }
  for (Level& level : coarse)
    level.value /= level.count;
  return coarse;
}

/// Sums up to each level, so that a class costs nothing.
class Classes
{
public:
  explicit Classes(const Levels& levels)
    : Count(levels.size() + 1),
      Sum(levels.size() + 1),
      Squares(levels.size() + 1)
  {
    for (std::size_t n = 0; n < levels.size(); ++n)
    {
      const auto& [value, count] = levels[n];
      this->Count[n + 1] = this->Count[n] + count;
      this->Sum[n + 1] = this->Sum[n] + value * count;
      this->Squares[n + 1] = this->Squares[n] + value * value * count;
    }
  }
  double CountOf(std::size_t from, std::size_t to) const
  {
    return this->Count[to] - this->Count[from];
  }
  double Mean(std::size_t from, std::size_t to) const
  {
    return (this->Sum[to] - this->Sum[from]) / this->CountOf(from, to);
  }
  double Variance(std::size_t from, std::size_t to) const
  {
    const double mean = this->Mean(from, to);
    return std::max(
      0.0, (this->Squares[to] - this->Squares[from]) / this->CountOf(from, to) - mean * mean);
  }
  /// What classes share out of the variance between them, and is to be large.
  double Between(std::size_t from, std::size_t to) const
  {
    const double sum = this->Sum[to] - this->Sum[from];
    return sum * sum / this->CountOf(from, to);
  }

private:
  std::vector<double> Count, Sum, Squares;
};

/// First levels of soft tissue and of bone.
struct Split
{
  std::size_t soft = 0, bone = 1;
};

Split Otsu(const Classes& classes, std::size_t levels, int count)
{
  Split best;
  double most = -1.0;
  const std::size_t lastSoft = count == 3 && levels > 2 ? levels - 2 : 0;
  for (std::size_t soft = lastSoft > 0 ? 1 : 0; soft <= lastSoft; ++soft)
    for (std::size_t bone = soft + 1; bone < levels; ++bone)
    {
      const double between = (soft > 0 ? classes.Between(0, soft) : 0.0) +
                             classes.Between(soft, bone) + classes.Between(bone, levels);
      if (between > most)
      {
        most = between;
        best = { soft, bone };
      }
    }
  return best;
}

/// Where fewest values are in the wrong class if both are Gaussians, between Otsu's means (Kittler
/// and Illingworth 1986): a narrow class of soft tissue and a wide one of bone part near the narrow
/// one, and Otsu parts them in the middle.
Split MinimumError(const Classes& classes, const Levels& levels, const Split& otsu)
{
  const std::size_t end = levels.size();
  const double low = classes.Mean(otsu.soft, otsu.bone), high = classes.Mean(otsu.bone, end);
  const double step = (levels.back().value - levels.front().value) / double(end);
  const double all = classes.CountOf(otsu.soft, end);
  const auto cost = [&](std::size_t from, std::size_t to)
  {
    const double share = classes.CountOf(from, to) / all;
    const double variance = std::max(classes.Variance(from, to), step * step / 12.0);
    return share * (std::log(variance) - 2.0 * std::log(share));
  };
  Split best = otsu;
  double least = cost(otsu.soft, otsu.bone) + cost(otsu.bone, end);
  for (std::size_t bone = otsu.soft + 1; bone < end; ++bone)
    if (levels[bone - 1].value >= low && levels[bone].value <= high)
      if (const double both = cost(otsu.soft, bone) + cost(bone, end); both < least)
      {
        least = both;
        best.bone = bone;
      }
  return best;
}

} // namespace

ThresholdProposal ProposeThreshold(
  const GreyHistogram& histogram, const ThresholdSettings& settings)
{
  if (settings.classes != 2 && settings.classes != 3)
    throw std::invalid_argument(
      "threshold: " + std::to_string(settings.classes) + " classes, must be 2 or 3");
  Levels levels = LevelsOf(histogram);
  if (levels.size() < 2)
    throw std::invalid_argument(
      levels.empty() ? "threshold: the scan has no finite sample"
                     : "threshold: all samples have one value, so nothing stands out; choose the "
                       "threshold by hand");
  LeavePaddingOut(levels);
  CutMetal(levels);
  // Squares of differences to the middle, so that a large offset costs no digits.
  const double middle = 0.5 * (levels.front().value + levels.back().value);
  for (Level& level : levels)
    level.value -= middle;
  levels = Coarser(levels, 1024);
  const Classes classes(levels);
  const auto [soft, bone] =
    MinimumError(classes, levels, Otsu(classes, levels.size(), settings.classes));
  const std::size_t end = levels.size();
  ThresholdProposal proposal;
  proposal.threshold = middle + 0.5 * (levels[bone - 1].value + levels[bone].value);
  proposal.softTissue = middle + classes.Mean(soft, bone);
  proposal.bone = middle + classes.Mean(bone, end);
  proposal.boneShare = classes.CountOf(bone, end) / classes.CountOf(0, end);
  const double variance = 0.5 * (classes.Variance(soft, bone) + classes.Variance(bone, end));
  proposal.separation = variance > 0.0 ? (proposal.bone - proposal.softTissue) / std::sqrt(variance)
                                       : std::numeric_limits<double>::infinity();
  return proposal;
}

ThresholdProposal ProposeThreshold(
  const AnyGridView& grid, const ThresholdSettings& settings, const ProgressFunction& progress)
{
  return ProposeThreshold(CountGreyValues(grid, progress), settings);
}

} // namespace hasp
