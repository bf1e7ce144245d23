#include "Segmentation/LabelMorphology.h"
#include "Testing/RandomLabels.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace
{

using hasp::Label;
using hasp::LabelDelta;
using hasp::testing::ForVoxels;
using hasp::testing::LabelMap;
using Set = std::vector<bool>;

/// A grid that also has room around the scan, so that what lies beyond it can be asked for.
struct Space
{
  glm::ivec3 dims, room;
  glm::dvec3 spacing;
  double radius;

  hasp::GridGeometry Grid() const { return hasp::testing::PlainGrid(dims + 2 * room, spacing); }
  bool InScan(const glm::ivec3& at) const
  {
    return glm::all(glm::greaterThanEqual(at, room)) && glm::all(glm::lessThan(at, dims + room));
  }
  /// Voxels with one of the set within the radius: brute force over all that could be.
  Set Near(const Set& set) const
  {
    Set near(set.size());
    const hasp::GridGeometry grid = Grid();
    const hasp::GridView<const Label> offsets{ nullptr, grid };
    const glm::ivec3 reach = glm::ivec3(radius / spacing) + 1;
    ForVoxels(grid,
      [&](const glm::ivec3& at, std::size_t v)
      {
        const hasp::VoxelBox box = hasp::VoxelBox{ at - reach, at + reach + 1 }.In(grid.dims);
        bool found = false;
        for (int k = box.low.z; k < box.high.z && !found; ++k)
          for (int j = box.low.y; j < box.high.y && !found; ++j)
            for (int i = box.low.x; i < box.high.x && !found; ++i)
              found = set[offsets.Offset(i, j, k)] &&
                      glm::length(spacing * glm::dvec3(glm::ivec3(i, j, k) - at)) <=
                        radius * (1.0 + 1e-6);
        near[v] = found;
      });
    return near;
  }
};

enum class Way
{
  Dilate,
  Erode,
  Open,
  Close
};

/// From the definitions, on sets, with room of a radius around the scan.
LabelMap Expected(const LabelMap& map, Label label, double radius, Way way)
{
  Space space{ map.geometry.dims, glm::ivec3(radius / map.geometry.spacing) + 1,
    map.geometry.spacing, radius };
  if (way != Way::Close)
    space.room = glm::ivec3(0); // nothing beyond the scan is asked for
  const std::size_t size = space.Grid().Size();
  Set is(size), isNot(size);
  LabelMap result = map;
  const auto labelAt = [&](const glm::ivec3& at) -> Label&
  {
    const glm::ivec3 p = at - space.room;
    return result.At(p.x, p.y, p.z);
  };
  ForVoxels(space.Grid(),
    [&](const glm::ivec3& at, std::size_t v)
    {
      is[v] = space.InScan(at) && labelAt(at) == label;
      isNot[v] = !is[v];
    });
  Set reached;
  if (way == Way::Dilate)
    reached = space.Near(is);
  else if (way == Way::Erode)
    reached = space.Near(isNot);
  else if (way == Way::Open)
  {
    Set core = space.Near(isNot);
    for (std::size_t v = 0; v < size; ++v)
      core[v] = is[v] && !core[v];
    reached = space.Near(core);
  }
  else
  {
    Set far = space.Near(is);
    far.flip();
    reached = space.Near(far);
    reached.flip();
  }
  const bool grows = way == Way::Dilate || way == Way::Close;
  ForVoxels(space.Grid(),
    [&](const glm::ivec3& at, std::size_t v)
    {
      if (!space.InScan(at))
        return;
      Label& to = labelAt(at);
      if (grows && to == 0 && reached[v])
        to = label;
      if (!grows && to == label && reached[v] == (way == Way::Erode))
        to = 0;
    });
  return result;
}

LabelDelta Do(LabelMap& map, Label label, double radius, Way way)
{
  return way == Way::Dilate  ? hasp::DilateLabel(map.View(), label, radius)
         : way == Way::Erode ? hasp::ErodeLabel(map.View(), label, radius)
         : way == Way::Open  ? hasp::OpenLabel(map.View(), label, radius)
                             : hasp::CloseLabel(map.View(), label, radius);
}

constexpr Way Ways[] = { Way::Dilate, Way::Erode, Way::Open, Way::Close };

TEST(LabelMorphology, NonsenseIsRefused)
{
  LabelMap map(hasp::testing::PlainGrid({ 4, 4, 4 }, { 0.01, 1, 1 }), 1);
  for (const Way way : Ways)
  {
    EXPECT_THROW(Do(map, 0, 1.0, way), std::invalid_argument);
    for (const double bad : { 0.0, -1.0, 50.1, std::nan("") })
      EXPECT_THROW(Do(map, 1, bad, way), std::invalid_argument);
    EXPECT_THROW(Do(map, 1, 10.02, way), std::invalid_argument); // 1,002 voxels
    EXPECT_TRUE(Do(map, 7, 1.0, way).Empty());                   // has no voxels
    EXPECT_TRUE(Do(map, 1, 10.0, way).Empty());                  // the border is no edge
  }
}

TEST(LabelMorphology, IsWhatTheDefinitionsSay)
{
  std::mt19937 random(59);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (const double radius : { 0.2, 0.9, 2.1 })
      for (const Way way : Ways)
        for (const int blobs : { 1, 3, 8 })
        {
          LabelMap map = hasp::testing::RandomLabels(grid, blobs, 2, random);
          const LabelMap before = map;
          const LabelDelta delta = Do(map, 1, radius, way);
          ASSERT_EQ(map.labels, Expected(before, 1, radius, way).labels)
            << int(way) << ' ' << radius << ' ' << grid.dims.x << ' ' << grid.dims.y;
          hasp::RevertDelta(delta, map.View());
          EXPECT_EQ(map.labels, before.labels);
        }
}

TEST(LabelMorphology, ABallIsABall)
{
  // One voxel dilated by 3 voxels, ties and all: as many as whole points within 3 of the origin.
  LabelMap map(hasp::testing::PlainGrid({ 21, 21, 21 }, glm::dvec3(0.3)));
  map.At(10, 10, 10) = 4;
  hasp::DilateLabel(map.View(), 4, 0.9);
  EXPECT_EQ(hasp::CountLabels(std::as_const(map).View())[4], 123U);
  hasp::ErodeLabel(map.View(), 4, 0.9);
  // The nearest outside of the ball is 10 away from its middle, squared, and 9 from all others.
  EXPECT_EQ(hasp::CountLabels(std::as_const(map).View())[4], 1U);
  EXPECT_EQ(map.At(10, 10, 10), 4);
  hasp::ErodeLabel(map.View(), 4, 0.3);
  EXPECT_EQ(map.At(10, 10, 10), 0);
}

TEST(LabelMorphology, OpenAndCloseDoNothingTheSecondTime)
{
  std::mt19937 random(61);
  for (int n = 0; n < 20; ++n)
    for (const Way way : { Way::Open, Way::Close })
    {
      LabelMap map = hasp::testing::RandomLabels(
        hasp::testing::SkewGrid({ 31, 26, 22 }, { 0.3, 0.4, 0.7 }, n), 12, 1, random);
      Do(map, 1, 1.1, way);
      EXPECT_TRUE(Do(map, 1, 1.1, way).Empty());
    }
}

TEST(LabelMorphology, ReachesAsFarFromEachSlice)
{
  // In closed form: 3 slices each way, also from one slab into the next.
  for (int seed = 0; seed < 150; ++seed)
  {
    LabelMap map(hasp::testing::PlainGrid({ 1, 1, 150 }, { 1, 1, 0.1 }));
    map.At(0, 0, seed) = 1;
    hasp::DilateLabel(map.View(), 1, 0.3);
    for (int k = 0; k < 150; ++k)
      ASSERT_EQ(map.At(0, 0, k), std::abs(k - seed) <= 3) << seed << ' ' << k;
  }
}

TEST(LabelMorphology, TallGridsAreWorkedOnInSlabsWithoutASeam)
{
  // More slices than are held, and a radius over more slices than a slab has.
  std::mt19937 random(67);
  for (const double radius : { 0.35, 4.5 })
    for (const Way way : Ways)
    {
      LabelMap map = hasp::testing::RandomLabels(
        hasp::testing::PlainGrid({ 5, 4, 150 }, { 1, 1, 0.1 }), 14, 2, random);
      const LabelMap expected = Expected(map, 1, radius, way);
      Do(map, 1, radius, way);
      ASSERT_EQ(map.labels, expected.labels) << int(way) << ' ' << radius;
    }
}

} // namespace
