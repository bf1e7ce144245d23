#include "CellFixture.h"
#include "Grid/AnalyticVolumes.h"
#include "Isosurface/SlabExtraction.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace hasp;
using hasp::testing::CellsOf;
using hasp::testing::Noise;
using hasp::testing::SameCells;

namespace
{

GridGeometry Grid(const glm::ivec3& dims)
{
  return { dims, { -10, 20, 30 }, { 0.5, 0.7, 1.3 }, glm::dmat3(1) };
}

/// What it says, or nothing if nothing is thrown.
template <typename F>
std::string Said(const F& f)
{
  try
  {
    f();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

template <typename T>
class SlabExtraction : public ::testing::Test
{
};
using SampleTypes = ::testing::Types<std::int16_t, std::uint16_t, std::uint8_t, float>;
TYPED_TEST_SUITE(SlabExtraction, SampleTypes);

TYPED_TEST(SlabExtraction, IsByteForByteThatOfTheWholeVolume)
{
  for (const glm::ivec3 dims : { glm::ivec3(19, 23, 41), glm::ivec3(9, 8, 9), glm::ivec3(20, 17, 8),
         glm::ivec3(12, 9, 10), glm::ivec3(33, 2, 50) })
  {
    const GridGeometry g = Grid(dims);
    auto samples = Noise<TypeParam>(g);
    if constexpr (std::is_same_v<TypeParam, float>)
      samples[samples.size() / 2] = std::numeric_limits<float>::quiet_NaN();
    const AnyGridView whole = GridView<const TypeParam>{ samples.data(), g };
    for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
    {
      const ClusteredCells truth = CellsOf(whole, 100.0, precision);
      ASSERT_GT(truth.Count(), 30U);
      for (const int slices : { 0, 9, 17, 25, 257 })
      {
        const ClusteredCells slabs =
          ExtractActiveCellsFromSlabs(g, SlabsOf(whole), 100.0, { precision, 1 << 30, slices });
        EXPECT_TRUE(SameCells(slabs, truth)) << slices << " of " << dims.z;
      }
    }
  }
}

TEST(SlabSources, AreAskedForEachSliceOnceInOrder)
{
  const GridGeometry g = Grid({ 9, 9, 30 });
  const auto samples = Noise<std::int16_t>(g);
  const SlabSource inner = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  std::vector<glm::ivec2> asked;
  const SlabSource source = [&](int first, int count)
  {
    asked.emplace_back(first, count);
    return inner(first, count);
  };
  ExtractActiveCellsFromSlabs(g, source, 100.0, { CellPrecision::Exact, 1 << 30, 17 });
  EXPECT_EQ(asked, (std::vector<glm::ivec2>{ { 0, 1 }, { 0, 17 }, { 16, 14 } }));
}

TEST(SlabSources, OfOtherSizesOrTypesAreRefused)
{
  const GridGeometry g = Grid({ 9, 9, 30 });
  const auto samples = Noise<std::int16_t>(g);
  const auto bytes = Noise<std::uint8_t>(g);
  const SlabSource sound = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  const SlabSource other = SlabsOf(GridView<const std::uint8_t>{ bytes.data(), g });
  const SlabSettings settings{ CellPrecision::Exact, 1 << 30, 9 };
  const auto extract = [&](const SlabSource& source)
  { return Said([&] { ExtractActiveCellsFromSlabs(g, source, 100.0, settings); }); };
  EXPECT_EQ(extract(sound), "");
  EXPECT_NE(extract([&](int first, int count)
              { return first < 8 ? sound(first, count) : other(first, count); })
              .find("one sample type"),
    std::string::npos);
  EXPECT_NE(extract([&](int first, int) { return sound(first, 1); }).find("9 x 9 x 1 samples"),
    std::string::npos);
}

TEST(SlabSources, ThatFailEndTheExtraction)
{
  const GridGeometry g = Grid({ 9, 9, 30 });
  const auto samples = Noise<std::int16_t>(g);
  const SlabSource sound = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  const SlabSource source = [&](int first, int count)
  {
    if (first > 0)
      throw std::runtime_error("the disk is gone");
    return sound(first, count);
  };
  EXPECT_EQ(Said(
              [&] {
                ExtractActiveCellsFromSlabs(g, source, 100.0, { {}, 1 << 30, 9 });
              }),
    "the disk is gone");
}

TEST(SlabSettings, OutOfRangeAreRefused)
{
  const GridGeometry g = Grid({ 9, 9, 30 });
  const auto samples = Noise<std::int16_t>(g);
  const SlabSource source = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  for (const int slices : { -7, 1, 8, 10, 16 })
    EXPECT_THROW(
      ExtractActiveCellsFromSlabs(g, source, 100.0, { {}, 1 << 30, slices }), std::invalid_argument)
      << slices;
  EXPECT_THROW(ExtractActiveCellsFromSlabs(g, source, std::numeric_limits<double>::infinity(), {}),
    std::invalid_argument);
  EXPECT_THROW(ExtractActiveCellsFromSlabs({}, source, 100.0, {}), std::invalid_argument);
}

TEST(SlabExtractionLimits, TheCapIsKeptOrSaid)
{
  const GridGeometry g = Grid({ 65, 65, 129 });
  const auto samples = SampleAnalytic<std::int16_t>(AnalyticGyroid(9), g, 100, 0);
  const SlabSource source = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  const std::size_t slab = std::size_t(65) * 65 * 9 * 2;
  const ClusteredCells whole = ExtractActiveCellsFromSlabs(g, source, 0.0);
  const auto extract = [&](std::size_t cap, CellPrecision precision) {
    return Said([&] { ExtractActiveCellsFromSlabs(g, source, 0.0, { precision, cap, 9 }); });
  };
  // What must be there at once cannot be less than slab and cells; twice and a half of the cells is
  // what moving them once takes.
  EXPECT_NE(extract(slab - 1, {}).find("after 0 %"), std::string::npos);
  EXPECT_NE(extract(slab + whole.Bytes() / 2, {}).find("the limit is"), std::string::npos);
  EXPECT_NE(extract(slab + whole.Bytes() - 1, {}).find("raise it"), std::string::npos);
  EXPECT_EQ(extract(2 * slab + whole.Bytes() * 5 / 2, {}), "");
  EXPECT_NE(
    extract(whole.Bytes() * 5 / 4, CellPrecision::Compact).find("the limit is"), std::string::npos);
}

TEST(SlabExtractionLimits, CancelEndsIt)
{
  const GridGeometry g = Grid({ 9, 9, 50 });
  const auto samples = Noise<std::int16_t>(g);
  const SlabSource source = SlabsOf(GridView<const std::int16_t>{ samples.data(), g });
  double last = -1.0;
  const auto until = [&](double end)
  {
    return [&last, end](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      return share < end;
    };
  };
  EXPECT_THROW(
    ExtractActiveCellsFromSlabs(g, source, 100.0, { {}, 1 << 30, 9 }, until(0.5)), Cancelled);
  EXPECT_LT(last, 0.7);
  last = -1.0;
  ExtractActiveCellsFromSlabs(g, source, 100.0, { {}, 1 << 30, 9 }, until(2.0));
  EXPECT_EQ(last, 1.0);
}

TEST(SlabExtractionLimits, FlatVolumesHaveNoCells)
{
  for (const glm::ivec3 dims : { glm::ivec3(9, 9, 1), glm::ivec3(1, 9, 9), glm::ivec3(1, 1, 1) })
  {
    const GridGeometry g = Grid(dims);
    const auto samples = Noise<std::int16_t>(g);
    const AnyGridView whole = GridView<const std::int16_t>{ samples.data(), g };
    EXPECT_TRUE(
      SameCells(ExtractActiveCellsFromSlabs(g, SlabsOf(whole), 100.0), CellsOf(whole, 100.0)));
  }
}

} // namespace
