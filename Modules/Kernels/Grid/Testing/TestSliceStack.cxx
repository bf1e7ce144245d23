#include "Grid/SliceStack.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <limits>

namespace
{

/// Slices at these heights, tilted by so many degrees along their columns; an oblique frame.
hasp::SliceStack Stack(const std::vector<double>& heights, double tiltDegrees = 0.0)
{
  hasp::SliceStack stack;
  stack.dims = { 12, 10 };
  stack.spacing = { 0.5, 0.75 };
  stack.row = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  stack.column = glm::normalize(glm::cross(glm::dvec3(0.1, 0.4, 1.0), stack.row));
  for (const double h : heights)
    stack.origins.push_back(glm::dvec3(-31.5, 12.25, 100.5) + h * stack.Normal() +
                            h * std::tan(glm::radians(tiltDegrees)) * stack.column);
  return stack;
}

TEST(SliceStack, RegularStackHasNoGapsAndNoTilt)
{
  const auto m = hasp::MeasureStack(Stack({ 0, 1.25, 2.5, 3.75, 5 }));
  EXPECT_TRUE(m.gaps.empty());
  EXPECT_FALSE(m.tilted);
  EXPECT_NEAR(m.usualGapMm, 1.25, 1e-12); // positions of 100 mm have 14 digits behind the point
  EXPECT_NEAR(m.gapDeviationMm, 0.0, 1e-12);
}

TEST(SliceStack, GapsAreMissingSlicesOrUneven)
{
  const auto m = hasp::MeasureStack(Stack({ 0, 1, 2, 5, 6, 7.4, 8.4 }));
  ASSERT_EQ(m.gaps.size(), 2U);
  EXPECT_EQ(m.gaps[0].below, 2);
  EXPECT_NEAR(m.gaps[0].mm, 3.0, 1e-12);
  EXPECT_EQ(m.gaps[0].missing, 2);
  EXPECT_EQ(m.gaps[1].below, 4);
  EXPECT_NEAR(m.gaps[1].mm, 1.4, 1e-12);
  EXPECT_EQ(m.gaps[1].missing, 0);
}

TEST(SliceStack, OfTwoMediansTheLowerIsUsual)
{
  // 1 and 2 mm: one slice is missing, rather than one too many.
  const auto m = hasp::MeasureStack(Stack({ 0, 1, 3 }));
  EXPECT_NEAR(m.usualGapMm, 1.0, 1e-12);
  ASSERT_EQ(m.gaps.size(), 1U);
  EXPECT_EQ(m.gaps[0].missing, 1);
}

TEST(SliceStack, RoundedPositionsAreForgiven)
{
  EXPECT_TRUE(hasp::MeasureStack(Stack({ 0, 0.3, 0.61, 0.9, 1.19 })).gaps.empty());
  EXPECT_FALSE(hasp::MeasureStack(Stack({ 0, 0.3, 0.63, 0.9, 1.2 })).gaps.empty());
}

TEST(SliceStack, TiltIsMeasuredFromTheStackAlone)
{
  for (const double degrees : { 1.0, 12.5, -20.0, 30.0 })
  {
    const auto m = hasp::MeasureStack(Stack({ 0, 1, 2, 4, 5.5 }, degrees));
    EXPECT_TRUE(m.tilted);
    EXPECT_TRUE(m.straight);
    EXPECT_NEAR(m.tiltDegrees, std::abs(degrees), 1e-9);
    EXPECT_EQ(m.farthestSlice, 4);
  }
}

TEST(SliceStack, OneSliceAsideIsNoTilt)
{
  auto stack = Stack({ 0, 1, 2, 3, 4 });
  stack.origins[2] += 2.0 * stack.row;
  const auto m = hasp::MeasureStack(stack);
  EXPECT_TRUE(m.tilted);
  EXPECT_FALSE(m.straight);
  EXPECT_EQ(m.farthestSlice, 2);
  EXPECT_NEAR(m.farthestAsideMm, 2.0, 1e-12);
}

TEST(SliceStack, WhatIsNoStackIsRefused)
{
  const auto refused = [](const auto& change)
  {
    auto stack = Stack({ 0, 1, 2 });
    change(stack);
    EXPECT_THROW(hasp::MeasureStack(stack), std::invalid_argument);
  };
  refused([](auto& s) { s.origins.resize(1); });
  refused([](auto& s) { s.dims.x = 0; });
  refused([](auto& s) { s.spacing.y = 0.0; });
  refused([](auto& s) { s.row *= 1.01; });
  refused([](auto& s) { std::swap(s.origins[0], s.origins[1]); });
  refused([](auto& s) { s.origins[1] = s.origins[0]; });
  refused([](auto& s) { s.origins[1].x = std::numeric_limits<double>::quiet_NaN(); });
}

} // namespace
