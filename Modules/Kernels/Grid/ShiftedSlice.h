#pragma once
#include "Grid/ResampleStack.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hasp
{

/// A measured slice as the result of a resampling sees it: moved by its shift, bilinear where that
/// is no whole number of samples. Internal to the resampling of stacks. Any thread.
template <typename T>
class ShiftedSlice
{
public:
  ShiftedSlice(const ResamplePlan& plan, const T* samples, int slice)
    : width(plan.stack.dims.x),
      height(plan.stack.dims.y),
      data(samples + static_cast<std::size_t>(slice) * width * height),
      shift(plan.shifts[slice]),
      base(glm::floor(-shift)),
      part(-shift - glm::dvec2(base))
  {
  }

  /// Columns [FirstX, LastX] and rows [FirstY, LastY] of the result have samples of this slice.
  int FirstX() const { return -base.x; }
  int LastX() const { return width - 1 - base.x - (part.x > 0.0 ? 1 : 0); }
  int FirstY() const { return -base.y; }
  int LastY() const { return height - 1 - base.y - (part.y > 0.0 ? 1 : 0); }

  /// At a covered column and row of the result. A slice moved by whole samples gives them exactly.
  double At(int i, int j) const
  {
    const T* p =
      this->data + static_cast<std::size_t>(j + this->base.y) * this->width + (i + this->base.x);
    const auto along = [&](const T* row)
    { return this->part.x > 0.0 ? (1.0 - this->part.x) * row[0] + this->part.x * row[1] : row[0]; };
    const double here = along(p);
    return this->part.y > 0.0 ? (1.0 - this->part.y) * here + this->part.y * along(p + this->width)
                              : here;
  }

  /// At any place of the result, in samples; false if the slice does not reach it.
  bool Sample(const glm::dvec2& at, double& value) const
  {
    const glm::dvec2 own = at - this->shift;
    if (!(own.x >= 0.0 && own.y >= 0.0 && own.x <= this->width - 1 && own.y <= this->height - 1))
      return false;
    const int i = std::min(static_cast<int>(own.x), std::max(this->width - 2, 0));
    const int j = std::min(static_cast<int>(own.y), std::max(this->height - 2, 0));
    const double x = own.x - i, y = own.y - j;
    const int right = this->width > 1 ? 1 : 0, down = this->height > 1 ? this->width : 0;
    const T* p = this->data + static_cast<std::size_t>(j) * this->width + i;
    value = (1.0 - y) * ((1.0 - x) * p[0] + x * p[right]) +
            y * ((1.0 - x) * p[down] + x * p[down + right]);
    return true;
  }

  /// How far between samples the slice's own lie in the result, each in [0,1).
  const glm::dvec2& Part() const { return this->part; }

private:
  int width, height;
  const T* data;
  glm::dvec2 shift;
  glm::ivec2 base;
  glm::dvec2 part;
};

/// The value at a place of the result between two slices, `share` of the way from `below` to
/// `above`: cubic through the slices on either side of them, too, held to what the two say.
///
/// The slope at a slice is that of the parabola through it and its neighbours (Catmull-Rom where
/// all distances are equal), of the straight line where the outer one is absent or does not reach
/// the place. Slopes against the line become 0 and others three times its at most (Fritsch &
/// Carlson 1980): then nothing between leaves the range of the two, so metal gets no halo.
/// Internal to the resampling of stacks. Any thread.
template <typename T>
class BetweenSlices
{
public:
  /// Indices of measured slices, below < above.
  BetweenSlices(const ResamplePlan& plan, const T* samples, int below, int above)
    : whole(plan.measures.heights[above] - plan.measures.heights[below])
  {
    const std::vector<double>& heights = plan.measures.heights;
    if (below > 0)
    {
      this->lower.emplace(plan, samples, below - 1);
      this->down = heights[below] - heights[below - 1];
    }
    if (above + 1 < static_cast<int>(heights.size()))
    {
      this->upper.emplace(plan, samples, above + 1);
      this->up = heights[above + 1] - heights[above];
    }
  }

  /// `from` and `to` are what the two slices say there.
  double At(const glm::dvec2& at, double share, double from, double to) const
  {
    const double line = (to - from) / this->whole;
    double outer = 0.0, start = line, end = line;
    if (this->lower && this->lower->Sample(at, outer))
      start = this->Slope((from - outer) / this->down, this->down, line);
    if (this->upper && this->upper->Sample(at, outer))
      end = this->Slope((outer - to) / this->up, this->up, line);
    const double back = 1.0 - share;
    return from + (to - from) * share * share * (3.0 - 2.0 * share) +
           this->whole * share * back * (back * start - share * end);
  }

private:
  double Slope(double beside, double width, double line) const
  {
    const double slope = (beside * this->whole + line * width) / (this->whole + width);
    return slope * line <= 0.0
             ? 0.0
             : std::copysign(std::min(std::abs(slope), 3.0 * std::abs(line)), line);
  }

  std::optional<ShiftedSlice<T>> lower, upper;
  double whole, down = 0.0, up = 0.0; ///< mm between the slices
};

} // namespace hasp
