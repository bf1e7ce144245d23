#include "Grid/SliceStack.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double OfASample = 0.1; ///< how far aside a slice may lie and still be straight

bool Finite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void Check(const SliceStack& stack)
{
  const auto fail = [](const std::string& what) { throw std::invalid_argument("stack: " + what); };
  if (stack.origins.size() < 2)
    fail(std::to_string(stack.origins.size()) + " slices, must be at least 2");
  if (stack.dims.x < 1 || stack.dims.y < 1)
    fail("slices of " + std::to_string(stack.dims.x) + " x " + std::to_string(stack.dims.y) +
         " samples, each must be >= 1");
  for (const double spacing : { stack.spacing.x, stack.spacing.y })
    if (!(std::isfinite(spacing) && spacing > 0.0))
      fail("spacing is " + std::to_string(spacing) + " mm, must be > 0");
  const double worst = std::max({ std::abs(glm::length(stack.row) - 1.0),
    std::abs(glm::length(stack.column) - 1.0), std::abs(glm::dot(stack.row, stack.column)) });
  if (!(worst <= 1e-6))
    fail("row and column are off unit vectors at right angles by " + std::to_string(worst) +
         ", must be <= 1e-6");
  if (!std::all_of(stack.origins.begin(), stack.origins.end(), Finite))
    fail("a position is no finite number");
}

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void MeasureGaps(StackMeasures& m)
{
  std::vector<double> gaps;
  for (std::size_t n = 1; n < m.heights.size(); ++n)
    gaps.push_back(m.heights[n] - m.heights[n - 1]);
  m.usualGapMm = Median(gaps);
  const double mean = m.heights.back() / static_cast<double>(gaps.size());
  for (std::size_t n = 0; n < gaps.size(); ++n)
  {
    m.gapDeviationMm = std::max(m.gapDeviationMm, std::abs(gaps[n] - mean));
    if (std::abs(gaps[n] - m.usualGapMm) <= ForgivenGapMm(m.usualGapMm))
      continue;
    const double ratio = gaps[n] / m.usualGapMm;
    const bool multiple = ratio > 1.5 && std::abs(ratio - std::round(ratio)) < 0.05;
    // More than a million of usual gaps is no number of slices; it is refused as an uneven gap.
    const int missing = multiple && ratio < 1e6 ? static_cast<int>(std::lround(ratio)) - 1 : 0;
    m.gaps.push_back({ static_cast<int>(n), gaps[n], missing });
  }
}

/// Finds the line most slices are near, and the slice farthest from it. Medians, so that a slice
/// out of line does not bend the line towards itself, be it the first or the last.
void MeasureCrooked(StackMeasures& m)
{
  glm::dvec2 slope, start;
  for (int a = 0; a < 2; ++a)
  {
    std::vector<double> values;
    for (std::size_t n = 1; n < m.heights.size(); ++n)
      values.push_back((m.aside[n][a] - m.aside[n - 1][a]) / (m.heights[n] - m.heights[n - 1]));
    slope[a] = Median(values);
    values.clear();
    for (std::size_t n = 0; n < m.heights.size(); ++n)
      values.push_back(m.aside[n][a] - slope[a] * m.heights[n]);
    start[a] = Median(values);
  }
  for (std::size_t n = 0; n < m.heights.size(); ++n)
    if (const double off = glm::length(m.aside[n] - start - slope * m.heights[n]); off > m.oddMm)
    {
      m.oddMm = off;
      m.oddSlice = static_cast<int>(n);
    }
  m.tiltDegrees = glm::degrees(std::atan(glm::length(slope)));
}

void MeasureTilt(const SliceStack& stack, StackMeasures& m)
{
  const double allowed = OfASample * std::min(stack.spacing.x, stack.spacing.y);
  const double top = m.heights.back();
  for (std::size_t n = 1; n < m.heights.size(); ++n)
  {
    const double aside = glm::length(m.aside[n]);
    if (aside > m.farthestAsideMm)
    {
      m.farthestAsideMm = aside;
      m.farthestSlice = static_cast<int>(n);
    }
    // Written positions have few decimals: 0.02 mm are forgiven, as along the stack.
    if (glm::length(m.aside[n] - m.aside.back() * (m.heights[n] / top)) > std::max(allowed, 0.02))
      m.straight = false;
  }
  m.tilted = m.farthestAsideMm > allowed;
  m.tiltDegrees = glm::degrees(std::atan2(glm::length(m.aside.back()), top));
  if (!m.straight)
    MeasureCrooked(m);
  m.leaning = std::tan(glm::radians(m.tiltDegrees)) * top > allowed;
}

} // namespace

glm::dvec3 SliceStack::Normal() const
{
  return glm::cross(this->row, this->column);
}

double ForgivenGapMm(double usualGapMm)
{
  return std::max(0.02, 0.01 * usualGapMm);
}

StackMeasures MeasureStack(const SliceStack& stack)
{
  Check(stack);
  StackMeasures m;
  const glm::dvec3 normal = stack.Normal();
  for (const glm::dvec3& origin : stack.origins)
  {
    const glm::dvec3 way = origin - stack.origins.front();
    const double height = glm::dot(way, normal);
    if (!m.heights.empty() && !(height > m.heights.back()))
      throw std::invalid_argument("stack: slice " + std::to_string(m.heights.size() + 1) +
                                  " is not above the one before it; sort the slices first");
    m.heights.push_back(height);
    m.aside.emplace_back(glm::dot(way, stack.row), glm::dot(way, stack.column));
  }
  MeasureGaps(m);
  MeasureTilt(stack, m);
  return m;
}

} // namespace hasp
