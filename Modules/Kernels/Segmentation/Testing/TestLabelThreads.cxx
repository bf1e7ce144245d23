#include "Grid/Testing/WithThreads.h"
#include "Segmentation/Components.h"
#include "Segmentation/GreyHistogram.h"
#include "Segmentation/LabelEdits.h"
#include "Segmentation/LabelMorphology.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

namespace
{

using hasp::testing::LabelMap;

/// All edits, one after the other, and a hash after each.
std::vector<std::uint64_t> HashesOfEdits(LabelMap map)
{
  std::vector<std::uint64_t> hashes;
  const auto did = [&](const hasp::LabelDelta& delta)
  {
    hashes.push_back(map.Hash());
    hashes.push_back(delta.runs.size());
    hashes.push_back(delta.Voxels());
  };
  did(hasp::PaintVoxels(map.View(),
    hasp::RasterizeStroke(map.geometry,
      std::vector<glm::dvec3>{
        map.geometry.IndexToWorld({ 3, 4, 5 }), map.geometry.IndexToWorld({ 70, 50, 60 }) },
      2.5),
    1));
  did(hasp::MergeLabels(map.View(), 3, 1));
  did(hasp::CloseLabel(map.View(), 1, 1.0));
  did(hasp::FillCavities(map.View(), 1));
  did(hasp::OpenLabel(map.View(), 1, 0.7));
  did(hasp::SeparateComponents(map.View(), 1));
  did(hasp::DilateLabel(map.View(), 1, 2.0));
  did(hasp::ErodeLabel(map.View(), 1, 0.4));
  return hashes;
}

TEST(LabelThreads, OneTwoAndFourMakeTheSameEdits)
{
  std::mt19937 random(71);
  LabelMap map = hasp::testing::RandomLabels(
    hasp::testing::SkewGrid({ 80, 60, 70 }, { 0.3, 0.4, 0.5 }, 1), 60, 4, random);
  for (std::size_t v = 0; v < map.labels.size(); v += 1 + random() % 9)
    map.labels[v] ^= 1U; // crumbs
  const auto make = [&] { return HashesOfEdits(map); };
  const std::vector<std::uint64_t> one = hasp::testing::WithThreads(1, make);
  EXPECT_EQ(hasp::testing::WithThreads(2, make), one);
  EXPECT_EQ(hasp::testing::WithThreads(4, make), one);
}

TEST(LabelThreads, OneTwoAndFourCountTheSameHistogram)
{
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 150, 140, 120 }); // several pieces
  std::vector<float> samples(grid.Size());
  std::mt19937 random(73);
  for (float& sample : samples)
    sample = float(random() % 100000) * 0.01F;
  samples[5] = 1e20F;
  const auto make = [&] {
    return hasp::CountGreyValues(hasp::GridView<const float>{ samples.data(), grid }).counts;
  };
  const std::vector<std::uint64_t> one = hasp::testing::WithThreads(1, make);
  EXPECT_GT(one.size(), 256U);
  EXPECT_EQ(hasp::testing::WithThreads(2, make), one);
  EXPECT_EQ(hasp::testing::WithThreads(4, make), one);
}

} // namespace
