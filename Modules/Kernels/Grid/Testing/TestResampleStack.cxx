#include "Grid/AnalyticVolumes.h"
#include "Grid/GridView.h"
#include "Grid/ResampleStack.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace
{

using hasp::ResamplePlan;
using hasp::SliceStack;

std::vector<double> Heights(int count, double gap, const std::vector<int>& without = {})
{
  std::vector<double> heights;
  for (int k = 0; k < count; ++k)
    if (std::find(without.begin(), without.end(), k) == without.end())
      heights.push_back(k * gap);
  return heights;
}

/// Upright, centred on `center`, sheared along the columns by the tilt.
SliceStack Stack(const glm::dvec3& center, const glm::ivec2& dims, const glm::dvec2& spacing,
  const std::vector<double>& heights, double tiltDegrees = 0.0)
{
  SliceStack stack;
  stack.dims = dims;
  stack.spacing = spacing;
  const double middle = 0.5 * (heights.front() + heights.back());
  for (const double h : heights)
    stack.origins.push_back(center + glm::dvec3(-0.5 * (dims.x - 1) * spacing.x,
                                       -0.5 * (dims.y - 1) * spacing.y +
                                         (h - middle) * std::tan(glm::radians(tiltDegrees)),
                                       h - middle));
  return stack;
}

/// Soft steps of `edge` mm around the surface: 0 outside, 1000 inside, 500 on it.
double Grey(const hasp::AnalyticVolume& volume, const glm::dvec3& at, double edge)
{
  return 500.0 * (1.0 + std::tanh(2.0 * volume.value(at) / edge));
}

template <typename T>
std::vector<T> SampleStack(const SliceStack& stack, const hasp::AnalyticVolume& volume, double edge)
{
  std::vector<T> samples;
  for (const glm::dvec3& origin : stack.origins)
    for (int j = 0; j < stack.dims.y; ++j)
      for (int i = 0; i < stack.dims.x; ++i)
      {
        const double grey = Grey(volume,
          origin + i * stack.spacing.x * stack.row + j * stack.spacing.y * stack.column, edge);
        samples.push_back(
          std::is_integral_v<T> ? static_cast<T>(std::nearbyint(grey)) : static_cast<T>(grey));
      }
  return samples;
}

struct Resampled
{
  ResamplePlan plan;
  std::vector<float> samples;
  hasp::ResampleRecord record;
};

Resampled Resampling(const SliceStack& stack, const std::vector<float>& samples)
{
  Resampled r{ hasp::PlanResampling(stack), {}, {} };
  r.samples.resize(r.plan.geometry.Size());
  r.record = hasp::Resample(r.plan, samples.data(), r.samples.data());
  return r;
}

double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[std::size_t(share * double(values.size() - 1) + 0.5)];
}

/// How far the surfaces of the slices that were made lie from the closed form, in mm. Through each
/// sample of 150 to 850, the steep half of the soft step, goes a surface of the result; the closed
/// form says where the surface of that value is. |value| / |gradient| is the distance to first
/// order, and exact for a distance field.
std::vector<double> TrueErrors(const Resampled& r, const hasp::AnalyticVolume& volume, double edge)
{
  const hasp::GridView<const float> grid{ r.samples.data(), r.plan.geometry };
  const glm::ivec3& dims = grid.geometry.dims;
  const double outside = *std::min_element(r.samples.begin(), r.samples.end());
  std::vector<double> errors;
  const auto take = [&](int i, int j, int k)
  {
    const double grey = grid(i, j, k);
    if (grey < 150.0 || grey > 850.0 || grey == outside)
      return;
    const glm::dvec3 p = grid.geometry.IndexToWorld({ i, j, k });
    glm::dvec3 gradient;
    for (int n = 0; n < 3; ++n)
    {
      glm::dvec3 d(0.0);
      d[n] = 1e-4;
      gradient[n] = (volume.value(p + d) - volume.value(p - d)) / 2e-4;
    }
    const double there = 0.5 * edge * std::atanh(grey / 500.0 - 1.0);
    errors.push_back(std::abs(volume.value(p) - there) / std::max(glm::length(gradient), 0.1));
  };
  for (int k = 0; k < dims.z; ++k)
    if (r.plan.slices[k].share > 0.0 || r.record.slicesMade == 0)
      for (int j = 0; j < dims.y; ++j)
        for (int i = 0; i < dims.x; ++i)
          take(i, j, k);
  return errors;
}

// ---- what is refused ----

TEST(ResampleStack, TooMuchToMakeUpIsRefused)
{
  const auto refused = [](const SliceStack& stack, const std::string& word)
  {
    try
    {
      hasp::PlanResampling(stack);
      ADD_FAILURE() << "was planned: " << word;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  const glm::dvec3 c(0.0);
  refused(Stack(c, { 8, 8 }, { 1, 1 }, Heights(60, 1.0, { 10, 11, 12, 13, 14, 15 })), "6 slices");
  refused(Stack(c, { 8, 8 }, { 1, 1 }, Heights(40, 3.0, { 10, 11, 12 })), "12 mm");
  refused(Stack(c, { 8, 8 }, { 1, 1 }, Heights(12, 1.0, { 2, 5, 8 })), "20 %");
  refused(Stack(c, { 8, 8 }, { 1, 1 }, { 0, 1, 2, 3, 1e9 }), "at most 5");
  refused(Stack(c, { 8, 8 }, { 1, 1 }, Heights(8, 1.0), 50.0), "50 degrees");
  auto aside = Stack(c, { 8, 8 }, { 1, 1 }, Heights(8, 1.0));
  aside.origins[3].x += 3.0;
  refused(aside, "no tilt");
}

TEST(ResampleStack, CancelEndsIt)
{
  const auto stack = Stack(glm::dvec3(0), { 8, 8 }, { 1, 1 }, Heights(9, 1.0, { 4 }));
  const auto plan = hasp::PlanResampling(stack);
  const std::vector<float> samples(8 * 64, 1.0F);
  std::vector<float> result(plan.geometry.Size());
  EXPECT_THROW(hasp::Resample(plan, samples.data(), result.data(), [](double) { return false; }),
    hasp::Cancelled);
}

// ---- what must be exact ----

TEST(ResampleStack, RegularStackIsTheSameBytesAndWithoutError)
{
  const auto stack = Stack({ 3, 4, 5 }, { 9, 7 }, { 0.5, 0.75 }, Heights(6, 1.25));
  std::vector<std::int16_t> samples(9 * 7 * 6);
  std::iota(samples.begin(), samples.end(), std::int16_t(-200));
  const auto plan = hasp::PlanResampling(stack);
  EXPECT_EQ(plan.geometry.dims, glm::ivec3(9, 7, 6));
  EXPECT_EQ(plan.geometry.origin, stack.origins.front());
  EXPECT_DOUBLE_EQ(plan.geometry.spacing.z, 1.25);
  std::vector<std::int16_t> result(samples.size());
  const auto record = hasp::Resample(plan, samples.data(), result.data());
  EXPECT_EQ(result, samples);
  EXPECT_EQ(record.slicesMade, 0);
  EXPECT_EQ(record.slicesCopied, 6);
  EXPECT_TRUE(record.errorKnown);
  EXPECT_EQ(record.error95, 0.0);
  EXPECT_EQ(record.outsideShare, 0.0);
}

TEST(ResampleStack, LinearFieldIsExactWhateverIsWrongWithTheStack)
{
  // Linear interpolation gives a linear field back: every sample of the result is its value there.
  const glm::dvec3 slope(3.0, -2.0, 5.0);
  const auto field = [&](const glm::dvec3& p) { return 100.0 + glm::dot(slope, p); };
  std::vector<double> uneven{ 0, 1, 2, 3.3, 4.1, 5, 6, 7.45, 8, 9 };
  for (const auto& [heights, tilt] :
    { std::pair{ Heights(12, 1.0, { 4, 5 }), 0.0 }, std::pair{ uneven, 0.0 },
      std::pair{ Heights(12, 1.0), 17.0 }, std::pair{ Heights(12, 1.0, { 7 }), -25.0 },
      std::pair{ uneven, 30.0 }, std::pair{ Heights(2, 3.0), 30.0 } })
  {
    SCOPED_TRACE(tilt);
    auto stack = Stack({ 0, 0, 0 }, { 14, 16 }, { 0.6, 0.9 }, heights, tilt);
    // A sagittal frame, turned a little: nothing may lean on the world's axes.
    const glm::dvec3 row = glm::normalize(glm::dvec3(0.05, 1.0, 0.1));
    const glm::dvec3 column =
      glm::normalize(glm::cross(row, glm::cross(glm::dvec3(0, 0, -1), row)));
    const glm::dmat3 turn(row, column, glm::cross(row, column));
    stack.row = row;
    stack.column = column;
    for (auto& origin : stack.origins)
      origin = turn * origin;
    std::vector<float> samples;
    for (const auto& origin : stack.origins)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 14; ++i)
          samples.push_back(float(field(origin + i * 0.6 * row + j * 0.9 * column)));
    const float outside = *std::min_element(samples.begin(), samples.end());
    const auto r = Resampling(stack, samples);
    EXPECT_NEAR(glm::determinant(r.plan.geometry.direction), 1.0, 1e-12);
    std::size_t inside = 0;
    for (int k = 0; k < r.plan.geometry.dims.z; ++k)
    {
      // A copied slice may lie up to 0.02 mm from its place.
      const double allowed = 1e-4 + r.record.forgivenMm * glm::length(slope);
      for (int j = 0; j < r.plan.geometry.dims.y; ++j)
        for (int i = 0; i < r.plan.geometry.dims.x; ++i)
        {
          const float value =
            hasp::GridView<const float>{ r.samples.data(), r.plan.geometry }(i, j, k);
          if (value == outside)
            continue;
          ++inside;
          ASSERT_NEAR(value, field(r.plan.geometry.IndexToWorld({ i, j, k })), allowed)
            << i << " " << j << " " << k;
        }
    }
    const double share = 1.0 - double(inside) / double(r.samples.size());
    EXPECT_NEAR(share, r.record.outsideShare, 2e-3); // one true sample is the smallest, too
    EXPECT_GT(double(inside), 0.8 * 14 * 16 * double(heights.size()));
  }
}

TEST(ResampleStack, MeasuredSlicesStayAsTheyAre)
{
  // 45 degrees less a little would not do: the tilt is such that slices move by whole samples.
  const double tilt = glm::degrees(std::atan2(1.5, 2.0));
  const auto stack = Stack({ 0, 0, 0 }, { 5, 6 }, { 0.5, 0.75 }, Heights(7, 2.0, { 3 }), tilt);
  std::vector<std::int16_t> samples(6 * 30);
  std::iota(samples.begin(), samples.end(), std::int16_t(1));
  const auto plan = hasp::PlanResampling(stack);
  EXPECT_EQ(plan.geometry.dims, glm::ivec3(5, 18, 7)); // 6 steps of 2 rows
  std::vector<std::int16_t> result(plan.geometry.Size());
  const auto record = hasp::Resample(plan, samples.data(), result.data());
  EXPECT_EQ(record.slicesMade, 1);
  EXPECT_EQ(record.slicesFilled, 1);
  EXPECT_DOUBLE_EQ(record.farthestMm, 2.0);
  EXPECT_NEAR(record.tiltDegrees, 36.87, 0.01);
  const hasp::GridView<const std::int16_t> grid{ result.data(), plan.geometry };
  for (int k = 0, from = 0; k < 7; ++k)
    if (k != 3)
    {
      for (int j = 0; j < 18; ++j)
        for (int i = 0; i < 5; ++i)
        {
          const int own = j - 2 * k;
          ASSERT_EQ(grid(i, j, k), own >= 0 && own < 6 ? samples[(from * 6 + own) * 5 + i] : 1);
        }
      ++from;
    }
}

TEST(ResampleStack, IntegersAreRoundedAndNothingLeavesTheMeasuredRange)
{
  const auto stack = Stack({ 0, 0, 0 }, { 6, 6 }, { 1, 1 }, { 0, 1, 2, 4, 5, 6.4 }, 20.0);
  std::vector<std::int16_t> samples;
  for (int n = 0; n < 6 * 36; ++n)
    samples.push_back(n % 2 ? 32767 : -32768);
  const auto plan = hasp::PlanResampling(stack);
  std::vector<std::int16_t> result(plan.geometry.Size());
  hasp::Resample(plan, samples.data(), result.data());
  std::vector<float> exactIn(samples.begin(), samples.end()), exact(result.size());
  hasp::Resample(plan, exactIn.data(), exact.data());
  for (std::size_t n = 0; n < result.size(); ++n)
  {
    ASSERT_GE(exact[n], -32768.0F);
    ASSERT_LE(exact[n], 32767.0F);
    ASSERT_NEAR(result[n], exact[n], 0.51); // a half, and float's last digit at 32768
  }
}

TEST(ResampleStack, MadeSamplesLieBetweenTheTwoAroundThem)
{
  // Metal beside air, and noise: a cubic that is not held back makes halos of 30 % there.
  const std::vector<double> heights{ 0, 1, 2, 4, 5, 6.4, 7, 8, 9, 10, 11 };
  const auto stack = Stack({ 0, 0, 0 }, { 6, 6 }, { 1, 1 }, heights);
  std::vector<float> samples;
  unsigned seed = 1;
  for (std::size_t n = 0; n < heights.size() * 36; ++n)
    samples.push_back((seed = seed * 1664525U + 1013904223U) >> 31 ? 3000.0F : float(seed >> 24));
  const auto r = Resampling(stack, samples);
  int made = 0;
  for (int k = 0; k < r.plan.geometry.dims.z; ++k)
    for (int n = 0; n < 36; ++n)
    {
      const auto& recipe = r.plan.slices[k];
      const auto [low, high] =
        std::minmax(samples[recipe.below * 36 + n], samples[recipe.above * 36 + n]);
      made += recipe.share > 0.0;
      ASSERT_GE(r.samples[k * 36 + n], low - 1e-3F); // float's last digit at 3000
      ASSERT_LE(r.samples[k * 36 + n], high + 1e-3F);
    }
  EXPECT_GE(made, 2 * 36);
}

TEST(ResampleStack, WhatCannotBeMeasuredIsNotCalledZero)
{
  // Two slices: none can be left out.
  const auto sphere = hasp::AnalyticSphere({ 0, 0, 0 }, 5.0);
  const auto three = Stack({ 0, 0, 0 }, { 20, 20 }, { 1, 1 }, { 0, 1, 2, 3.4 });
  EXPECT_TRUE(Resampling(three, SampleStack<float>(three, sphere, 1.0)).record.errorKnown);
  // A volume without any edge has nothing to be measured by.
  const auto record = Resampling(three, std::vector<float>(4 * 400, 7.0F)).record;
  EXPECT_GT(record.slicesMade, 0);
  EXPECT_FALSE(record.errorKnown);
}

// ---- the recorded error against the truth ----

/// 7 mm thick, as a skull.
hasp::AnalyticVolume Shell()
{
  return { "shell", [](const glm::dvec3& p) { return 3.5 - std::abs(glm::length(p) - 40.0); },
    1.0 };
}

struct Case
{
  const char* name;
  hasp::AnalyticVolume volume;
  glm::dvec3 center;
};

/// The same with straight lines between the slices, for stacks that are not tilted.
Resampled Straight(Resampled r, const std::vector<float>& measured)
{
  const std::size_t inSlice = std::size_t(r.plan.stack.dims.x) * r.plan.stack.dims.y;
  for (std::size_t n = 0; n < r.samples.size(); ++n)
  {
    const auto& recipe = r.plan.slices[n / inSlice];
    const std::size_t at = n % inSlice;
    r.samples[n] = float((1.0 - recipe.share) * measured[recipe.below * inSlice + at] +
                         recipe.share * measured[recipe.above * inSlice + at]);
  }
  return r;
}

// What is recorded is measured at other slices than the made ones, so it is not equal to what is
// true there. Less by a quarter is allowed for that. More by far is met where the surfaces stand
// upright in the gap and lie flat elsewhere: at the equator of the sphere and of the shell, by a
// factor of seven, and where the truth is below a hundredth of a millimetre by more. So a
// sixteenth of a sample (0.05 mm), which nobody sees, is allowed besides.
TEST(ResampleStack, RecordedErrorHoldsAgainstTheClosedForm)
{
  const std::vector<Case> cases{ { "sphere", hasp::AnalyticSphere({ 0, 0, 0 }, 22.0), { 0, 0, 0 } },
    { "torus", hasp::AnalyticTorus({ 0, 0, 0 }, glm::normalize(glm::dvec3(1, 2, 3)), 16.0, 5.0),
      { 0, 0, 0 } },
    { "gyroid", hasp::AnalyticGyroid(24.0), { 1, 2, 3 } }, { "shell", Shell(), { 20, -22, 12 } } };
  std::printf("%-8s %5s %4s %5s  %19s  %17s  %11s\n", "volume", "tilt", "gap", "after",
    "recorded p50 p95 mm", "true p50 p95 mm", "linear's p95");
  for (const Case& c : cases)
    for (const auto& [tilt, gap, after] : { std::tuple{ 5.0, 0, 0 }, { 10.0, 0, 0 }, { 15.0, 0, 0 },
           { 25.0, 0, 0 }, { 0.0, 1, 22 }, { 0.0, 2, 22 }, { 0.0, 3, 22 }, { 0.0, 4, 12 },
           { 0.0, 5, 10 }, { 0.0, 5, 22 }, { 15.0, 3, 22 } })
    {
      std::vector<int> without;
      for (int n = 0; n < gap; ++n)
        without.push_back(after + n);
      const auto stack = Stack(c.center, { 64, 64 }, { 0.8, 0.8 }, Heights(48, 1.0, without), tilt);
      const double edge = 1.5;
      const auto measured = SampleStack<float>(stack, c.volume, edge);
      const auto r = Resampling(stack, measured);
      const auto errors = TrueErrors(r, c.volume, edge);
      ASSERT_GT(errors.size(), 50U);
      const double true50 = Quantile(errors, 0.5), true95 = Quantile(errors, 0.95);
      const double straight =
        tilt == 0.0 ? Quantile(TrueErrors(Straight(r, measured), c.volume, edge), 0.95) : NAN;
      std::printf("%-8s %5.0f %4d %5d  %9.3f %9.3f  %8.3f %8.3f  %8.3f\n", c.name, tilt, gap, after,
        r.record.error50, r.record.error95, true50, true95, straight);
      if (tilt == 0.0) // what the cubic is for; least with the gyroid, whose surfaces bend most
      {
        EXPECT_LE(true95, 0.8 * straight);
      }
      EXPECT_TRUE(r.record.errorKnown);
      EXPECT_GT(r.record.edgesJudged, 100);
      EXPECT_GE(r.record.error95, 0.75 * true95);
      EXPECT_LE(r.record.error95, 7.0 * true95 + 0.05);
    }
}

} // namespace
