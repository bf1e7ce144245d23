#include "Isosurface/ClusteredCells.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace
{

/// Cells of one slice as bits, in three densities.
std::vector<std::uint64_t> Slices()
{
  std::mt19937_64 random(3);
  std::vector<std::uint64_t> slices{ 0, ~std::uint64_t{ 0 }, 1, std::uint64_t{ 1 } << 63,
    0x8080808080808080ULL, 0xFF00000000000000ULL };
  for (int n = 0; n < 60; ++n)
    slices.push_back(n % 3 == 0   ? random()
                     : n % 3 == 1 ? random() & random() & random()
                                  : random() | random());
  return slices;
}

glm::uvec2 Words(std::uint64_t slice)
{
  return { static_cast<std::uint32_t>(slice), static_cast<std::uint32_t>(slice >> 32) };
}

TEST(CellLayout, CornersBeforeMatchesCounting)
{
  for (const std::uint64_t slice : Slices())
  {
    std::set<std::pair<int, int>> corners; // y, x: the order of the stream
    for (int bit = 0; bit < 64; ++bit)
      if (slice >> bit & 1)
        for (int c = 0; c < 4; ++c)
          corners.insert({ (bit >> 3) + (c >> 1), (bit & 7) + (c & 1) });
    std::uint32_t count = 0;
    for (const auto& [y, x] : corners)
      ASSERT_EQ(hasp::glsl::HaspCornersBefore(Words(slice), x, y), count++)
        << std::hex << slice << " at " << x << ", " << y;
    EXPECT_EQ(hasp::glsl::HaspCornersBefore(Words(slice), 9, 8), count);
  }
}

TEST(CellLayout, SelectBitFindsEachBit)
{
  for (const std::uint64_t slice : Slices())
  {
    std::uint32_t n = 0;
    for (std::uint32_t bit = 0; bit < 64; ++bit)
    {
      if (slice >> bit & 1)
      {
        ASSERT_EQ(hasp::glsl::HaspSelectBit(Words(slice), n++), bit) << std::hex << slice;
      }
    }
    EXPECT_EQ(hasp::glsl::HaspCountBits(Words(slice)), n);
  }
}

TEST(CellLayout, PlaceHoldsTheLargestOriginWidthAndBase)
{
  hasp::CellCluster cluster;
  cluster.place = { 8191U | 8190U << 13 | 32U << 26, 8189U | 65535U << 16 };
  EXPECT_EQ(cluster.Origin(), glm::ivec3(8191 * 8, 8190 * 8, 8189 * 8));
  EXPECT_EQ(cluster.Width(), 32);
  EXPECT_EQ(cluster.Base(), 65535);
}

} // namespace
