// A fragment's crop measures what the whole scan would.
#include "FragmentCrop.h"

#include "BrokenBall.h"
#include "Distance/Coverage.h"
#include "Distance/KeptGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using hasp::testing::LabelledScan;

// Lengths in powers of two: no rounding between the two ways, so the same bits.
TEST(FragmentCrop, CoverageIsThatOfTheWholeScan)
{
  const hasp::GridGeometry grid = hasp::testing::GridAt({ 25, 25, 25 }, { 0.5, 1.0, 0.25 },
    glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1), glm::dvec3(4.0, -8.0, 2.0));
  const LabelledScan scan = hasp::testing::Cuboids(3, grid, 2.75); // some reach the border
  const hasp::LabelBlocks blocks(scan.LabelView());
  ASSERT_EQ(blocks.Extents().size(), 27U);
  for (const auto& [label, extent] : blocks.Extents())
  {
    const hasp::FragmentCrop crop = hasp::CropLabel(scan.LabelView(), label, extent);
    EXPECT_EQ(std::size_t(std::count(crop.keep.begin(), crop.keep.end(), 1)), extent.voxels);
    EXPECT_LT(crop.keep.size(), scan.Labels.size() / 4);
    const hasp::GridGeometry target = hasp::KeptGrid(grid, extent.low, extent.high, 0.25);
    const auto keep = hasp::KeepLabel(hasp::AnyGridView(scan.LabelView()), label);
    const auto whole =
      hasp::Coverage(scan.Grey(), target, { .isovalue = LabelledScan::Isovalue, .keep = keep });
    std::vector<std::int16_t> samples;
    for (int k = 0; k < crop.geometry.dims.z; ++k)
      for (int j = 0; j < crop.geometry.dims.y; ++j)
        for (int i = 0; i < crop.geometry.dims.x; ++i)
        {
          const glm::ivec3 at = crop.first + glm::ivec3(i, j, k);
          samples.push_back(
            scan.Samples[(std::size_t(at.z) * grid.dims.y + at.y) * grid.dims.x + at.x]);
        }
    const auto cropped =
      hasp::Coverage(hasp::GridView<const std::int16_t>{ samples.data(), crop.geometry }, target,
        { .isovalue = LabelledScan::Isovalue, .keep = crop.keep });
    EXPECT_EQ(cropped, whole) << label;
    const auto [low, high] = hasp::KeptRange(crop.geometry.dims, crop.keep);
    const hasp::GridGeometry own = hasp::KeptGrid(crop.geometry, low, high, 0.25);
    EXPECT_EQ(own.dims, target.dims);
    EXPECT_EQ(own.origin, target.origin);
  }
}

TEST(KeptGrid, WhatGivesNoGridIsRefused)
{
  const hasp::GridGeometry scan =
    hasp::testing::GridAt(glm::ivec3(9), glm::dvec3(0.5), glm::dmat3(1.0), glm::dvec3(0.0));
  for (const double spacing : { 0.0, -1.0, 1e-12, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
    EXPECT_THROW(hasp::KeptGrid(scan, glm::ivec3(1), glm::ivec3(5), spacing), std::invalid_argument)
      << spacing;
  const hasp::GridGeometry grid = hasp::KeptGrid(scan, glm::ivec3(1), glm::ivec3(5), 0.25);
  EXPECT_EQ(grid.dims, glm::ivec3(8 + 2 * (2 + 4) + 1)); // 2 mm, and 0.5 + 4 * 0.25 mm on each side
  EXPECT_EQ(grid.IndexToWorld(glm::dvec3(6.0)), scan.IndexToWorld(glm::dvec3(1.0)));
}

// What is asked for decides of the work, never of the result.
TEST(FragmentCrop, OnlyWhatIsWantedIsMade)
{
  const hasp::testing::BrokenBall ball({ 24, 23, 22 }, glm::dvec3(0.5), glm::dmat3(1.0), 0, 4.0);
  const hasp::LabelBlocks blocks(ball.scan.LabelView());
  const hasp::FragmentCrop crop = hasp::CropLabel(ball.scan.LabelView(), 2, blocks.Extents().at(2));
  hasp::FragmentSettings settings;
  settings.spacingMm = 0.5;
  settings.rangeMm = 8.0;
  const auto bake = [&](const hasp::FragmentWants& wants)
  {
    return hasp::BakeFragment(
      ball.scan.Grey(), LabelledScan::Isovalue, crop, settings, wants, glm::dvec3(0.0), {});
  };
  const hasp::BakedFragment shell = bake({ .shell = true });
  EXPECT_TRUE(shell.model.shell && !shell.model.map && !shell.model.surface);
  EXPECT_EQ(shell.milliseconds[hasp::MapKind], 0.0);
  EXPECT_EQ(shell.milliseconds[hasp::SurfaceKind], 0.0);
  EXPECT_GT(shell.milliseconds[hasp::ShellKind], 0.0);
  const hasp::BakedFragment map = bake({ .map = true });
  EXPECT_TRUE(map.model.map && !map.model.shell && !map.model.surface);
  EXPECT_GT(map.samples, 2 * shell.samples) << "the range around it";
  const hasp::BakedFragment both = bake({ .shell = true, .surface = true });
  EXPECT_EQ(both.samples, shell.samples) << "shared";
}

} // namespace
