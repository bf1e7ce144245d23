#include "Evaluation/VolumeDifference.h"

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{

using hasp::GridGeometry;
using hasp::GridView;

GridGeometry Oblique()
{
  const double c = std::cos(0.3), s = std::sin(0.3);
  return { { 4, 5, 6 }, { -10.0, 20.0, 3.0 }, { 0.5, 0.7, 2.0 },
    glm::dmat3({ c, s, 0.0 }, { -s, c, 0.0 }, { 0.0, 0.0, 1.0 }) };
}

std::vector<std::int16_t> Counting(const GridGeometry& g)
{
  std::vector<std::int16_t> samples(g.Size());
  std::iota(samples.begin(), samples.end(), std::int16_t(-60));
  return samples;
}

template <typename T>
GridView<const T> View(const std::vector<T>& samples, const GridGeometry& g)
{
  return { samples.data(), g };
}

TEST(VolumeDifference, AVolumeIsItself)
{
  const GridGeometry g = Oblique();
  const auto samples = Counting(g);
  const std::vector<float> floats(samples.begin(), samples.end());
  for (const hasp::AnyGridView& other :
    { hasp::AnyGridView(View(samples, g)), hasp::AnyGridView(View(floats, g)) })
  {
    const auto d = hasp::CompareVolumes(View(samples, g), other);
    EXPECT_TRUE(d.sameSize);
    EXPECT_EQ(d.positionMm, 0.0);
    EXPECT_EQ(d.samples, 0u);
  }
}

/// The same samples at the same places in memory of another order: brute force, index by index.
TEST(VolumeDifference, AxesMayBeReversedAndRenumbered)
{
  const GridGeometry g = Oblique();
  const auto samples = Counting(g);
  GridGeometry turned; // axes: k, -i, j
  turned.dims = { g.dims.z, g.dims.x, g.dims.y };
  turned.spacing = { g.spacing.z, g.spacing.x, g.spacing.y };
  turned.direction = { g.direction[2], -g.direction[0], g.direction[1] };
  turned.origin = g.IndexToWorld({ g.dims.x - 1.0, 0.0, 0.0 });
  std::vector<std::int16_t> moved(samples.size());
  const GridView<std::int16_t> into{ moved.data(), turned };
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        into(k, g.dims.x - 1 - i, j) = View(samples, g)(i, j, k);
  const auto d = hasp::CompareVolumes(View(samples, g), View(moved, turned));
  EXPECT_TRUE(d.sameSize);
  EXPECT_LT(d.positionMm, 1e-13); // rounding of doubles of this size
  EXPECT_EQ(d.samples, 0u);

  turned.direction[1] = g.direction[0]; // mirrored: the samples are elsewhere now
  EXPECT_GT(hasp::CompareVolumes(View(samples, g), View(moved, turned)).samples, 0u);
}

TEST(VolumeDifference, OneSampleOffIsFound)
{
  const GridGeometry g = Oblique();
  const auto samples = Counting(g);
  auto other = samples;
  other[g.dims.x * g.dims.y * 3 + g.dims.x * 2 + 1] += 7;
  other.back() -= 9;
  const auto d = hasp::CompareVolumes(View(samples, g), View(other, g));
  EXPECT_EQ(d.samples, 2u);
  EXPECT_EQ(d.largest, 9.0);
  EXPECT_EQ(d.first, glm::ivec3(1, 2, 3));
}

TEST(VolumeDifference, NaNIsNoSample)
{
  const GridGeometry g{ { 2, 2, 2 }, glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  std::vector<float> samples(8, 1.0F);
  samples[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(hasp::CompareVolumes(View(samples, g), View(samples, g)).samples, 1u);
}

TEST(VolumeDifference, PlacesAreMeasuredInMillimetres)
{
  const GridGeometry g = Oblique();
  const auto samples = Counting(g);
  GridGeometry other = g;
  other.origin.z += 0.25;
  EXPECT_NEAR(hasp::CompareVolumes(View(samples, g), View(samples, other)).positionMm, 0.25, 1e-12);
  other = g;
  other.spacing.z *= 1.01; // 5 steps of 2 mm: a tenth of a millimetre at the far end
  EXPECT_NEAR(hasp::CompareVolumes(View(samples, g), View(samples, other)).positionMm, 0.1, 1e-12);
  other = g;
  other.dims = { 5, 4, 6 };
  EXPECT_FALSE(hasp::CompareVolumes(View(samples, g), View(samples, other)).sameSize);
}

} // namespace
