#include "Segmentation/PackedDelta.h"
#include "Testing/RandomLabels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace
{

using hasp::Label;
using hasp::LabelDelta;
using hasp::PackedDelta;
using hasp::VoxelBox;
using hasp::testing::LabelMap;

LabelDelta Between(const LabelMap& before, const LabelMap& after)
{
  return hasp::DifferenceOf(
    before.View(), after.View(), VoxelBox{ glm::ivec3(0), before.geometry.dims });
}

PackedDelta Pack(const LabelDelta& delta, const LabelMap& after)
{
  return hasp::PackDelta(delta, after.View());
}

LabelDelta Unpack(const PackedDelta& packed, const LabelMap& after)
{
  return hasp::UnpackDelta(packed, after.View());
}

/// Bone that is full of holes: no run of it is longer than a few voxels.
LabelMap Spongy(const glm::ivec3& dims, std::mt19937& random)
{
  LabelMap map(hasp::testing::PlainGrid(dims));
  for (Label& label : map.labels)
    label = random() % 3 ? 1 : 0;
  return map;
}

TEST(PackedDelta, GivesBackWhatWasPacked)
{
  std::mt19937 random(21);
  for (const hasp::GridGeometry& grid : hasp::testing::AwkwardGrids())
    for (int n = 0; n < 12; ++n)
    {
      const LabelMap before = hasp::testing::RandomLabels(grid, n, 60000, random);
      const LabelMap after = hasp::testing::RandomLabels(grid, n, 3, random);
      const LabelDelta delta = Between(before, after);
      const PackedDelta packed = Pack(delta, after);
      EXPECT_FALSE(packed.inBone);
      EXPECT_EQ(Unpack(packed, after), delta);
    }
}

TEST(PackedDelta, AShareOfBoneCostsItsBorderAndNotItsRows)
{
  std::mt19937 random(4);
  const LabelMap bone = Spongy({ 120, 100, 60 }, random);
  LabelMap shared = bone;
  hasp::testing::ForVoxels(bone.geometry,
    [&](const glm::ivec3& at, std::size_t v)
    {
      if (shared.labels[v])
        shared.labels[v] = at.z < 30 + at.x / 30 ? 2 : 300;
    });
  const LabelDelta delta = Between(bone, shared);
  ASSERT_GT(delta.Bytes(), 2'000'000U);
  const PackedDelta packed = Pack(delta, shared);
  EXPECT_TRUE(packed.inBone);
  EXPECT_LT(packed.Bytes(), 20'000U);
  EXPECT_EQ(Unpack(packed, shared), delta);
}

TEST(PackedDelta, ChangesOfBoneAloneAndOfOtherVoxelsAreToldApart)
{
  std::mt19937 random(5);
  const LabelMap bone = Spongy({ 60, 50, 40 }, random);
  for (const bool erase : { false, true })
  {
    LabelMap after = bone;
    for (std::size_t v = 0; v < after.labels.size(); ++v)
      if (after.labels[v] && random() % 2)
        after.labels[v] = static_cast<Label>(1 + random() % 5);
    if (erase)
      *std::find_if(after.labels.rbegin(), after.labels.rend(), [](Label l) { return l; }) = 0;
    const LabelDelta delta = Between(bone, after);
    const PackedDelta packed = Pack(delta, after);
    EXPECT_NE(packed.inBone, erase);
    EXPECT_EQ(Unpack(packed, after), delta);
    EXPECT_LT(packed.Bytes() * 2, delta.Bytes()); // the worst there is
  }
}

TEST(PackedDelta, RefusesAnotherMapAndOtherBytes)
{
  std::mt19937 random(6);
  const LabelMap bone = Spongy({ 60, 50, 40 }, random);
  LabelMap after = bone;
  for (Label& label : after.labels)
    label = label ? 2 : 0;
  const PackedDelta packed = Pack(Between(bone, after), after);
  LabelMap turned = after;
  turned.geometry.dims = { 50, 60, 40 };
  EXPECT_THROW(Unpack(packed, turned), std::invalid_argument);
  EXPECT_THROW(Pack(Between(bone, after), turned), std::invalid_argument);
  EXPECT_THROW(Unpack(packed, LabelMap(bone.geometry)), std::invalid_argument);
  EXPECT_THROW(Pack(Between(bone, after), LabelMap(bone.geometry)), std::invalid_argument);
  for (const Label from : { 2, 0 }) // a voxel of bone less, or more: all behind it would move
  {
    LabelMap other = after;
    *std::find(other.labels.begin(), other.labels.end(), from) = from ? 0 : 2;
    EXPECT_THROW(Unpack(packed, other), std::invalid_argument);
  }
  PackedDelta cut = packed;
  cut.bytes.pop_back();
  EXPECT_THROW(Unpack(cut, after), std::invalid_argument);
  PackedDelta longer = packed;
  longer.bytes.push_back(0);
  EXPECT_THROW(Unpack(longer, after), std::invalid_argument);
}

} // namespace
