#include "Haptics/CostModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double MostAtOnce = 4.0; ///< times the mean, that one measurement may say

void Require(bool holds, const char* what, double value, const char* range)
{
  if (!holds)
    throw std::invalid_argument(
      "CostModel: " + std::string(what) + " is " + std::to_string(value) + "; it must be " + range);
}

} // namespace

CostModel::CostModel(const CostModelSettings& settings)
  : Settings(settings),
    Mean(settings.firstUsPerPoint)
{
  Require(std::isfinite(settings.firstUsPerPoint) && settings.firstUsPerPoint > 0.0,
    "firstUsPerPoint", settings.firstUsPerPoint, "finite and > 0");
  Require(settings.share > 0.0 && settings.share <= 1.0, "share", settings.share, "in (0, 1]");
  Require(settings.roomToAdd > 0.0 && settings.roomToAdd <= 1.0, "roomToAdd", settings.roomToAdd,
    "in (0, 1]");
  Require(settings.coarseLevels >= 0, "coarseLevels", settings.coarseLevels, ">= 0");
}

void CostModel::Measure(std::uint32_t points, double us) noexcept
{
  const double each = us / points;
  if (points == 0 || !std::isfinite(each) || !(each > 0.0))
    return;
  const double counted = std::clamp(each, this->Mean / MostAtOnce, this->Mean * MostAtOnce);
  this->Mean += this->Settings.share * (counted - this->Mean);
}

std::uint32_t CostModel::Points(double budgetUs) const noexcept
{
  const double points = budgetUs / this->Mean;
  if (!(points > 0.0))
    return 0;
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  return points < static_cast<double>(most) ? static_cast<std::uint32_t>(points) : most;
}

int CostModel::Levels(std::span<const std::uint32_t> points, double budgetUs) noexcept
{
  const int count = static_cast<int>(points.size());
  const int least = std::min(this->Settings.coarseLevels, count);
  const int most = std::min(std::max(this->LastLevels + 1, least), count);
  double us = 0.0;
  int levels = 0;
  for (; levels < most; ++levels)
  {
    us += this->Mean * points[levels];
    const double allowed =
      levels < this->LastLevels ? budgetUs : this->Settings.roomToAdd * budgetUs;
    if (levels >= least && !(us <= allowed))
      break;
  }
  this->LastLevels = levels;
  return levels;
}

} // namespace hasp
