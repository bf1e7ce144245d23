#include "IOFixture.h"

#include "vtkHaspVolumeHash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using hasp::CanonicalPlace;
using hasp::GridGeometry;

/// Right-angled, pointing anywhere.
glm::dmat3 RandomDirection(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  const glm::dvec3 x = glm::normalize(vector());
  const glm::dvec3 y = glm::normalize(glm::cross(vector(), x));
  return { x, y, glm::cross(x, y) * (random() & 1 ? 1.0 : -1.0) };
}

/// As a NIfTI-1 file keeps it.
GridGeometry ThroughFloat32(const GridGeometry& g)
{
  GridGeometry kept = g;
  for (int a = 0; a < 3; ++a)
  {
    const glm::dvec3 step(glm::vec3(g.direction[a] * g.spacing[a]));
    kept.spacing[a] = glm::length(step);
    kept.direction[a] = step / kept.spacing[a];
    kept.origin[a] = static_cast<float>(g.origin[a]);
  }
  return kept;
}

/// The same samples and places, axes permuted and turned.
template <typename T>
GridGeometry Rearrange(const GridGeometry& g, const std::vector<T>& samples, const int axis[3],
  int turned, std::vector<T>& rearranged)
{
  GridGeometry other = g;
  glm::dvec3 first(0.0);
  for (int a = 0; a < 3; ++a)
  {
    const bool turn = turned & (1 << a);
    other.dims[a] = g.dims[axis[a]];
    other.spacing[a] = g.spacing[axis[a]];
    other.direction[a] = g.direction[axis[a]] * (turn ? -1.0 : 1.0);
    first[axis[a]] = turn ? g.dims[axis[a]] - 1 : 0;
  }
  other.origin = g.IndexToWorld(first);
  rearranged.resize(samples.size());
  for (int k = 0, n = 0; k < other.dims.z; ++k)
    for (int j = 0; j < other.dims.y; ++j)
      for (int i = 0; i < other.dims.x; ++i, ++n)
      {
        glm::ivec3 from(first);
        const int at[] = { i, j, k };
        for (int a = 0; a < 3; ++a)
          from[axis[a]] += turned & (1 << a) ? -at[a] : at[a];
        rearranged[n] = samples[(std::size_t(from.z) * g.dims.y + from.y) * g.dims.x + from.x];
      }
  return other;
}

TEST(VolumePlace, PlacesChangeWithWhatMatters)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit;
  const double tenth = 1.001;
  for (int n = 0; n < 2000; ++n)
  {
    GridGeometry g;
    g.dims = { 2 + int(500 * unit(random)), 2 + int(500 * unit(random)),
      2 + int(500 * unit(random)) };
    g.origin = 300.0 * glm::dvec3(unit(random), -unit(random), unit(random));
    g.spacing = { std::pow(10.0, 6.0 * unit(random) - 3.0), 0.7, 2.0 };
    g.direction = RandomDirection(random);
    const auto place = CanonicalPlace(g);
    for (int a = 0; a < 3; ++a)
    {
      GridGeometry other = g;
      other.spacing[a] *= tenth;
      EXPECT_NE(CanonicalPlace(other), place);
      other = g;
      other.dims[a] += 1;
      EXPECT_NE(CanonicalPlace(other), place);
      other = g;
      other.origin += 0.5 * std::min({ g.spacing.x, g.spacing.y, g.spacing.z }) * g.direction[a];
      EXPECT_NE(CanonicalPlace(other), place);
      other = g;
      other.direction[a] *= -1.0;
      EXPECT_NE(CanonicalPlace(other), place);
    }
  }
}

TEST(VolumePlace, RandomObliqueGeometriesSurviveFloat32ButForOneIn2000)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit;
  int changed = 0, cornersChanged = 0;
  for (int n = 0; n < 100000; ++n)
  {
    GridGeometry g;
    for (int a = 0; a < 3; ++a)
    {
      g.dims[a] = 32 + static_cast<int>(481.0 * unit(random));
      g.origin[a] = 600.0 * unit(random) - 300.0;
      g.spacing[a] = 0.2 + 1.8 * unit(random);
    }
    g.direction = RandomDirection(random);
    const GridGeometry kept = ThroughFloat32(g);
    changed += CanonicalPlace(kept) != CanonicalPlace(g);
    bool corners = false; // the rival: origin and three far corners in steps of 0.01 mm
    for (int c = -1; c < 3; ++c)
    {
      glm::dvec3 index(0.0);
      if (c >= 0)
        index[c] = g.dims[c] - 1;
      corners |=
        glm::round(100.0 * g.IndexToWorld(index)) != glm::round(100.0 * kept.IndexToWorld(index));
    }
    cornersChanged += corners;
  }
  ::testing::Test::RecordProperty("oblique: changed of 100000", changed);
  ::testing::Test::RecordProperty("oblique: changed of 100000, corners of 0.01 mm", cornersChanged);
  // Expected: twelve roundings, each crossed by (mean float32 error) / step, 1e-5 to 1e-4.
  EXPECT_LE(changed, 50);
  EXPECT_GE(cornersChanged, 10 * changed);
}

TEST(VolumePlace, UprightVolumesAtRoundNumbersSurviveFloat32ButForOneIn2000)
{
  std::mt19937_64 random(3);
  int changed = 0;
  for (int n = 0; n < 50000; ++n)
  {
    GridGeometry g;
    for (int a = 0; a < 3; ++a)
    {
      g.dims[a] = 16 + static_cast<int>(random() % 500);
      g.spacing[a] = double(1 + random() % 40) / 20.0;         // 0.05, 0.1 .. 2 mm
      g.origin[a] = (double(random() % 6000) - 3000.0) / 10.0; // tenths
      g.direction[a] *= random() & 1 ? 1.0 : -1.0;
    }
    changed += CanonicalPlace(ThroughFloat32(g)) != CanonicalPlace(g);
  }
  ::testing::Test::RecordProperty("upright: changed of 50000", changed);
  EXPECT_LE(changed, 25);
}

TEST(VolumePlace, ScansAt45DegreesHaveOneOrderWhateverTheirStorage)
{
  for (int turn = 1; turn < 8; turn += 2)
  {
    const double angle = turn * glm::quarter_pi<double>();
    GridGeometry g{ { 5, 6, 7 }, { 1, 2, 3 }, { 0.5, 0.6, 0.7 } };
    g.direction = glm::dmat3(
      std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle), 0, 0, 0, 1);
    const auto place = CanonicalPlace(g);
    EXPECT_EQ(CanonicalPlace(ThroughFloat32(g)), place);
    std::vector<std::int16_t> samples(g.Size()), ignored;
    int axis[] = { 0, 1, 2 };
    do
      for (int turned = 0; turned < 8; ++turned)
        EXPECT_EQ(CanonicalPlace(Rearrange(g, samples, axis, turned, ignored)), place);
    while (std::next_permutation(axis, axis + 3));
  }
}

#if HASP_WITH_OPENSSL

class VolumeHash : public IOFixture
{
protected:
  template <typename T>
  static std::string Of(const GridGeometry& g, const std::vector<T>& samples)
  {
    return hasp::VolumeHash(hasp::GridView<const T>{ samples.data(), g });
  }
};

TEST_F(VolumeHash, AnyChangeOfASampleChangesIt)
{
  const GridGeometry g = this->Truth();
  auto samples = Samples(g);
  const std::string hash = Of(g, samples);
  EXPECT_EQ(hash.size(), 64U);
  for (std::size_t n = 0; n < samples.size(); n += 37)
  {
    samples[n] += 1;
    EXPECT_NE(Of(g, samples), hash) << n;
    samples[n] -= 1;
  }
  std::swap(samples[1], samples[2]);
  EXPECT_NE(Of(g, samples), hash);
  std::swap(samples[1], samples[2]);
  EXPECT_EQ(Of(g, samples), hash);
  for (std::size_t row = 0; row < samples.size(); row += 12) // left for right, in place
    std::reverse(samples.begin() + row, samples.begin() + row + 12);
  EXPECT_NE(Of(g, samples), hash);
}

TEST_F(VolumeHash, AllStorageOrdersHaveOneHash)
{
  GridGeometry g = this->Truth();
  const auto samples = Samples(g);
  const std::string hash = Of(g, samples);
  int axis[] = { 0, 1, 2 };
  do
    for (int turned = 0; turned < 8; ++turned)
    {
      std::vector<std::int16_t> other;
      const GridGeometry order = Rearrange(g, samples, axis, turned, other);
      EXPECT_EQ(Of(order, other), hash) << axis[0] << axis[1] << axis[2] << " " << turned;
      EXPECT_EQ(Of(order, std::vector<float>(other.begin(), other.end())), hash);
    }
  while (std::next_permutation(axis, axis + 3));
}

TEST_F(VolumeHash, TheNumberTypeDoesNotMatterTheValueDoes)
{
  const GridGeometry g{ { 3, 2, 2 }, {}, { 1, 1, 1 } };
  const std::vector<std::uint8_t> bytes{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 255 };
  const std::string hash = Of(g, bytes);
  EXPECT_EQ(Of(g, std::vector<std::int16_t>(bytes.begin(), bytes.end())), hash);
  EXPECT_EQ(Of(g, std::vector<std::uint16_t>(bytes.begin(), bytes.end())), hash);
  std::vector<float> real(bytes.begin(), bytes.end());
  EXPECT_EQ(Of(g, real), hash);
  real[0] = -0.0F;
  EXPECT_EQ(Of(g, real), hash);
  real[0] = std::numeric_limits<float>::denorm_min();
  EXPECT_NE(Of(g, real), hash);
  std::vector<std::uint16_t> large(bytes.begin(), bytes.end());
  large[3] = 40000; // no int16: both as float32
  EXPECT_EQ(Of(g, large), Of(g, std::vector<float>(large.begin(), large.end())));
  real.assign(large.begin(), large.end());
  const std::string positive = Of(g, real);
  real[0] = -0.0F;
  EXPECT_EQ(Of(g, real), positive);
}

#else

TEST(VolumeHash, BuildWithoutOpenSSLHasNone)
{
  const std::vector<std::int16_t> samples(8);
  EXPECT_EQ(hasp::VolumeHash(hasp::GridView<const std::int16_t>{
              samples.data(), { { 2, 2, 2 }, {}, { 1, 1, 1 } } }),
    "");
}

#endif

} // namespace
