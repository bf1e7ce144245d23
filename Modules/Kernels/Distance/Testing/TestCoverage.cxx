#include "Distance/Coverage.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Trilinear.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{

glm::dmat3 Tilted()
{
  return glm::dmat3(glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, -2, 3))));
}

/// Stretched and turned, as CTs are.
hasp::GridGeometry Slices()
{
  const glm::dmat3 d = Tilted();
  return { { 21, 19, 15 }, d * glm::dvec3(-9.6, -8.6, -10.5), { 0.957, 0.957, 1.5 }, d };
}

TEST(Coverage, MatchesBruteForceSupersampling)
{
  const auto grid = Slices();
  const auto samples =
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0.3, 0.1, -0.4 }, 6), grid, 100, 226);
  const hasp::GridView<const std::int16_t> ct{ samples.data(), grid };
  // Another orientation, finer on one axis, and reaching out of the source.
  const hasp::GridGeometry target{ { 27, 25, 13 }, { -13, -12, -9 }, { 0.9, 0.8, 1.6 },
    glm::dmat3(1) };
  hasp::CoverageSettings settings;
  settings.samplesPerAxis = 3;
  const auto coverage = hasp::Coverage(ct, target, settings);
  std::size_t v = 0, partial = 0;
  for (int k = 0; k < target.dims.z; ++k)
    for (int j = 0; j < target.dims.y; ++j)
      for (int i = 0; i < target.dims.x; ++i, ++v)
      {
        int count = 0;
        for (int s = 0; s < 27; ++s)
        {
          const glm::dvec3 sub(s % 3 - 1, s / 3 % 3 - 1, s / 9 - 1);
          const auto value = SampleTrilinear(
            ct, grid.WorldToIndex(target.IndexToWorld(glm::dvec3(i, j, k) + sub / 3.0)));
          count += value && *value >= 226.0;
        }
        // A sub-sample may fall on the other side by rounding; none does with these numbers.
        ASSERT_NEAR(coverage[v], count / 27.0, 1e-6) << i << " " << j << " " << k;
        partial += count > 0 && count < 27;
      }
  EXPECT_GT(partial, 300U);
}

TEST(Coverage, AddsUpToTheVolumeOfASphere)
{
  const hasp::GridGeometry grid{ glm::ivec3(40), glm::dvec3(-19.5), glm::dvec3(1), glm::dmat3(1) };
  const auto samples = hasp::SampleAnalytic<float>(hasp::AnalyticSphere({}, 15), grid, 1, 0);
  const hasp::GridView<const float> ct{ samples.data(), grid };
  const hasp::GridGeometry target{ { 60, 60, 30 }, Tilted() * glm::dvec3(-17.7, -17.7, -17.4),
    { 0.6, 0.6, 1.2 }, Tilted() };
  hasp::CoverageSettings settings;
  settings.isovalue = 0;
  const auto coverage = hasp::Coverage(ct, target, settings);
  const double volume = std::accumulate(coverage.begin(), coverage.end(), 0.0) * 0.6 * 0.6 * 1.2;
  // Trilinear cuts a sphere's cap of each cell: about 1/8 (1/R + 1/R) mm of radius, 0.017 * 3/R.
  EXPECT_NEAR(volume / (4.0 / 3.0 * glm::pi<double>() * 15 * 15 * 15), 1.0, 0.004);
}

TEST(Coverage, SpecksAreLeftOut)
{
  const hasp::GridGeometry grid{ { 20, 10, 10 }, {}, glm::dvec3(1), glm::dmat3(1) };
  std::vector<std::uint8_t> samples(grid.Size(), 0);
  const hasp::GridView<const std::uint8_t> ct{ samples.data(), grid };
  for (int k = 2; k < 8; ++k)
    for (int j = 2; j < 8; ++j)
      for (int i = 2; i < 8; ++i)
        samples[ct.Offset(i, j, k)] = 200;
  for (const int i : { 14, 15 })
    samples[ct.Offset(i, 5, 5)] = 200;
  const auto keep = hasp::KeepLargePieces(ct, 100, 3.0);
  EXPECT_EQ(std::accumulate(keep.begin(), keep.end(), 0), 216);
  EXPECT_EQ(std::accumulate(keep.begin(), keep.end(), 0), 216);
  const auto all = hasp::KeepLargePieces(ct, 100, 2.0); // two voxels are 2 mm3
  EXPECT_EQ(std::accumulate(all.begin(), all.end(), 0), 218);
  hasp::CoverageSettings settings;
  settings.isovalue = 100;
  settings.keep = keep;
  const auto with = hasp::Coverage(ct, grid, settings);
  settings.keep = {};
  const auto without = hasp::Coverage(ct, grid, settings);
  EXPECT_EQ(with[ct.Offset(14, 5, 5)], 0.0F);
  EXPECT_GT(without[ct.Offset(14, 5, 5)], 0.3F);
  for (int i = 0; i < 11; ++i)
    EXPECT_EQ(with[ct.Offset(i, 5, 5)], without[ct.Offset(i, 5, 5)]);
}

TEST(Coverage, ANeighbouringFragmentCountsAsOutside)
{
  // A block of bone, index 2 to 17 on each axis, cut into labels 1 and 2 between samples 9 and 10,
  // and label 0 from sample 15 on: bright, but nobody's.
  const hasp::GridGeometry grid{ glm::ivec3(20), {}, glm::dvec3(1), glm::dmat3(1) };
  std::vector<std::int16_t> grey(grid.Size(), 0);
  std::vector<std::uint8_t> labels(grid.Size(), 0);
  const hasp::GridView<const std::int16_t> ct{ grey.data(), grid };
  for (int k = 2; k < 18; ++k)
    for (int j = 2; j < 18; ++j)
      for (int i = 2; i < 18; ++i)
      {
        grey[ct.Offset(i, j, k)] = 1000;
        labels[ct.Offset(i, j, k)] = i < 10 ? 1 : i < 15 ? 2 : 0;
      }
  // Four voxels a sample along x, inside the block along y and z: the surface lies at index 1.5,
  // where the grey value is half, the cut at 9.5, and nobody's part begins at 14.5.
  const hasp::GridGeometry target{ { 80, 3, 3 }, { -0.375, 8, 8 }, { 0.25, 1, 1 }, glm::dmat3(1) };
  hasp::CoverageSettings settings;
  settings.isovalue = 500;
  const hasp::AnyGridView mask = hasp::GridView<const std::uint8_t>{ labels.data(), grid };
  for (const int label : { 1, 2 })
  {
    const auto keep = hasp::KeepLabel(mask, label);
    settings.keep = keep;
    const auto coverage = hasp::Coverage(ct, target, settings);
    const double low = label == 1 ? 1.5 : 9.5, high = label == 1 ? 9.5 : 14.5;
    for (std::size_t v = 0; v < coverage.size(); ++v)
    {
      const double from = -0.5 + 0.25 * double(v % 80), to = from + 0.25;
      const double share = std::clamp((std::min(to, high) - std::max(from, low)) / 0.25, 0.0, 1.0);
      ASSERT_NEAR(coverage[v], share, 1e-6) << label << " " << v;
    }
  }
}

TEST(Coverage, SpecksByTheThousandReportProgressNowAndThen)
{
  const hasp::GridGeometry grid{ { 60, 60, 60 }, {}, glm::dvec3(1), glm::dmat3(1) };
  std::vector<std::uint8_t> samples(grid.Size(), 0);
  for (int n = 0; n < 27000; ++n) // every other sample on each axis: 27,000 pieces
    samples[(n / 900 * 2 * 60 + n / 30 % 30 * 2) * 60 + n % 30 * 2] = 200;
  int calls = 0;
  double last = 0.0;
  const auto keep =
    hasp::KeepLargePieces(hasp::GridView<const std::uint8_t>{ samples.data(), grid }, 100, 2.0,
      [&](double share)
      {
        EXPECT_GE(share, last);
        last = share;
        return ++calls > 0;
      });
  EXPECT_EQ(std::accumulate(keep.begin(), keep.end(), 0), 0);
  EXPECT_GE(calls, 10);
  EXPECT_LE(calls, 100);
  EXPECT_EQ(last, 1.0);
}

TEST(Coverage, DiagonalNeighboursAreOnePiece)
{
  const hasp::GridGeometry grid{ glm::ivec3(4), {}, glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> samples(64, 0.0F);
  const hasp::GridView<const float> ct{ samples.data(), grid };
  samples[ct.Offset(0, 0, 0)] = samples[ct.Offset(1, 1, 1)] = samples[ct.Offset(2, 2, 2)] = 1.0F;
  samples[ct.Offset(0, 3, 0)] = std::numeric_limits<float>::quiet_NaN();
  const auto keep = hasp::KeepLargePieces(ct, 0.5, 3.0);
  EXPECT_EQ(std::accumulate(keep.begin(), keep.end(), 0), 3);
}

TEST(Coverage, OneNaNTakesAwayWhatItsCellsHoldAndNoMore)
{
  // Voxels finer than the source's cells, as guides have them: many reach into a cell of the NaN
  // while their middle lies in another.
  const auto grid = Slices();
  auto samples = hasp::SampleAnalytic<float>(hasp::AnalyticSphere({}, 6), grid, 100, 226);
  const hasp::GridView<const float> ct{ samples.data(), grid };
  samples[ct.Offset(10, 9, 7)] = std::numeric_limits<float>::quiet_NaN();
  const hasp::GridGeometry target{ glm::ivec3(20), glm::dvec3(-3.8), glm::dvec3(0.4),
    glm::dmat3(1) };
  hasp::CoverageSettings settings;
  settings.samplesPerAxis = 2;
  const auto coverage = hasp::Coverage(ct, target, settings);
  std::size_t v = 0, partial = 0;
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i, ++v)
      {
        int count = 0;
        for (int s = 0; s < 8; ++s)
        {
          const glm::dvec3 sub(
            0.5 * (s & 1) - 0.25, 0.5 * (s >> 1 & 1) - 0.25, 0.5 * (s >> 2) - 0.25);
          const auto value =
            SampleTrilinear(ct, grid.WorldToIndex(target.IndexToWorld(glm::dvec3(i, j, k) + sub)));
          count += value && *value >= 226.0;
        }
        ASSERT_EQ(coverage[v], count / 8.0F) << i << " " << j << " " << k;
        partial += count > 0 && count < 8;
      }
  EXPECT_GT(partial, 100U);
}

TEST(Coverage, NaNIsOutsideAndFaultsAreNamed)
{
  const hasp::GridGeometry grid{ glm::ivec3(5), {}, glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> samples(125, std::numeric_limits<float>::quiet_NaN());
  const hasp::GridView<const float> ct{ samples.data(), grid };
  for (const float c : hasp::Coverage(ct, grid, {}))
    ASSERT_EQ(c, 0.0F);
  hasp::CoverageSettings bad;
  bad.samplesPerAxis = 0;
  EXPECT_THROW(hasp::Coverage(ct, grid, bad), std::invalid_argument);
  bad = {};
  bad.isovalue = std::nan("");
  EXPECT_THROW(hasp::Coverage(ct, grid, bad), std::invalid_argument);
  bad = {};
  const std::vector<std::uint8_t> few(7);
  bad.keep = few;
  EXPECT_THROW(hasp::Coverage(ct, grid, bad), std::invalid_argument);
  EXPECT_THROW(hasp::Coverage(ct, grid, {}, [](double) { return false; }), hasp::Cancelled);
  EXPECT_THROW(hasp::KeepLargePieces(ct, 1, -1), std::invalid_argument);
}

} // namespace
