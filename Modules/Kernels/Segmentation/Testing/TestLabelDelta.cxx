#include "Segmentation/LabelDelta.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::LabelDelta;
using hasp::LabelRun;
using hasp::VoxelBox;
using hasp::testing::LabelMap;

VoxelBox Whole(const LabelMap& map)
{
  return { glm::ivec3(0), map.geometry.dims };
}

TEST(LabelDelta, RefusesAMapItDoesNotFitAndLeavesItAlone)
{
  LabelMap map(hasp::testing::PlainGrid({ 5, 4, 3 }), 1);
  const LabelDelta paint{ { 5, 4, 3 }, { { 3, 4, 1, 2 }, { 20, 1, 1, 0 } } };
  hasp::ApplyDelta(paint, map.View());
  const std::vector<Label> painted = map.labels;
  EXPECT_THROW(hasp::ApplyDelta(paint, map.View()), std::invalid_argument); // a second time
  map.labels[20] = 9; // the first run fits, the second does not
  const std::vector<Label> other = map.labels;
  EXPECT_THROW(hasp::RevertDelta(paint, map.View()), std::invalid_argument);
  EXPECT_EQ(map.labels, other);
  map.labels = painted;
  LabelDelta turned = paint;
  turned.dims = { 4, 5, 3 };
  EXPECT_THROW(hasp::RevertDelta(turned, map.View()), std::invalid_argument);
  for (const LabelRun& bad : { LabelRun{ 58, 3, 1, 2 }, LabelRun{ 60, 1, 1, 2 },
         LabelRun{ ~std::uint64_t(0), 2, 1, 2 }, LabelRun{ 30, 0, 1, 2 } })
    EXPECT_THROW(hasp::ApplyDelta({ { 5, 4, 3 }, { bad } }, map.View()), std::invalid_argument);
  EXPECT_THROW(hasp::ApplyDelta({ { 5, 4, 3 }, { { 30, 3, 1, 2 }, { 32, 1, 1, 2 } } }, map.View()),
    std::invalid_argument); // overlap
  EXPECT_EQ(map.labels, painted);
  hasp::RevertDelta(paint, map.View());
  EXPECT_EQ(map.labels, std::vector<Label>(60, 1));
}

TEST(LabelDelta, TheMessageNamesTheFirstVoxelThatDiffers)
{
  LabelMap map(hasp::testing::PlainGrid({ 100, 100, 4 }), 1);
  LabelDelta paint{ map.geometry.dims, {} };
  for (std::uint64_t v = 0; v < 40000; v += 2)
    paint.Append({ v, 1, 1, 2 });
  map.labels[30002] = map.labels[12344] = 7;
  try
  {
    hasp::ApplyDelta(paint, map.View());
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("voxel 12344 has label 7"), std::string::npos)
      << error.what();
  }
}

TEST(LabelDelta, RunsAreAsLongAsTheyCanBe)
{
  LabelDelta delta{ { 10, 10, 1 }, {} };
  delta.Append({ 0, 3, 1, 2 });
  delta.Append({ 3, 2, 1, 2 }); // goes on
  delta.Append({ 5, 2, 0, 2 }); // another label before
  delta.Append({ 7, 1, 2, 2 }); // changes nothing
  delta.Append({ 8, 0, 1, 2 }); // is nothing
  EXPECT_EQ(delta.runs, (std::vector<LabelRun>{ { 0, 5, 1, 2 }, { 5, 2, 0, 2 } }));
  EXPECT_THROW(delta.Append({ 6, 1, 1, 2 }), std::invalid_argument);
  EXPECT_EQ(delta.Voxels(), 7U);
  // What a run can count is not run over.
  LabelDelta vast{ { 1 << 20, 1 << 20, 1 }, {} };
  vast.Append({ 0, 0xffffffffU, 1, 2 });
  vast.Append({ 0xffffffffU, 5, 1, 2 });
  EXPECT_EQ(vast.runs.size(), 2U);
  EXPECT_EQ(vast.Voxels(), 0x100000004U);
}

TEST(LabelDelta, TheBoxHoldsWhatChangesAndNoMore)
{
  std::mt19937 random(3);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (int n = 0; n < 20; ++n)
    {
      const LabelMap before = hasp::testing::RandomLabels(grid, n, 3, random);
      const LabelMap after = hasp::testing::RandomLabels(grid, n, 3, random);
      const LabelDelta delta = hasp::DifferenceOf(before.View(), after.View(), Whole(before));
      VoxelBox box{ grid.dims, glm::ivec3(0) };
      std::uint64_t voxels = 0;
      hasp::testing::ForVoxels(grid,
        [&](const glm::ivec3& at, std::size_t v)
        {
          if (before.labels[v] == after.labels[v])
            return;
          ++voxels;
          box = { glm::min(box.low, at), glm::max(box.high, at + 1) };
        });
      EXPECT_EQ(delta.Voxels(), voxels);
      const VoxelBox found = delta.Box();
      if (voxels == 0)
      {
        EXPECT_TRUE(found.Empty());
        continue;
      }
      // A run over a row's end makes the box wider along x.
      EXPECT_EQ(glm::min(found.low, box.low), found.low);
      EXPECT_EQ(glm::max(found.high, box.high), found.high);
      EXPECT_EQ(found.low.z, box.low.z);
      EXPECT_EQ(found.high.z, box.high.z);
    }
}

TEST(LabelDelta, DifferencesMakeOneMapOfTheOtherAndBack)
{
  std::mt19937 random(5);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
  {
    LabelMap map = hasp::testing::RandomLabels(grid, 9, 60, random);
    const LabelMap from = map, to = hasp::testing::RandomLabels(grid, 9, 60, random);
    const LabelDelta delta = hasp::DifferenceOf(from.View(), to.View(), Whole(map));
    hasp::ApplyDelta(delta, map.View());
    EXPECT_EQ(map.labels, to.labels);
    hasp::RevertDelta(delta, map.View());
    EXPECT_EQ(map.labels, from.labels);
    EXPECT_TRUE(hasp::DifferenceOf(from.View(), from.View(), Whole(map)).Empty());
    EXPECT_TRUE(hasp::DifferenceOf(from.View(), to.View(), {}).Empty());
    EXPECT_THROW(hasp::DifferenceOf(from.View(), to.View(), Whole(map).Grown({ 1, 0, 0 })),
      std::invalid_argument);
  }
}

TEST(LabelDelta, ADifferenceLooksIntoItsBoxAlone)
{
  const LabelMap from(hasp::testing::PlainGrid({ 6, 5, 4 }), 1);
  const LabelMap to(from.geometry, 2);
  const LabelDelta delta = hasp::DifferenceOf(from.View(), to.View(), { { 1, 2, 1 }, { 4, 4, 3 } });
  EXPECT_EQ(delta.Voxels(), 12U);
  EXPECT_EQ(delta.Box(), (VoxelBox{ { 1, 2, 1 }, { 4, 4, 3 } }));
}

TEST(LabelDelta, JoinedDeltasAreWhatIsBetweenTheFirstMapAndTheLast)
{
  std::mt19937 random(11);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (int n = 1; n < 12; ++n)
    {
      const LabelMap a = hasp::testing::RandomLabels(grid, n, 2, random);
      const LabelMap b = hasp::testing::RandomLabels(grid, n, 2, random);
      const LabelMap c = hasp::testing::RandomLabels(grid, n, 2, random);
      const LabelDelta first = hasp::DifferenceOf(a.View(), b.View(), Whole(a));
      const LabelDelta second = hasp::DifferenceOf(b.View(), c.View(), Whole(a));
      EXPECT_EQ(hasp::JoinDeltas(first, second), hasp::DifferenceOf(a.View(), c.View(), Whole(a)));
      if (!first.Empty())
      {
        EXPECT_THROW(hasp::JoinDeltas(first, first), std::invalid_argument);
      }
    }
  EXPECT_THROW(hasp::JoinDeltas({ { 1, 2, 3 }, {} }, { { 3, 2, 1 }, {} }), std::invalid_argument);
}

TEST(LabelHash, TellsMapsApart)
{
  LabelMap map(hasp::testing::PlainGrid({ 70, 70, 33 }), 1); // more than two pieces
  const std::uint64_t hash = map.Hash();
  LabelMap turned = map;
  turned.geometry.dims = { 70, 33, 70 };
  EXPECT_NE(turned.Hash(), hash);
  for (const std::size_t v : { std::size_t(0), std::size_t(65535), std::size_t(65536),
         map.labels.size() - 1 }) // ends of pieces, and what is left over of a word
  {
    map.labels[v] = 2;
    EXPECT_NE(map.Hash(), hash) << v;
    map.labels[v] = 1;
  }
  EXPECT_EQ(map.Hash(), hash);
  // Two pieces changed over: their order counts.
  std::fill_n(map.labels.begin(), 65536, Label(5));
  const std::uint64_t front = map.Hash();
  std::fill_n(map.labels.begin(), 65536, Label(1));
  std::fill_n(map.labels.begin() + 65536, 65536, Label(5));
  EXPECT_NE(map.Hash(), front);
}

TEST(LabelHash, IsTheSameOnEachMachine)
{
  // Written down once: files may come to hold it.
  LabelMap map(hasp::testing::PlainGrid({ 3, 2, 1 }));
  for (std::size_t v = 0; v < 6; ++v)
    map.labels[v] = static_cast<Label>(1000 * v + 1);
  EXPECT_EQ(map.Hash(), 10768154584433245439U);
}

} // namespace
