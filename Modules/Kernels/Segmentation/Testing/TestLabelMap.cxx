#include "Segmentation/LabelMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using hasp::Label;

TEST(LabelMap, ThresholdsHoldTheirEndsAndNoNaN)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> samples{ 225.9F, 226.0F, 300.0F, 3071.0F, 3071.5F, nan };
  std::vector<Label> labels(samples.size(), 7);
  hasp::GridGeometry geometry;
  geometry.dims = { 3, 2, 1 };
  hasp::ThresholdLabels(hasp::GridView<const float>{ samples.data(), geometry }, 226.0, 3071.0,
    { labels.data(), geometry });
  EXPECT_EQ(labels, (std::vector<Label>{ 0, 1, 1, 1, 0, 0 }));
  EXPECT_EQ(hasp::CountLabels({ labels.data(), geometry }), (std::vector<std::size_t>{ 3, 3 }));
}

TEST(LabelMap, ThresholdsReachToTheEndsOfFloat)
{
  constexpr float most = std::numeric_limits<float>::max();
  const std::vector<float> samples{ -most, -3e38F, 0.0F, 3e38F, most };
  hasp::GridGeometry geometry;
  geometry.dims = { 5, 1, 1 };
  std::vector<Label> labels(5);
  hasp::ThresholdLabels(hasp::GridView<const float>{ samples.data(), geometry }, -3.1e38, 3.1e38,
    { labels.data(), geometry });
  EXPECT_EQ(labels, (std::vector<Label>{ 0, 1, 1, 1, 0 }));
  hasp::ThresholdLabels(hasp::GridView<const float>{ samples.data(), geometry }, 3e38F, HUGE_VAL,
    { labels.data(), geometry });
  EXPECT_EQ(labels, (std::vector<Label>{ 0, 0, 0, 1, 1 }));
}

TEST(LabelMap, NonsenseIsRefused)
{
  const std::vector<float> samples(6);
  std::vector<Label> labels(6);
  hasp::GridGeometry geometry;
  geometry.dims = { 3, 2, 1 };
  const hasp::GridView<const float> grid{ samples.data(), geometry };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
    hasp::ThresholdLabels(grid, 2.0, 1.0, { labels.data(), geometry }), std::invalid_argument);
  EXPECT_THROW(
    hasp::ThresholdLabels(grid, nan, 1.0, { labels.data(), geometry }), std::invalid_argument);
  hasp::GridGeometry other = geometry;
  other.dims = { 2, 3, 1 };
  EXPECT_THROW(
    hasp::ThresholdLabels(grid, 0.0, 1.0, { labels.data(), other }), std::invalid_argument);
  EXPECT_THROW(hasp::ThresholdLabels(
                 grid, 0.0, 1.0, { labels.data(), geometry }, [](double) { return false; }),
    hasp::Cancelled);
}

TEST(LabelMap, CountsReachTheLargestLabel)
{
  std::vector<Label> labels(3'000'000, 2); // several pieces
  labels.back() = hasp::MaxLabel;
  hasp::GridGeometry geometry;
  geometry.dims = { 3000, 1000, 1 };
  const std::vector<std::size_t> counts = hasp::CountLabels({ labels.data(), geometry });
  ASSERT_EQ(counts.size(), 65536U);
  EXPECT_EQ(counts[2], 2'999'999U);
  EXPECT_EQ(counts[65535], 1U);
}

} // namespace
