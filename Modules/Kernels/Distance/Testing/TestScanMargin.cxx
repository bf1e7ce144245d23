#include "Distance/ScanMargin.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

const hasp::GridGeometry Scan{ { 2, 3, 2 }, { 1, 2, 3 }, { 1.0, 0.5, 2.0 }, glm::dmat3(1) };

TEST(ScanMargin, TheGridIsLargerByWhatWasAskedForAndAVoxel)
{
  const hasp::GridGeometry grid = hasp::GeometryWithMargin(Scan, 1.2);
  EXPECT_EQ(grid.dims, glm::ivec3(2 + 2 * 3, 3 + 2 * 4, 2 + 2 * 2));
  EXPECT_EQ(grid.origin, glm::dvec3(1 - 3, 2 - 2, 3 - 4));
  EXPECT_EQ(grid.spacing, Scan.spacing);
  EXPECT_EQ(hasp::GeometryWithMargin(Scan, 0.0).dims, Scan.dims);
  for (const double bad : { -0.1, std::nan(""), double(INFINITY), 700.0 }) // 1404 x 2805 x 706
    EXPECT_THROW(hasp::GeometryWithMargin(Scan, bad), std::invalid_argument) << bad;
}

TEST(ScanMargin, CoverageBeyondIsNone)
{
  const std::vector<float> shares(12, 1.0F);
  const auto made = hasp::CoverageWithMargin(Scan, shares, 0.3); // 2 voxels, 2, 2
  const hasp::GridGeometry grid = hasp::GeometryWithMargin(Scan, 0.3);
  ASSERT_EQ(made.size(), grid.Size());
  double sum = 0.0;
  for (const float share : made)
    sum += share;
  EXPECT_EQ(sum, 12.0);
  const hasp::GridView<const float> view{ made.data(), grid };
  EXPECT_EQ(view(2, 2, 2), 1.0F);
  EXPECT_EQ(view(3, 4, 3), 1.0F);
  EXPECT_EQ(view(4, 4, 3), 0.0F);
  EXPECT_EQ(view(1, 2, 2), 0.0F);
  EXPECT_THROW(
    hasp::CoverageWithMargin(Scan, std::vector<float>(5, 1.0F), 0.3), std::invalid_argument);
}

TEST(ScanMargin, GreyValuesCrossTheIsovalueHalfWayBeyond)
{
  // Inside by 40, outside by 30, and just the isovalue: no wall may stand on that.
  std::vector<std::int16_t> samples(12, 140);
  samples[1] = 70;
  samples[3] = 100;
  const auto made =
    hasp::GreyWithMargin(hasp::GridView<const std::int16_t>{ samples.data(), Scan }, 100.0, 0.3);
  const hasp::GridView<const float> view{ made.data(), hasp::GeometryWithMargin(Scan, 0.3) };
  EXPECT_EQ(view(2, 2, 2), 40.0F);
  EXPECT_EQ(view(1, 2, 2), -40.0F);
  EXPECT_EQ(view(0, 2, 2), -120.0F);
  EXPECT_EQ(view(3, 2, 2), -30.0F);
  EXPECT_EQ(view(4, 2, 2), -30.0F);
  EXPECT_EQ(view(3, 3, 2), 0.0F);
  EXPECT_LT(view(4, 3, 2), 0.0F);
  EXPECT_LT(view(5, 3, 2), view(4, 3, 2));
}

} // namespace
