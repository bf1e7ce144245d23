// Volumes that break packing, counting or comparing; each against brute force.
#include "Isosurface/ActiveCells.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace
{

template <typename T>
T Sample(const std::vector<T>& samples, const hasp::GridGeometry& g, const glm::ivec3& p)
{
  return samples[(std::size_t(p.z) * g.dims.y + p.y) * g.dims.x + p.x];
}

/// Every cell of the grid is active or not as brute force says, with the very samples, and an edit
/// of everything gives the same again. Returns how many are active.
template <typename T>
std::size_t Check(const std::vector<T>& samples, const glm::ivec3& dims, double isovalue)
{
  const hasp::GridGeometry g{ dims, {}, { 1, 1, 1 }, glm::dmat3(1) };
  const hasp::AnyGridView grid = hasp::GridView<const T>{ samples.data(), g };
  hasp::MinMaxBlocks blocks(grid);
  auto cells = ExtractActiveCells(grid, blocks, isovalue);
  std::size_t active = 0;
  for (int k = 0; k + 1 < dims.z; ++k)
    for (int j = 0; j + 1 < dims.y; ++j)
      for (int i = 0; i + 1 < dims.x; ++i)
      {
        int inside = 0, finite = 0;
        std::array<T, 8> truth;
        for (int c = 0; c < 8; ++c)
        {
          truth[c] =
            Sample(samples, g, glm::ivec3(i, j, k) + glm::ivec3(c & 1, c >> 1 & 1, c >> 2));
          inside += float(truth[c]) >= float(isovalue);
          finite += std::isfinite(float(truth[c]));
        }
        const auto n = cells.Find({ i, j, k });
        EXPECT_EQ(n.has_value(), inside != 0 && inside != 8 && finite == 8)
          << i << " " << j << " " << k;
        if (!n)
          continue;
        ++active;
        const auto corners = cells.Corners(*n);
        for (int c = 0; c < 8; ++c)
          EXPECT_EQ(std::bit_cast<std::uint32_t>(corners[c]),
            std::bit_cast<std::uint32_t>(float(truth[c])));
      }
  EXPECT_EQ(active, cells.Count());
  const auto before = cells.corners;
  UpdateActiveCells(cells, grid, blocks, glm::ivec3(0), dims - 1);
  EXPECT_EQ(cells.corners, before);
  return active;
}

TEST(ActiveCellsExtreme, EveryCellActiveOverTheWholeRange)
{
  const glm::ivec3 dims(17, 25, 9);
  std::vector<std::int16_t> samples;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n) // odd rows: a checkerboard in all directions
    samples.push_back(
      n % 2 ? std::numeric_limits<std::int16_t>::max() : std::numeric_limits<std::int16_t>::min());
  EXPECT_EQ(Check(samples, dims, 0), 16U * 24 * 8);
  EXPECT_EQ(Check(samples, dims, 32767), 16U * 24 * 8);
  EXPECT_EQ(Check(samples, dims, -32768), 0U);
  EXPECT_EQ(Check(samples, dims, -32767.5), 16U * 24 * 8);
  EXPECT_EQ(Check(samples, dims, 1e30), 0U);
  EXPECT_EQ(Check(samples, dims, -1e30), 0U);
}

TEST(ActiveCellsExtreme, AnIsovalueThatManyCornersHave)
{
  const glm::ivec3 dims(20, 11, 13);
  std::mt19937 random(8);
  std::vector<std::uint8_t> bytes(std::size_t(dims.x) * dims.y * dims.z);
  std::vector<float> floats(bytes.size());
  for (std::size_t n = 0; n < bytes.size(); ++n)
  {
    bytes[n] = static_cast<std::uint8_t>(99 + random() % 3);
    floats[n] = float(bytes[n]) - 100.0F;
  }
  EXPECT_GT(Check(bytes, dims, 100), 1000U);
  EXPECT_EQ(Check(floats, dims, 0), Check(bytes, dims, 100));
  EXPECT_GT(Check(floats, dims, -0.0), 1000U);
}

TEST(ActiveCellsExtreme, FlatBlocksAndNoneActive)
{
  const glm::ivec3 dims(33, 33, 33);
  std::vector<std::uint16_t> samples(std::size_t(dims.x) * dims.y * dims.z, 65535);
  EXPECT_EQ(Check(samples, dims, 65535), 0U);
  EXPECT_EQ(Check(samples, dims, 65535.5), 0U);
  samples.back() = 0; // one corner of one cell
  EXPECT_EQ(Check(samples, dims, 65535), 1U);
  EXPECT_EQ(Check(samples, dims, 0.5), 1U);
}

TEST(ActiveCellsExtreme, ThinVolumes)
{
  std::mt19937 random(9);
  for (const glm::ivec3 dims : { glm::ivec3(1, 40, 40), glm::ivec3(40, 1, 40),
         glm::ivec3(40, 40, 1), glm::ivec3(2, 40, 40), glm::ivec3(40, 2, 40), glm::ivec3(40, 40, 2),
         glm::ivec3(9, 2, 300), glm::ivec3(300, 2, 2), glm::ivec3(2, 2, 2), glm::ivec3(1, 1, 1) })
  {
    std::vector<std::int16_t> samples(std::size_t(dims.x) * dims.y * dims.z);
    for (auto& s : samples)
      s = static_cast<std::int16_t>(random() % 1000);
    const std::size_t active = Check(samples, dims, 500);
    if (std::min({ dims.x, dims.y, dims.z }) == 1)
      EXPECT_EQ(active, 0U);
    else
      EXPECT_GT(active, 0U);
  }
}

TEST(ActiveCellsExtreme, FloatsThatAreNotNumbersTooLargeOrDenormal)
{
  const glm::ivec3 dims(19, 18, 17);
  std::mt19937 random(10);
  const float values[] = { 0.0F, -0.0F, 1e-45F, -1e-45F, 1e-38F, 3.4e38F, -3.4e38F,
    std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
    std::numeric_limits<float>::quiet_NaN(), 1.0F, -1.0F, 2.0F, -2.0F };
  for (const unsigned bad : { 50U, 5U }) // share of strange samples: 1 in ...
  {
    std::vector<float> samples(std::size_t(dims.x) * dims.y * dims.z);
    for (auto& s : samples)
      s = random() % bad == 0 ? values[random() % std::size(values)] : values[10 + random() % 4];
    for (const double isovalue : { 0.0, 1e-45, 1.0, -1e-39, 3e38, -3e38 })
      Check(samples, dims, isovalue);
  }
}

} // namespace
