#pragma once
#include <cstdint>
#include <span>

namespace hasp
{

struct CostModelSettings
{
  double firstUsPerPoint = 0.02; ///< until a tick was measured: a slow core's; > 0
  double share = 0.05;           ///< of a new measurement in the mean, in (0, 1]
  /// A level is added when it takes this share of the budget at most, in (0, 1]. It is dropped over
  /// the whole budget: between both nothing changes, so that levels do not flicker.
  double roomToAdd = 0.8;
  int coarseLevels = 1; ///< always evaluated, whatever they cost; >= 0
};

/// What points cost here and now, and so how many of them a budget allows: an exponentially
/// weighted mean of microseconds a point. A tick in which the system took the core away counts as
/// one of four times the mean at most; a slower core is followed within some dozen ticks.
///
/// Threads: HAPTIC; takes no memory, no lock, and does not throw once made.
class CostModel
{
public:
  /// Throws std::invalid_argument on a setting out of its range.
  explicit CostModel(const CostModelSettings& settings = {});

  /// A tick evaluated `points` in `us`. Without points, or if us is not a number > 0, nothing is
  /// learnt.
  void Measure(std::uint32_t points, double us) noexcept;

  double UsPerPoint() const noexcept { return this->Mean; }
  /// Points that `budgetUs` allows: 0 for no budget; a budget that is no number allows nothing.
  std::uint32_t Points(double budgetUs) const noexcept;

  /// Levels to evaluate in a tick, coarsest first: as many as the budget allows, and
  /// settings.coarseLevels in any case. points: that each level is expected to add (those that the
  /// coarse phase accepts). One more than in the last call at most, so that a finer one can be
  /// blended in; fewer at once. O(levels).
  int Levels(std::span<const std::uint32_t> points, double budgetUs) noexcept;

private:
  CostModelSettings Settings;
  double Mean;
  int LastLevels = 0;
};

} // namespace hasp
