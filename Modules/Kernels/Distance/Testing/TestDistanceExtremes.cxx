// Stiff and extreme input for all distance transforms: long lines, long voxels, nothing,
// everything, one voxel, noise, small and large spacings.
#include "Distance/AntiAliasedEuclidean.h"
#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Testing/AnalyticCoverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using Field = std::vector<float>;

constexpr float Infinity = std::numeric_limits<float>::infinity();

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing = glm::dvec3(1))
{
  return { dims, -0.5 * glm::dvec3(dims) * spacing, spacing, glm::dmat3(1) };
}

struct Transform
{
  const char* name;
  Field (*run)(const hasp::GridGeometry&, const Field&);
  bool asCoverage = false;   ///< refuses noise
  bool band = false;         ///< knows four voxels
  bool anyFaceAlike = false; ///< takes half the shortest side to each face, whichever it is
};
const Transform Transforms[] = {
  { "chamfer",
    [](const hasp::GridGeometry& g, const Field& c) { return hasp::ChamferDistance(g, c); } },
  { .name = "propagation",
    .run = [](const hasp::GridGeometry& g, const Field& c)
    { return hasp::AntiAliasedEuclideanDistance(g, c); },
    .anyFaceAlike = true },
  { .name = "guides'",
    .run = [](const hasp::GridGeometry& g, const Field& c) { return hasp::CoverageDistance(g, c); },
    .asCoverage = true },
  { .name = "guides' band",
    .run = [](const hasp::GridGeometry& g, const Field& c)
    { return hasp::CoverageDistanceBand(g, c); },
    .asCoverage = true,
    .band = true },
  { "grey",
    [](const hasp::GridGeometry& g, const Field& c) {
      return hasp::GreyDistance(hasp::GridView<const float>{ c.data(), g }, 0.5);
    } },
  { .name = "exact",
    .run =
      [](const hasp::GridGeometry& g, const Field& c)
    {
      std::vector<std::uint8_t> inside(c.size());
      std::transform(c.begin(), c.end(), inside.begin(), [](float a) { return a >= 0.5F; });
      return hasp::SignedEuclideanDistance(g, inside);
    },
    .anyFaceAlike = true },
};

TEST(DistanceExtremes, LinesOf2048DoNotOverflowWhicheverAxis)
{
  for (const double spacing : { 0.05, 1.0, 5.0 })
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 dims(3);
      dims[axis] = 2048;
      const auto grid = Grid(dims, glm::dvec3(spacing));
      const std::size_t stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
      Field coverage(grid.Size());
      for (std::size_t v = 0; v < coverage.size(); ++v) // until index 9.5
        coverage[v] = v / stride % dims[axis] < 10 ? 1.0F : 0.0F;
      for (const Transform& t : Transforms)
      {
        const Field d = t.run(grid, coverage);
        for (std::size_t v = 0; v < d.size(); ++v)
        {
          double truth = (double(v / stride % dims[axis]) - 9.5) * spacing;
          if (t.band)
            truth = glm::clamp(truth, -4.0 * spacing, 4.0 * spacing);
          // A rounding each step, where distances are added up; squares of floats elsewhere.
          const double steps = std::abs(truth) / spacing;
          ASSERT_NEAR(d[v], truth, (steps + 30.0) * 6e-8 * std::abs(truth) + 2e-5 * spacing)
            << t.name << " axis " << axis << " spacing " << spacing << " at " << v;
        }
      }
    }
}

TEST(DistanceExtremes, VoxelsAHundredTimesLongerStillGivePlanes)
{
  for (int axis = 0; axis < 3; ++axis)
    for (int longest = 0; longest < 3; ++longest)
    {
      glm::dvec3 spacing(0.05);
      spacing[longest] = 5.0;
      const auto grid = Grid({ 11, 12, 13 }, spacing);
      const std::size_t strides[] = { 1, 11, 132 };
      Field coverage(grid.Size());
      for (std::size_t v = 0; v < coverage.size(); ++v) // until index 4.5
        coverage[v] = v / strides[axis] % grid.dims[axis] < 5 ? 1.0F : 0.0F;
      for (const Transform& t : Transforms)
      {
        const Field d = t.run(grid, coverage);
        for (std::size_t v = 0; v < d.size(); ++v)
        {
          const double steps = double(v / strides[axis] % grid.dims[axis]) - 4.5;
          double truth = steps * spacing[axis];
          if (t.band)
            truth = glm::clamp(truth, -0.2, 0.2);
          ASSERT_EQ(d[v] < 0, truth < 0) << t.name;
          // The two that take half the shortest side for a face do so whichever face it is.
          const double off = t.anyFaceAlike ? 0.5 * (spacing[axis] - 0.05) : 0.0;
          ASSERT_NEAR(std::abs(d[v]), std::abs(truth) + off, 2e-5 * spacing[axis] * 20 + off * 1e-5)
            << t.name << " across " << axis << " long " << longest << " at " << v;
        }
      }
    }
}

TEST(DistanceExtremes, NothingIsInfinitelyFarAndEverythingInfinitelyDeep)
{
  for (const glm::ivec3& dims : { glm::ivec3(9, 8, 7), glm::ivec3(1), glm::ivec3(1, 40, 1) })
    for (const float all : { 0.0F, 1.0F })
    {
      const auto grid = Grid(dims, { 0.05, 5, 1 });
      for (const Transform& t : Transforms)
        for (const float d : t.run(grid, Field(grid.Size(), all)))
          if (t.band)
            ASSERT_TRUE(std::abs(d) >= 0.2F * 0.999F && (d < 0) == (all > 0)) << t.name;
          else
            ASSERT_EQ(d, all > 0 ? -Infinity : Infinity) << t.name;
    }
}

TEST(DistanceExtremes, OneVoxelIsSeenFromEverywhere)
{
  for (const float share : { 0.5F, 1.0F })
    for (const glm::ivec3& where : { glm::ivec3(0), glm::ivec3(8, 7, 6), glm::ivec3(16, 14, 12) })
    {
      const auto grid = Grid({ 17, 15, 13 });
      Field coverage(grid.Size(), 0.0F);
      coverage[(where.z * 15 + where.y) * 17 + where.x] = share;
      for (const Transform& t : Transforms)
      {
        const Field d = t.run(grid, coverage);
        for (std::size_t v = 0; v < d.size(); ++v)
        {
          const glm::ivec3 p(v % 17, v / 17 % 15, v / 255);
          double far = glm::distance(glm::dvec3(p), glm::dvec3(where));
          if (t.band)
            far = std::min(far, 4.0);
          // Half a voxel's diagonal from its centre at most; that the plane of a face answers for
          // all of it is worth a little more. <3,4,5> errs by a tenth.
          const double off = 1.0 + 0.11 * far;
          ASSERT_TRUE(std::abs(d[v] - far) <= off) << t.name << " " << far << " " << d[v];
        }
      }
    }
}

TEST(DistanceExtremes, NoiseIsRefusedAsCoverageAndMeasuredOtherwise)
{
  const auto grid = Grid(glm::ivec3(24), { 0.3, 0.3, 0.7 });
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0, 1);
  Field noise(grid.Size());
  for (float& a : noise)
    a = any(random);
  EXPECT_THROW(hasp::CoverageDistance(grid, noise), std::invalid_argument);
  EXPECT_THROW(hasp::CoverageDistanceBand(grid, noise), std::invalid_argument);
  // All others: finite, the sign of the voxel's own value but where elements next to it disagree,
  // and no farther than the next voxel of another kind, which is never five voxels away.
  for (const Transform& t : Transforms)
  {
    if (t.asCoverage)
      continue;
    for (const float d : t.run(grid, noise))
      ASSERT_TRUE(std::abs(d) < 1.5F) << t.name << " " << d;
  }
  // Of a binary one, each voxel's own kind decides, in the guides' transform, too.
  Field binary(noise);
  for (float& a : binary)
    a = a < 0.5F ? 0.0F : 1.0F;
  for (const Transform& t : Transforms)
    for (const float d : t.run(grid, binary))
      ASSERT_TRUE(std::abs(d) < 1.5F) << t.name << " " << d;
}

TEST(DistanceExtremes, SpacingsOf5And005MillimetresDifferByAFactorAlone)
{
  const auto fine = Grid(glm::ivec3(40), glm::dvec3(0.05)), unit = Grid(glm::ivec3(40)),
             coarse = Grid(glm::ivec3(40), glm::dvec3(5));
  const auto shape = hasp::AnalyticTorus({}, glm::normalize(glm::dvec3(1, 2, 2)), 10, 5.5);
  const Field coverage = hasp::AnalyticCoverage(shape, unit);
  for (const Transform& t : Transforms)
  {
    const Field f = t.run(fine, coverage), u = t.run(unit, coverage), c = t.run(coarse, coverage);
    for (std::size_t v = 0; v < u.size(); ++v)
    {
      // Rounding chooses among equals: of elements far away, which differ by a hundredth.
      ASSERT_NEAR(f[v] / 0.05, u[v], 2e-5) << t.name;
      ASSERT_NEAR(c[v] / 5.0, u[v], 2e-5) << t.name;
    }
  }
}

} // namespace
