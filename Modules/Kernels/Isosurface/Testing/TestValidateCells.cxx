#include "CellFixture.h"
#include "Isosurface/ValidateCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

using namespace hasp;
using hasp::testing::CellsOf;
using hasp::testing::Noise;

namespace
{

template <typename T>
ClusteredCells Sound(CellPrecision precision = CellPrecision::Exact)
{
  const GridGeometry g{ { 20, 13, 18 }, { 1, 2, 3 }, { 0.5, 0.7, 1.3 }, glm::dmat3(1) };
  const auto samples = Noise<T>(g);
  return CellsOf(GridView<const T>{ samples.data(), g }, 100.5, precision);
}

/// Labels and colours of the right number.
ClusteredCells WithAttributes(ClusteredCells cells)
{
  cells.labels.assign(cells.count, 7);
  for (const CellCluster& cluster : cells.clusters)
  {
    cells.firstColors.push_back(static_cast<std::uint32_t>(cells.colors.size()));
    cells.colors.resize(cells.colors.size() + cluster.CornerCount(), 0xFF00FF00U);
  }
  return cells;
}

std::string FaultOf(const ClusteredCells& cells)
{
  try
  {
    ValidateCells(cells);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

TEST(ValidateCells, LetsSoundCellsPass)
{
  for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
  {
    EXPECT_EQ(FaultOf(Sound<std::int16_t>(precision)), "");
    EXPECT_EQ(FaultOf(Sound<std::uint16_t>(precision)), "");
    EXPECT_EQ(FaultOf(Sound<std::uint8_t>(precision)), "");
    EXPECT_EQ(FaultOf(Sound<float>(precision)), "");
    EXPECT_EQ(FaultOf(WithAttributes(Sound<float>(precision))), "");
  }
  const GridGeometry g{ { 20, 13, 18 } };
  const std::vector<float> flat(g.Size(), 1.0F);
  EXPECT_EQ(FaultOf(CellsOf(GridView<const float>{ flat.data(), g }, 3.0)), "") << "none active";
}

TEST(ValidateCells, LetsTheLargestFloatsPass)
{
  const GridGeometry g{ { 9, 9, 9 } };
  auto samples = Noise<float>(g);
  for (float& sample : samples)
    sample = (sample < 100 ? -1 : 1) * std::numeric_limits<float>::max();
  for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
    EXPECT_EQ(FaultOf(CellsOf(GridView<const float>{ samples.data(), g }, -3e38, precision)), "");
}

struct Lie
{
  const char* says;
  std::function<void(ClusteredCells&)> tell;
};

TEST(ValidateCells, NamesWhatIsNotTrueOfTheWhole)
{
  const Lie lies[] = {
    { "dims[0] is 0", [](auto& c) { c.geometry.dims.x = 0; } },
    { "spacing[1]", [](auto& c) { c.geometry.spacing.y = -1; } },
    { "spacing[2]",
      [](auto& c) { c.geometry.spacing.z = std::numeric_limits<double>::quiet_NaN(); } },
    { "orthonormal", [](auto& c) { c.geometry.direction[0].y = 0.5; } },
    { "65537",
      [](auto& c) {
        c.geometry.dims = { 65538, 13, 18 };
      } },
    { "isovalue", [](auto& c) { c.isovalue = std::numeric_limits<float>::infinity(); } },
    { "sample type", [](auto& c) { c.cornerType = static_cast<CornerType>(3); } },
    { "precision", [](auto& c) { c.precision = static_cast<CellPrecision>(2); } },
    { "levels", [](auto& c) { c.levels = { 1.0F }; } },
    { "active cells", [](auto& c) { ++c.count; } },
    { "active cells", [](auto& c) { c.count = 0; } },
    { "words of corners", [](auto& c) { c.corners.push_back(0); } },
    { "corners are missing", [](auto& c) { c.corners.clear(); } },
    { "words of corners", [](auto& c) { c.corners.pop_back(); } },
    { "after the corners", [](auto& c) { c.corners.back() = 1; } },
    { "labels", [](auto& c) { c.labels.resize(3); } },
    { "colours", [](auto& c) { c.colors.resize(3); } },
    { "colours", [](auto& c) { c.firstColors.resize(c.clusters.size()); } },
  };
  const ClusteredCells sound = Sound<std::int16_t>();
  for (const Lie& lie : lies)
  {
    ClusteredCells cells = sound;
    lie.tell(cells);
    EXPECT_NE(FaultOf(cells).find(lie.says), std::string::npos)
      << lie.says << " is not in: " << FaultOf(cells);
  }
}

TEST(ValidateCells, NamesWhatIsNotTrueOfACluster)
{
  const Lie lies[] = {
    { "no active cell",
      [](auto& c)
      {
        c.clusters[0].active = {};
        c.clusters[0].cornersBefore = {};
      } },
    { "follow from its cells", [](auto& c) { c.clusters[1].active[3] = 1; } },
    { "follow from its cells", [](auto& c) { ++c.clusters[2].cornersBefore[4]; } },
    { "raster order", [](auto& c) { std::swap(c.clusters[0].place, c.clusters[1].place); } },
    { "raster order", [](auto& c) { c.clusters[1].place = c.clusters[0].place; } },
    { "outside the grid", [](auto& c) { c.clusters.back().place.y += 1; } },
    { "cell lies outside", [](auto& c) { c.clusters[2].active[0] |= 0x80; } },
    { "cell lies outside", [](auto& c) { c.clusters.back().active[7] |= 1; } },
    { "not legal", [](auto& c) { c.clusters[0].place.x &= 0x03FFFFFFU; } },
    { "not legal", [](auto& c) { c.clusters[0].place.x |= 17U << 26; } },
    { "not legal", [](auto& c) { c.clusters[0].place.y |= 0x2000U; } },
    { "do not follow those", [](auto& c) { ++c.clusters[1].firstCell; } },
    { "do not follow those", [](auto& c) { c.clusters[1].firstWord = 0xFFFFFFFFU; } },
    { "one side", [](auto& c) { c.isovalue = 1e6F; } },
  };
  const ClusteredCells sound = Sound<std::int16_t>();
  for (const Lie& lie : lies)
  {
    ClusteredCells cells = sound;
    lie.tell(cells);
    EXPECT_NE(FaultOf(cells).find(lie.says), std::string::npos)
      << lie.says << " is not in: " << FaultOf(cells);
  }
}

TEST(ValidateCells, NamesFaultsOfFloatsCompactCellsAndAttributes)
{
  ClusteredCells cells = Sound<float>();
  cells.corners[cells.clusters[3].firstWord] = 0x7FC00000U;
  EXPECT_NE(FaultOf(cells).find("cluster 3: a corner is NaN"), std::string::npos);
  cells = Sound<float>();
  cells.clusters[0].place.y |= 1U << 16;
  EXPECT_NE(FaultOf(cells).find("not legal"), std::string::npos);

  const ClusteredCells compact = Sound<float>(CellPrecision::Compact);
  cells = compact;
  std::swap(cells.levels[3], cells.levels[4]);
  EXPECT_NE(FaultOf(cells).find("ascending"), std::string::npos);
  cells = compact;
  cells.levels.resize(127);
  EXPECT_NE(FaultOf(cells).find("127 levels"), std::string::npos);
  cells = compact;
  cells.clusters[0].place.y |= 0xFFFF0000U;
  EXPECT_NE(FaultOf(cells).find("not legal"), std::string::npos);

  cells = WithAttributes(compact);
  cells.firstColors[1] += 1;
  EXPECT_NE(FaultOf(cells).find("its colours"), std::string::npos);
  cells = WithAttributes(compact);
  cells.colors.pop_back();
  EXPECT_NE(FaultOf(cells).find("colours of corners"), std::string::npos);
}

/// A cell whose corners are `least` and ten more; then the same with another base.
template <typename T>
std::string FaultOfBase(std::uint32_t base)
{
  const GridGeometry g{ { 2, 2, 2 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const std::vector<T> samples{ 0, 10, 0, 0, 10, 10, 0, 10 };
  ClusteredCells cells = CellsOf(GridView<const T>{ samples.data(), g }, 5);
  cells.clusters.at(0).place.y |= base << 16;
  cells.isovalue += static_cast<float>(static_cast<T>(base));
  return FaultOf(cells);
}

TEST(ValidateCells, RefusesCornersBeyondTheirSampleType)
{
  // What wraps in 16 bits does not where corners are decoded in 32: two surfaces of the same cells.
  EXPECT_EQ(FaultOfBase<std::uint16_t>(65525), "");
  EXPECT_EQ(FaultOfBase<std::int16_t>(32757), "");
  EXPECT_EQ(FaultOfBase<std::int16_t>(65530), "") << "from -6 to 4";
  EXPECT_NE(FaultOfBase<std::uint16_t>(65526).find("beyond"), std::string::npos);
  EXPECT_NE(FaultOfBase<std::int16_t>(32758).find("beyond"), std::string::npos);
}

TEST(ValidateCells, NoTurnedBitOfAClusterOrCornerMakesThemUnsafe)
{
  // What still passes must be readable in whole: run under AddressSanitizer, too.
  for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
  {
    const ClusteredCells sound = Sound<std::int16_t>(precision);
    ClusteredCells cells = sound;
    std::size_t passed = 0, refused = 0;
    const auto look = [&](std::uint32_t& word)
    {
      for (int bit = 0; bit < 32; ++bit)
      {
        word ^= 1U << bit;
        if (FaultOf(cells).empty())
          for (std::size_t n = ++passed; n < cells.Count(); n += 97)
            ASSERT_EQ(cells.Find(cells.Cell(n)), n);
        else
          ++refused;
        word ^= 1U << bit;
      }
    };
    auto* words = reinterpret_cast<std::uint32_t*>(&cells.clusters[2]);
    for (std::uint32_t n = 0; n < glsl::HaspClusterWords; ++n)
      look(words[n]);
    for (std::uint32_t n = 0; n < 8; ++n)
      look(cells.corners[cells.clusters[1].firstWord + n]);
    EXPECT_GT(refused, 500U);
    EXPECT_GT(passed, 0U); // a corner that differs and stays on its side is as good
  }
}

/// Cell by cell, through what drawing uses.
bool HasCellOnOneSide(const ClusteredCells& cells, const CellCluster& cluster)
{
  for (int n = 0; n < 512; ++n)
    if (const glm::ivec3 in(n & 7, n >> 3 & 7, n >> 6); cluster.Active(in))
    {
      const auto corners = cells.CornersFromIsovalue(cluster, in);
      const auto inside =
        std::count_if(corners.begin(), corners.end(), [](float f) { return f >= 0; });
      if (inside == 0 || inside == 8)
        return true;
    }
  return false;
}

TEST(ValidateCells, FindsJustTheCornersThatLeaveACellOnOneSide)
{
  // Around a single voxel each cell has one corner inside, so that many flips take its surface.
  const GridGeometry g{ { 20, 13, 18 } };
  std::vector<std::int16_t> samples(g.Size(), 7);
  for (std::size_t n = 100; n < samples.size(); n += 211)
    samples[n] = 120;
  const AnyGridView grid = GridView<const std::int16_t>{ samples.data(), g };
  for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
  {
    ClusteredCells cells = CellsOf(grid, 100.5, precision);
    std::size_t refused = 0, passed = 0;
    for (const CellCluster& cluster : cells.clusters)
      for (int bit = 0; bit < cluster.CornerCount() * cluster.Width(); ++bit)
      {
        std::uint32_t& word = cells.corners[cluster.firstWord + bit / 32];
        word ^= 1U << bit % 32;
        const bool bad = HasCellOnOneSide(cells, cluster);
        ASSERT_EQ(FaultOf(cells).find("one side") != std::string::npos, bad) << bit;
        ++(bad ? refused : passed);
        word ^= 1U << bit % 32;
      }
    EXPECT_GT(refused, 20U);
    EXPECT_GT(passed, 50U);
  }
}

TEST(ValidateCells, CanBeCancelled)
{
  EXPECT_THROW(ValidateCells(Sound<float>(), [](double) { return false; }), Cancelled);
}

} // namespace
