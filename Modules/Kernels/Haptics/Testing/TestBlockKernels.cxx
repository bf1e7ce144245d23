// What vectors and plain C++ say of the same blocks, and what a plane's closed form says of both.
#include "Haptics/BlockSurface.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using hasp::BlockKernels;
using hasp::BlockPlaces;
using hasp::BlockSamples;

/// A block whose samples are of(index), anisotropic.
template <typename Function>
BlockSamples BlockOf(const Function& of, const glm::ivec3& samples = glm::ivec3(9))
{
  BlockSamples block;
  block.samples = samples;
  block.spacing = { 0.7F, 1.1F, 1.6F };
  for (int k = 0; k < samples.z; ++k)
    for (int j = 0; j < samples.y; ++j)
      for (int i = 0; i < samples.x; ++i)
        block.values[BlockSamples::IndexOf(i, j, k)] = static_cast<float>(of(glm::dvec3(i, j, k)));
  return block;
}

double Wavy(const glm::dvec3& p)
{
  return 100.0 * (p.z - 4.2 + std::sin(0.9 * p.x) + 0.7 * std::cos(1.3 * p.y));
}
/// Every cell is another case of inside and outside.
double Noise(const glm::dvec3& p)
{
  return std::sin(12.9898 * p.x + 78.233 * p.y + 37.719 * p.z) * 43.7;
}

struct AllCells
{
  AllCells()
  {
    for (int n = 0; n < BlockSamples::MostCells; ++n)
      this->Cells[n] = static_cast<std::uint16_t>(n);
  }
  std::uint16_t Cells[BlockSamples::MostCells];
};

std::vector<float> AreasOf(const BlockKernels& kernels, const BlockSamples& block)
{
  static const AllCells all;
  std::vector<float> areas(BlockSamples::MostCells);
  kernels.areas(block, all.Cells, BlockSamples::MostCells, areas.data());
  return areas;
}

TEST(BlockKernels, AreaOfAPlaneIsTheClosedForm)
{
  // z = 3.3 + 0.25 x in steps of the index: a rectangle of 5.6 by sqrt(...) mm seen from above.
  const BlockSamples block = BlockOf([](const glm::dvec3& p) { return p.z - 3.3 - 0.25 * p.x; });
  const double rise = 0.25 * 1.6 / 0.7; // mm a mm
  const double area = 8 * 0.7 * 8 * 1.1 * std::sqrt(1.0 + rise * rise);
  for (const BlockKernels& kernels : hasp::AllBlockKernels())
  {
    double sum = 0.0;
    for (const float one : AreasOf(kernels, block))
      sum += one;
    EXPECT_NEAR(sum, area, 1e-5 * area) << kernels.name;
  }
}

TEST(BlockKernels, AreasAreTheSame)
{
  const BlockKernels scalar = hasp::ScalarBlockKernels();
  for (const float outward : { 1.0F, -1.0F })
    for (const double scale : { 1.0, 1e-6, 1e6 })
    {
      BlockSamples block = BlockOf([&](const glm::dvec3& p) { return scale * Noise(p); });
      block.outward = outward;
      block.isovalue = static_cast<float>(scale * 3.0);
      const std::vector<float> expected = AreasOf(scalar, block);
      for (const BlockKernels& kernels : hasp::AllBlockKernels())
      {
        const std::vector<float> areas = AreasOf(kernels, block);
        for (std::size_t n = 0; n < areas.size(); ++n)
          EXPECT_NEAR(areas[n], expected[n], 1e-5 * expected[n] + 1e-6) << kernels.name << ' ' << n;
      }
    }
  // Samples at the isovalue are inside, and nothing crosses cells that are all one value.
  const BlockSamples flat = BlockOf([](const glm::dvec3&) { return 0.0; });
  const BlockSamples at = BlockOf([](const glm::dvec3& p) { return std::max(0.0, p.x - 4.0); });
  for (const BlockKernels& kernels : hasp::AllBlockKernels())
  {
    for (const float area : AreasOf(kernels, flat))
      EXPECT_EQ(area, 0.0F) << kernels.name;
    double sum = 0.0;
    for (const float area : AreasOf(kernels, at))
      sum += area;
    EXPECT_NEAR(sum, 8 * 1.1 * 8 * 1.6, 1e-4) << kernels.name;
  }
}

TEST(BlockKernels, PicksTheSameTetrahedron)
{
  const BlockSamples block = BlockOf(Noise);
  const BlockKernels scalar = hasp::ScalarBlockKernels();
  const std::vector<float> areas = AreasOf(scalar, block);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (const BlockKernels& kernels : hasp::AllBlockKernels())
    for (int round = 0; round < 200; ++round)
    {
      std::uint16_t cells[BlockPlaces::Count];
      float left[BlockPlaces::Count], expected[BlockPlaces::Count];
      std::uint8_t picked[BlockPlaces::Count], right[BlockPlaces::Count];
      for (int n = 0; n < BlockPlaces::Count; ++n)
      {
        cells[n] = static_cast<std::uint16_t>(random() % BlockSamples::MostCells);
        // The whole area, and more by rounding: the last piece.
        left[n] = expected[n] = areas[cells[n]] * (n == 7 ? 1.00001F : share(random));
      }
      kernels.pick(block, cells, left, picked);
      scalar.pick(block, cells, expected, right);
      for (int n = 0; n < BlockPlaces::Count; ++n)
      {
        const float slack = 1e-4F * areas[cells[n]] + 1e-6F;
        const bool border = expected[n] < slack; // just over it: the piece before will do
        EXPECT_TRUE(picked[n] == right[n] || border) << kernels.name << ' ' << cells[n];
        if (picked[n] == right[n])
        {
          EXPECT_NEAR(left[n], expected[n], slack) << kernels.name;
        }
      }
    }
}

TEST(BlockKernels, ProjectsToTheSamePlaces)
{
  std::mt19937 random(2);
  for (const glm::ivec3& samples : { glm::ivec3(9), glm::ivec3(2, 9, 5) })
  {
    const BlockSamples block = BlockOf(Wavy, samples);
    int found = 0;
    for (const BlockKernels& kernels : hasp::AllBlockKernels())
      for (int round = 0; round < 100; ++round)
      {
        BlockPlaces places;
        for (int axis = 0; axis < 3; ++axis)
          for (float& index : places.index[axis])
            index = std::uniform_real_distribution<float>(
              0.0F, static_cast<float>(samples[axis] - 1))(random);
        BlockPlaces expected = places;
        const std::uint32_t there = kernels.project(block, places);
        const std::uint32_t right = hasp::ScalarBlockKernels().project(block, expected);
        EXPECT_EQ(there, right) << kernels.name;
        for (int n = 0; n < BlockPlaces::Count; ++n)
          for (int axis = 0; axis < 3 && (there & right) >> n & 1U; ++axis)
          {
            EXPECT_NEAR(places.index[axis][n], expected.index[axis][n], 1e-5) << kernels.name;
            EXPECT_NEAR(places.normal[axis][n], expected.normal[axis][n], 1e-5) << kernels.name;
            ++found;
          }
      }
    EXPECT_GT(found, 300);
  }
}

TEST(BlockKernels, WithoutASlopeOrANumberNothingIsFound)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const BlockKernels& kernels : hasp::AllBlockKernels())
    for (const float value : { 0.0F, nan, infinite })
    {
      const BlockSamples block = BlockOf([&](const glm::dvec3&) { return value; });
      BlockPlaces places;
      EXPECT_EQ(kernels.project(block, places), 0U) << kernels.name << ' ' << value;
    }
}

TEST(BlockKernels, CellsWithASampleThatIsNoneHoldNoSurface)
{
  const hasp::GridGeometry grid{ glm::ivec3(9), glm::dvec3(0.0), { 0.7, 1.1, 1.6 },
    glm::dmat3(1.0) };
  std::vector<float> samples;
  for (int n = 0; n < BlockSamples::Most; ++n)
    samples.push_back(static_cast<float>(n / 81) - 3.5F); // a plane across all 64 columns
  for (const float none :
    { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() })
  {
    samples[BlockSamples::IndexOf(4, 4, 3)] = none; // a corner of four of its cells
    for (const BlockKernels& kernels : hasp::AllBlockKernels())
    {
      hasp::BlockSurface surface;
      surface.Read(hasp::GridView<const float>{ samples.data(), grid }, glm::ivec3(0));
      surface.SetIsovalue(0.0, 1.0);
      surface.FindCells(kernels);
      EXPECT_NEAR(surface.Area(), 60 * 0.7 * 1.1, 1e-4) << kernels.name;
    }
  }
}

} // namespace
