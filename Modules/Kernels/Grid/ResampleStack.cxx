#include "Grid/ResampleStack.h"
#include "Grid/ParallelFor.h"
#include "Grid/ShiftedSlice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

std::string Number(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

/// Slices that go into a gap, whether it is a whole multiple or not.
int SlicesIn(const SliceGap& gap, double usualGapMm)
{
  return static_cast<int>(std::max(std::lround(std::min(gap.mm / usualGapMm, 1e6)), 1L)) - 1;
}

int SlicesInAll(const StackMeasures& measures)
{
  int slices = 0;
  for (const SliceGap& gap : measures.gaps)
    slices += SlicesIn(gap, measures.usualGapMm);
  return slices;
}

/// Nothing moves where nothing is tilted; a slice within a thousandth of a sample of a whole number
/// of samples is there.
void PlanShifts(ResamplePlan& plan, glm::dvec2& first)
{
  const StackMeasures& m = plan.measures;
  plan.shifts.assign(m.heights.size(), glm::dvec2(0.0));
  first = glm::dvec2(0.0);
  plan.geometry.dims = { plan.stack.dims, 0 };
  if (!m.tilted)
    return;
  glm::dvec2 least(0.0), most(0.0);
  for (std::size_t k = 0; k < plan.shifts.size(); ++k)
  {
    glm::dvec2& shift = plan.shifts[k];
    shift = m.aside[k] / plan.stack.spacing;
    for (int a = 0; a < 2; ++a)
      if (std::abs(shift[a] - std::round(shift[a])) < 1e-3)
        shift[a] = std::round(shift[a]);
    least = glm::min(least, shift);
    most = glm::max(most, shift);
  }
  first = glm::floor(least);
  const glm::ivec2 more(glm::ceil(most) - first);
  plan.geometry.dims.x += more.x;
  plan.geometry.dims.y += more.y;
  for (glm::dvec2& shift : plan.shifts)
    shift -= first;
  plan.record.tiltDegrees = m.tiltDegrees;
  plan.record.farthestMove = m.farthestAsideMm;
}

void PlanSlices(ResamplePlan& plan)
{
  const std::vector<double>& heights = plan.measures.heights;
  const double usual = plan.measures.usualGapMm, top = heights.back();
  const int steps = static_cast<int>(std::max(std::lround(top / usual), 1L));
  const double forgiven = ForgivenGapMm(usual);
  ResampleRecord& record = plan.record;
  plan.geometry.spacing.z = top / steps;
  plan.geometry.dims.z = steps + 1;
  for (int m = 0; m <= steps; ++m)
  {
    const double height = m < steps ? m * plan.geometry.spacing.z : top;
    const auto above = std::upper_bound(heights.begin(), heights.end(), height);
    const int below = std::max(static_cast<int>(above - heights.begin()) - 1, 0);
    const int next = std::min(below + 1, static_cast<int>(heights.size()) - 1);
    const double down = std::abs(height - heights[below]), up = std::abs(heights[next] - height);
    const int nearest = down <= up ? below : next;
    const double off = std::min(down, up);
    if (off <= forgiven)
    {
      plan.slices.push_back({ nearest, nearest, 0.0 });
      ++record.slicesCopied;
      record.forgivenMm = std::max(record.forgivenMm, off);
      continue;
    }
    plan.slices.push_back({ below, next, down / (down + up) });
    ++record.slicesMade;
    record.farthestMm = std::max(record.farthestMm, off);
  }
}

template <typename T>
T SmallestOf(const ResamplePlan& plan, const T* samples)
{
  const std::int64_t slices = plan.record.slicesMeasured;
  const std::size_t inSlice = std::size_t(plan.stack.dims.x) * plan.stack.dims.y;
  std::vector<T> smallest(slices);
  ParallelFor(0, slices, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        smallest[k] = *std::min_element(samples + k * inSlice, samples + (k + 1) * inSlice);
    });
  return *std::min_element(smallest.begin(), smallest.end());
}

template <typename T>
T FromDouble(double value)
{
  if constexpr (std::numeric_limits<T>::is_integer)
    return static_cast<T>(std::nearbyint(value));
  else
    return static_cast<T>(value);
}

/// Slice m of the result. Returns how many of its samples no measured slice reaches.
template <typename T>
std::size_t MakeSlice(const ResamplePlan& plan, const T* samples, int m, T outside, T* into)
{
  const SliceRecipe& recipe = plan.slices[m];
  const ShiftedSlice<T> below(plan, samples, recipe.below), above(plan, samples, recipe.above);
  std::optional<BetweenSlices<T>> between;
  if (recipe.share > 0.0)
    between.emplace(plan, samples, recipe.below, recipe.above);
  const glm::ivec3& dims = plan.geometry.dims;
  const int firstX = std::max(below.FirstX(), above.FirstX());
  const int lastX = std::min(below.LastX(), above.LastX());
  const int firstY = std::max(below.FirstY(), above.FirstY());
  const int lastY = std::min(below.LastY(), above.LastY());
  std::size_t missed = 0;
  for (int j = 0; j < dims.y; ++j)
    for (int i = 0; i < dims.x; ++i, ++into)
    {
      if (i < firstX || i > lastX || j < firstY || j > lastY)
      {
        *into = outside;
        ++missed;
      }
      else if (between)
        *into = FromDouble<T>(between->At({ i, j }, recipe.share, below.At(i, j), above.At(i, j)));
      else
        *into = FromDouble<T>(below.At(i, j));
    }
  return missed;
}

} // namespace

std::string GapsBeyondLimits(const StackMeasures& measures, const ResampleLimits& limits)
{
  for (const SliceGap& gap : measures.gaps)
  {
    const int slices = SlicesIn(gap, measures.usualGapMm);
    if (slices > limits.gapSlices)
      return "a gap of " + Number(gap.mm) + " mm needs " + std::to_string(slices) +
             " slices, at most " + std::to_string(limits.gapSlices) + " are made in one gap";
    if (slices > 0 && gap.mm > limits.gapMm)
      return "a gap of " + Number(gap.mm) + " mm is too wide to be bridged, at most " +
             Number(limits.gapMm) + " mm are";
  }
  const int slices = SlicesInAll(measures);
  const double share = slices / static_cast<double>(measures.heights.size() + slices);
  if (share > limits.madeShare)
    return std::to_string(slices) + " slices would have to be made for " +
           std::to_string(measures.heights.size()) + " that were measured, at most " +
           Number(100.0 * limits.madeShare) + " % of all may be";
  return {};
}

std::string TiltBeyondLimits(const StackMeasures& measures, const ResampleLimits& limits)
{
  if (measures.tilted && measures.tiltDegrees > limits.tiltDegrees)
    return "a tilt of " + Number(measures.tiltDegrees) + " degrees, at most " +
           Number(limits.tiltDegrees) + " are rectified";
  return {};
}

ResamplePlan PlanResampling(const SliceStack& stack, const ResampleLimits& limits)
{
  ResamplePlan plan;
  plan.stack = stack;
  plan.measures = MeasureStack(stack);
  for (const auto check : { GapsBeyondLimits, TiltBeyondLimits })
    if (const std::string beyond = check(plan.measures, limits); !beyond.empty())
      throw std::invalid_argument("stack: " + beyond);
  if (plan.measures.tilted && !plan.measures.straight)
    throw std::invalid_argument(
      "stack: slice " + std::to_string(plan.measures.oddSlice + 1) + " lies " +
      Number(plan.measures.oddMm) +
      " mm sideways, and the slices are not on one line: that is no tilt");
  plan.record.slicesMeasured = static_cast<int>(stack.origins.size());
  plan.record.slicesFilled = SlicesInAll(plan.measures);
  glm::dvec2 first;
  PlanShifts(plan, first);
  PlanSlices(plan);
  GridGeometry& g = plan.geometry;
  g.spacing.x = stack.spacing.x;
  g.spacing.y = stack.spacing.y;
  g.direction = glm::dmat3(stack.row, stack.column, stack.Normal());
  g.origin = stack.origins.front() + first.x * stack.spacing.x * stack.row +
             first.y * stack.spacing.y * stack.column;
  g.Validate();
  return plan;
}

template <typename T>
ResampleRecord Resample(
  const ResamplePlan& plan, const T* samples, T* result, const ProgressFunction& progress)
{
  const T outside = SmallestOf(plan, samples);
  const glm::ivec3& dims = plan.geometry.dims;
  const std::size_t inSlice = std::size_t(dims.x) * dims.y;
  std::vector<std::size_t> missed(dims.z);
  constexpr int batch = 16; // progress comes from this thread only, between two batches
  for (int begin = 0; begin < dims.z; begin += batch)
  {
    ReportProgress(progress, 0.9 * begin / dims.z);
    ParallelFor(begin, std::min(begin + batch, dims.z), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t m = first; m < last; ++m)
          missed[m] = MakeSlice(plan, samples, static_cast<int>(m), outside, result + m * inSlice);
      });
  }
  ReportProgress(progress, 0.9);
  ResampleRecord record = plan.record;
  double beside = 0.0;
  for (const std::size_t count : missed)
    beside += static_cast<double>(count);
  record.outsideShare = beside / static_cast<double>(plan.geometry.Size());
  MeasureResamplingError(plan, samples, record);
  ReportProgress(progress, 1.0);
  return record;
}

template ResampleRecord Resample(
  const ResamplePlan&, const std::int16_t*, std::int16_t*, const ProgressFunction&);
template ResampleRecord Resample(
  const ResamplePlan&, const float*, float*, const ProgressFunction&);

} // namespace hasp
