#include "Segmentation/Components.h"
#include "Segmentation/LabelEdits.h"
#include "Segmentation/LabelMorphology.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

namespace
{

using hasp::Label;
using hasp::LabelDelta;
using hasp::testing::LabelMap;

hasp::VoxelRuns RandomStroke(const hasp::GridGeometry& grid, double radius, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  std::vector<glm::dvec3> line;
  for (int n = 0; n < 3; ++n)
    line.push_back(grid.IndexToWorld(
      glm::dvec3(share(random), share(random), share(random)) * glm::dvec3(grid.dims)));
  return hasp::RasterizeStroke(grid, line, radius);
}

TEST(LabelEdits, PaintMarksItsVoxelsAndLeavesOthersAlone)
{
  std::mt19937 random(31);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const auto& [label, only] :
      { std::pair<Label, Label>{ 5, 0 }, { 0, 0 }, { 5, 2 }, { 0, 2 }, { 65535, 1 }, { 2, 2 } })
    {
      LabelMap map = hasp::testing::RandomLabels(grid, 9, 3, random);
      LabelMap expected = map;
      const LabelMap before = map;
      const hasp::VoxelRuns runs = RandomStroke(grid, 1.2, random);
      for (const hasp::VoxelRun& run : runs)
        for (std::uint64_t v = run.first; v < run.first + run.length; ++v)
          if (only == 0 || before.labels[v] == only)
            expected.labels[v] = label;
      const LabelDelta delta = hasp::PaintVoxels(map.View(), runs, label, only);
      EXPECT_EQ(map.labels, expected.labels);
      EXPECT_EQ(delta, hasp::DifferenceOf(before.View(), std::as_const(expected).View(),
                         { glm::ivec3(0), grid.dims }));
      hasp::RevertDelta(delta, map.View());
      EXPECT_EQ(map.labels, before.labels);
    }
}

TEST(LabelEdits, PaintBeyondTheMapIsRefused)
{
  LabelMap map(hasp::testing::PlainGrid({ 4, 4, 4 }), 1);
  const std::uint64_t hash = map.Hash();
  for (const hasp::VoxelRun& bad :
    { hasp::VoxelRun{ 63, 2 }, hasp::VoxelRun{ 64, 1 }, hasp::VoxelRun{ ~std::uint64_t(0), 3 } })
    EXPECT_THROW(
      hasp::PaintVoxels(map.View(), hasp::VoxelRuns{ { 0, 4 }, bad }, 2), std::invalid_argument);
  EXPECT_EQ(map.Hash(), hash);
}

TEST(LabelEdits, MergeMovesOneLabelAlone)
{
  std::mt19937 random(37);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const auto& [from, into] :
      { std::pair<Label, Label>{ 2, 1 }, { 2, 0 }, { 60, 65535 }, { 3, 3 }, { 777, 1 } })
    {
      LabelMap map = hasp::testing::RandomLabels(grid, 40, 60, random);
      LabelMap expected = map;
      const LabelMap before = map;
      std::replace(expected.labels.begin(), expected.labels.end(), from, into);
      const LabelDelta delta = hasp::MergeLabels(map.View(), from, into);
      EXPECT_EQ(map.labels, expected.labels);
      hasp::RevertDelta(delta, map.View());
      EXPECT_EQ(map.labels, before.labels);
    }
  LabelMap map(hasp::testing::PlainGrid({ 4, 4, 4 }));
  EXPECT_THROW(hasp::MergeLabels(map.View(), 0, 1), std::invalid_argument);
}

TEST(LabelEdits, AThousandEditsUndoneGiveTheSameMap)
{
  const hasp::GridGeometry grid = hasp::testing::SkewGrid({ 24, 20, 17 }, { 0.3, 0.3, 0.5 }, 1);
  std::mt19937 random(41);
  LabelMap map = hasp::testing::RandomLabels(grid, 12, 5, random);
  std::vector<std::uint64_t> hashes{ map.Hash() };
  std::vector<LabelDelta> done;
  std::size_t changed = 0;
  for (int n = 0; n < 1000; ++n)
  {
    const auto label = static_cast<Label>(1 + random() % 5),
               other = static_cast<Label>(random() % 6);
    switch (random() % 8)
    {
      case 0:
        done.push_back(hasp::MergeLabels(map.View(), label, other));
        break;
      case 1:
        done.push_back(hasp::SeparateComponents(map.View(), label, { 0.2, random() % 2 == 0 }));
        break;
      case 2:
        done.push_back(hasp::FillCavities(map.View(), label));
        break;
      case 3:
        done.push_back(hasp::OpenLabel(map.View(), label, 0.4));
        break;
      case 4:
        done.push_back(hasp::CloseLabel(map.View(), label, 0.7));
        break;
      default:
        done.push_back(hasp::PaintVoxels(
          map.View(), RandomStroke(grid, 0.3 + 0.01 * (random() % 100), random), other));
    }
    hashes.push_back(map.Hash());
    changed += !done.back().Empty();
  }
  EXPECT_GT(changed, 500U); // or the test would say nothing
  for (std::size_t n = done.size(); n-- > 0;)
  {
    hasp::RevertDelta(done[n], map.View());
    ASSERT_EQ(map.Hash(), hashes[n]) << n;
  }
  for (std::size_t n = 0; n < done.size(); ++n)
    hasp::ApplyDelta(done[n], map.View());
  EXPECT_EQ(map.Hash(), hashes.back());
}

TEST(LabelEdits, AStrokeIsUndoneWithinAMegabyte)
{
  // 3 mm radius, 30 mm long, along each axis and across, over labels that all differ.
  const hasp::GridGeometry grid = hasp::testing::PlainGrid({ 130, 130, 130 }, glm::dvec3(0.3));
  LabelMap noise(grid);
  for (std::size_t v = 0; v < noise.labels.size(); ++v)
    noise.labels[v] = static_cast<Label>(1 + v % 3);
  LabelMap bone(grid, 1);
  const glm::dvec3 middle(19.4);
  for (const glm::dvec3& way : { glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
         glm::normalize(glm::dvec3(1, 1, 1)) })
  {
    const hasp::VoxelRuns runs = hasp::RasterizeStroke(
      grid, std::vector<glm::dvec3>{ middle - 15.0 * way, middle + 15.0 * way }, 3.0);
    // A capsule has pi r^2 (l + 4 r / 3) mm^3; its voxels are that many within 2 %.
    EXPECT_NEAR(double(hasp::CountVoxels(runs)), 961.3 / 0.027, 0.02 * 961.3 / 0.027);
    EXPECT_LE(hasp::PaintVoxels(noise.View(), runs, 9).Bytes(), 1U << 20);
    EXPECT_LE(hasp::PaintVoxels(bone.View(), runs, 9).Bytes(), 100000U);
  }
}

TEST(LabelEdits, WhoIsCancelledHasChangedNothing)
{
  std::mt19937 random(43);
  LabelMap map = hasp::testing::RandomLabels(
    hasp::testing::SkewGrid({ 30, 25, 40 }, { 0.3, 0.4, 0.5 }, 0), 20, 2, random);
  const std::uint64_t hash = map.Hash();
  const std::vector<std::function<LabelDelta(const hasp::ProgressFunction&)>> edits{
    [&](const auto& progress)
    {
      hasp::VoxelRuns all; // not joined, so that there are many
      for (std::uint64_t v = 0; v < map.labels.size(); ++v)
        all.push_back({ v, 1 });
      return hasp::PaintVoxels(map.View(), all, 2, 0, progress);
    },
    [&](const auto& progress) { return hasp::MergeLabels(map.View(), 1, 2, progress); },
    [&](const auto& progress) { return hasp::SeparateComponents(map.View(), 1, {}, progress); },
    [&](const auto& progress) { return hasp::FillCavities(map.View(), 1, progress); },
    [&](const auto& progress) { return hasp::DilateLabel(map.View(), 1, 1.0, progress); },
    [&](const auto& progress) { return hasp::ErodeLabel(map.View(), 1, 1.0, progress); },
    [&](const auto& progress) { return hasp::OpenLabel(map.View(), 1, 1.0, progress); },
    [&](const auto& progress) { return hasp::CloseLabel(map.View(), 1, 1.0, progress); },
  };
  for (const auto& edit : edits)
  {
    int looks = 0;
    double last = -1.0;
    const LabelDelta delta = edit(
      [&](double share)
      {
        EXPECT_GE(share, last - 1e-12);
        last = share;
        ++looks;
        return true;
      });
    EXPECT_DOUBLE_EQ(last, 1.0);
    EXPECT_GE(looks, 3);
    hasp::RevertDelta(delta, map.View());
    for (int stop = 0; stop < looks; ++stop)
    {
      int seen = 0;
      EXPECT_THROW(edit([&](double) { return seen++ < stop; }), hasp::Cancelled);
      ASSERT_EQ(map.Hash(), hash);
    }
  }
}

} // namespace
