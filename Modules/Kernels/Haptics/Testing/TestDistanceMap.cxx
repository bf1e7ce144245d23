#include "Haptics/DistanceMap.h"
#include "Haptics/Testing/SampledDistance.h"

#include "Grid/Trilinear.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace
{

using namespace hasp::testing;
using hasp::DistanceMap;
using hasp::GridGeometry;

constexpr float Nan = std::numeric_limits<float>::quiet_NaN();
constexpr float Infinity = std::numeric_limits<float>::infinity();

template <typename T>
T SampleOf(const hasp::DistanceMapView<T>& view, const glm::ivec3& block, const glm::ivec3& in)
{
  const int b = (block.z * view.blocks.y + block.y) * view.blocks.x + block.x;
  return view.samples[view.firstSample[b] + (in.z * view.Row + in.y) * view.Row + in.x];
}

std::size_t BytesOf(const DistanceMap& map, const char* resource)
{
  hasp::ResourceList list;
  map.ListResources(list);
  for (const hasp::ResourceUse& use : list)
    if (use.resource == resource)
      return use.bytes;
  ADD_FAILURE() << "no resource " << resource;
  return 0;
}

std::size_t Bricks(const DistanceMap& map)
{
  const glm::ivec3 blocks = map.View().blocks;
  const std::size_t tables = 12U * blocks.x * blocks.y * blocks.z;
  EXPECT_EQ((BytesOf(map, "distance map") - tables) % 1460U, 0U);
  return (BytesOf(map, "distance map") - tables) / 1460U;
}

TEST(DistanceMap, RefusesWhatItCannotBeMadeOf)
{
  const SampledDistance ball(Ball({}, 4.0), CubeGrid(12));
  const auto make = [&](const GridGeometry& g, double range, const glm::dvec3& origin = {}) {
    DistanceMap({ ball.samples.data(), g }, { range, origin, false });
  };
  EXPECT_THROW(
    make({ { 12, 12, 1 }, {}, glm::dvec3(1), glm::dmat3(1) }, 0.0), std::invalid_argument);
  EXPECT_THROW(
    make({ { 12, 12, 12 }, {}, glm::dvec3(0), glm::dmat3(1) }, 0.0), std::invalid_argument);
  for (const double range : { -1.0, 0.49, double(Nan), double(Infinity) })
    EXPECT_THROW(make(ball.geometry, range), std::invalid_argument) << range;
  EXPECT_THROW(make(ball.geometry, 0.0, { 0.0, Nan, 0.0 }), std::invalid_argument);
  EXPECT_NO_THROW(make(ball.geometry, 0.5));
  EXPECT_THROW(DistanceMap(ball.View()).Reference(), std::runtime_error);
}

TEST(DistanceMap, IsCancelledWhereverItIs)
{
  const SampledDistance ball(Ball({}, 9.0), CubeGrid(26));
  double last = -1.0;
  int calls = 0;
  DistanceMap(ball.View(), {},
    [&](double share)
    {
      EXPECT_GE(share, last);
      last = share;
      ++calls;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  ASSERT_GT(calls, 6);
  for (int stop = 0; stop < calls; ++stop)
  {
    int left = stop;
    EXPECT_THROW(DistanceMap(ball.View(), {}, [&](double) { return left-- > 0; }), hasp::Cancelled);
  }
}

TEST(DistanceMap, KnowsAHalfSpaceToAStep)
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  const SampledDistance half(HalfSpace({ 1.0, 0.5, -0.25 }, normal), SkewGrid({ 40, 30, 25 }));
  const DistanceMap map(half.View());
  EXPECT_DOUBLE_EQ(map.RangeMm(), 16.0 * 0.7);
  EXPECT_DOUBLE_EQ(map.SmallestSpacing(), 0.7);
  const double step = map.RangeMm() / 32767.0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> in(-7.0, 7.0);
  for (int n = 0; n < 2000; ++n)
  {
    const glm::dvec3 p{ in(random), in(random), in(random) };
    const double truth = glm::dot(p - glm::dvec3(1.0, 0.5, -0.25), normal);
    if (std::abs(truth) > map.RangeMm() - 3.0) // clamped samples are mixed in beyond
      continue;
    const DistanceMap::Sample sample = map.At(p);
    // Linear functions are interpolated exactly: half a step of rounding, and the float samples'.
    EXPECT_NEAR(sample.mm, truth, 0.5 * step + 2e-6);
    // Two samples half a step off at the most, over the smallest spacing, on each of three axes.
    EXPECT_LT(glm::length(sample.gradient - normal), std::sqrt(3.0) * (step + 4e-6) / 0.7);
  }
}

TEST(DistanceMap, KnowsABallOnASkewGrid)
{
  const double radius = 9.0;
  const SampledDistance ball(Ball({ 1.0, 0.5, 0.0 }, radius), SkewGrid({ 48, 34, 26 }));
  const DistanceMap map(ball.View(), { 6.0, {}, false });
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  double worst = 0.0;
  for (int n = 0; n < 3000; ++n)
  {
    const glm::dvec3 out =
      glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const double truth = 2.0 * normal(random);
    if (std::abs(truth) > 3.0)
      continue;
    const DistanceMap::Sample sample = map.At(glm::dvec3(1.0, 0.5, 0.0) + (radius + truth) * out);
    // Interpolation between samples h apart is off by h^2/8 times the second derivative on each
    // axis, which is at most the curvature: 1/(9 - 3 - 1 mm).
    const double bound = (0.7 * 0.7 + 1.1 * 1.1 + 1.6 * 1.6) / 8.0 / (radius - 4.0);
    EXPECT_NEAR(sample.mm, truth, bound);
    worst = std::max(worst, std::abs(sample.mm - truth));
    // The gradient's error is h/2 times the second derivative.
    EXPECT_LT(glm::length(sample.gradient - out), 0.5 * (0.7 + 1.1 + 1.6) / (radius - 4.0));
  }
  EXPECT_GT(worst, 0.001); // the truth was compared with something
}

/// Every sample of every block, by the view's own addressing, against the input.
template <typename T>
void ExpectSamples(
  const hasp::DistanceMapView<T>& view, const hasp::GridView<const float>& grid, double tolerance)
{
  const auto range = static_cast<double>(view.rangeMm);
  for (int z = 0; z < view.blocks.z; ++z)
    for (int y = 0; y < view.blocks.y; ++y)
      for (int x = 0; x < view.blocks.x; ++x)
        for (int n = 0; n < view.Slice * view.Row; ++n)
        {
          const glm::ivec3 in{ n % view.Row, n / view.Row % view.Row, n / view.Slice };
          const glm::ivec3 p = glm::ivec3(x, y, z) * view.Side + in;
          if (glm::any(glm::greaterThanEqual(p, grid.geometry.dims)))
            continue;
          const float d = grid(p.x, p.y, p.z);
          const double truth = std::isnan(d) ? range : std::clamp<double>(d, -range, range);
          const double stored = double(SampleOf(view, { x, y, z }, in)) * view.mmPerStep;
          ASSERT_NEAR(stored, truth, tolerance) << p.x << ' ' << p.y << ' ' << p.z;
        }
}

TEST(DistanceMap, HoldsEachSampleInEachBlockThatTouchesIt)
{
  for (const GridGeometry& g :
    { CubeGrid(26), SkewGrid({ 17, 9, 22 }), SkewGrid({ 2, 10, 8 }), SkewGrid({ 2, 2, 2 }) })
  {
    const SampledDistance torus(Torus({ 0, 0.6, 0.8 }, 6.0, 2.5), g);
    const DistanceMap map(torus.View(), { 2.0, {}, true });
    const auto view = map.View();
    EXPECT_EQ(view.blocks, (g.dims + 6) / 8);
    EXPECT_EQ(glm::ivec3(view.last), g.dims - 1);
    // Half a step, and what a float times a float is off.
    ExpectSamples(view, torus.View(), 0.5 * 2.0 / 32767.0 + 4e-7);
    ExpectSamples(map.Reference(), torus.View(), 0.0);
    for (int b = 0; b < view.blocks.x * view.blocks.y * view.blocks.z; ++b)
      EXPECT_EQ(map.Reference().firstSample[b], view.firstSample[b]);
  }
}

TEST(DistanceMap, TakesEveryFloatThereIs)
{
  SampledDistance field(Ball({}, 5.0), CubeGrid(20));
  std::mt19937 random(7);
  const float odd[] = { Nan, Infinity, -Infinity, 3e38F, -3e38F, 1e-40F, -0.0F };
  for (float& sample : field.samples)
    if (random() % 3 == 0)
      sample = odd[random() % 7];
  const DistanceMap map(field.View(), { 3.0, {}, true });
  ExpectSamples(map.View(), field.View(), 0.5 * 3.0 / 32767.0 + 4e-7);
  ExpectSamples(map.Reference(), field.View(), 0.0);
  EXPECT_TRUE(std::isfinite(map.View().steepest));
}

TEST(DistanceMap, WhollyNotANumberIsWhollyOutside)
{
  SampledDistance field(Ball({}, 5.0), CubeGrid(20));
  std::fill(field.samples.begin(), field.samples.end(), Nan);
  const DistanceMap map(field.View());
  EXPECT_EQ(map.At({ 0.1, 0.2, 0.3 }).mm, map.RangeMm());
  EXPECT_EQ(Bricks(map), 2U);
  EXPECT_EQ(map.View().steepest, 0.0F);
}

TEST(DistanceMap, AllOutsideOrAllInsideCostsTwoBricks)
{
  for (const float value : { 100.0F, -100.0F, Infinity, -Infinity })
  {
    SampledDistance field(Ball({}, 5.0), CubeGrid(33));
    std::fill(field.samples.begin(), field.samples.end(), value);
    const DistanceMap map(field.View());
    EXPECT_EQ(Bricks(map), 2U);
    const DistanceMap::Sample sample = map.At({ 3.3, 2.2, 1.1 });
    // -range may be one rounding of range / 32767 off.
    EXPECT_NEAR(sample.mm, value > 0 ? map.RangeMm() : -map.RangeMm(), 1e-14);
    EXPECT_LT(glm::length(sample.gradient), 1e-14);
    EXPECT_EQ(BytesOf(map, "distance map, float"), 0U);
  }
}

TEST(DistanceMap, HasBricksOnlyWhereTheBandIs)
{
  const SampledDistance ball(Ball({}, 40.0), CubeGrid(129));
  const DistanceMap map(ball.View(), { 4.0, {}, false });
  const auto view = map.View();
  std::size_t within = 0;
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
      {
        // Brute force over the block's samples.
        float least = Infinity, most = -Infinity;
        for (int k = 0; k <= 8; ++k)
          for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i)
            {
              const float d = ball.View()(8 * x + i, 8 * y + j, 8 * z + k);
              least = std::min(least, d);
              most = std::max(most, d);
            }
        const auto& range = view.unclamped[(z * 16 + y) * 16 + x];
        EXPECT_EQ(range.min, least);
        EXPECT_EQ(range.max, most);
        within += least < 4.0F && most > -4.0F ? 1 : 0;
      }
  EXPECT_EQ(Bricks(map), within + 2);
  EXPECT_LT(within, 1300U); // of 4096: a third, where a whole map would pay for all
}

TEST(DistanceMap, AnInt16PairAtTheLastSampleIsThere)
{
  const SampledDistance ball(Ball({}, 5.0), SkewGrid({ 20, 15, 11 }));
  const DistanceMap map(ball.View());
  const auto view = map.View();
  const std::size_t samples = Bricks(map) * view.BrickSamples;
  for (int b = 0; b < view.blocks.x * view.blocks.y * view.blocks.z; ++b)
  {
    // The address sanitizer looks at the second of each pair, too.
    const std::int16_t* pair = view.samples + view.firstSample[b] + view.Slice * view.Row - 1;
    EXPECT_EQ(pair[1], 0);
    EXPECT_LE(view.firstSample[b] + view.BrickSamples, static_cast<std::int32_t>(samples));
  }
}

TEST(DistanceMap, EndsWithItsGrid)
{
  for (const glm::ivec3& dims : { glm::ivec3(17, 9, 25), glm::ivec3(12, 14, 2), glm::ivec3(2) })
  {
    const GridGeometry g = SkewGrid(dims);
    const SampledDistance half(HalfSpace({}, g.direction[0]), g);
    const DistanceMap map(half.View(), { 20.0, {}, false });
    const glm::dvec3 last = dims - 1, middle = 0.5 * last;
    for (int a = 0; a < 3; ++a)
      for (const double end : { 0.0, last[a] })
      {
        glm::dvec3 in = middle, out = middle;
        in[a] = end + (end > 0.0 ? -1e-9 : 1e-9);
        out[a] = end + (end > 0.0 ? 1e-9 : -1e-9);
        const DistanceMap::Sample at = map.At(g.IndexToWorld(in));
        EXPECT_NEAR(at.mm, glm::dot(g.IndexToWorld(in), g.direction[0]), 20.0 / 32767.0);
        EXPECT_NEAR(glm::dot(at.gradient, g.direction[0]), 1.0, 0.01);
        EXPECT_EQ(map.At(g.IndexToWorld(out)).mm, 20.0);
        EXPECT_EQ(map.At(g.IndexToWorld(out)).gradient, glm::dvec3(0.0));
      }
    EXPECT_EQ(map.At({ 1e300, 0.0, 0.0 }).mm, 20.0);
    EXPECT_EQ(map.At(glm::dvec3(Nan)).mm, 20.0);
  }
}

TEST(DistanceMap, PlacesTheBodysOwnAxes)
{
  const glm::dvec3 origin{ 3.0, -8.0, 1200.0 };
  GridGeometry g = SkewGrid({ 20, 15, 11 });
  g.origin += origin;
  const SampledDistance ball(Ball(origin, 5.0), g);
  const DistanceMap map(ball.View(), { 0.0, origin, false });
  const auto view = map.View();
  for (const glm::vec3& p : { glm::vec3(0), glm::vec3(1, 2, 3), glm::vec3(-4, 0.5, 2) })
  {
    const glm::dvec3 index = view.indexOfOrigin + view.toIndex * p;
    // Floats of up to 20.
    EXPECT_LT(glm::length(index - g.WorldToIndex(origin + glm::dvec3(p))), 1e-5);
  }
  const glm::dvec3 gradient{ 0.3, -0.7, 0.2 };
  EXPECT_LT(glm::length(
              glm::dvec3(view.gradientToBody * glm::vec3(gradient)) - g.GradientToWorld(gradient)),
    1e-6);
}

TEST(DistanceMap, MeasuresItsSteepestSlope)
{
  const GridGeometry g = SkewGrid({ 19, 12, 14 });
  SampledDistance field(Ball({}, 5.0), g);
  std::mt19937 random(8);
  std::uniform_real_distribution<float> in(-3.0F, 3.0F);
  for (float& sample : field.samples)
    sample = in(random);
  const auto grid = field.View();
  double most = 0.0, inside = 0.0;
  for (int k = 0; k < 13; ++k)
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 18; ++i)
      {
        const auto corners = hasp::CellCorners(grid, { i, j, k });
        for (int c = 0; c < 8; ++c)
          most = std::max(most, glm::length(g.GradientToWorld(hasp::TrilinearGradient(
                                  corners, { c & 1, c >> 1 & 1, c >> 2 }))));
        for (int n = 0; n < 4; ++n)
        {
          const glm::dvec3 t = 0.5 + glm::dvec3(in(random), in(random), in(random)) / 6.0;
          inside =
            std::max(inside, glm::length(g.GradientToWorld(hasp::TrilinearGradient(corners, t))));
        }
      }
  EXPECT_NEAR(DistanceMap(grid).View().steepest, most, 1e-5 * most);
  EXPECT_LE(inside, most);

  // A ball's distance is not that steep outside, where it bends by 1/9 a mm; around its middle,
  // which is deep inside, it is.
  const SampledDistance ball(Ball({}, 9.0), CubeGrid(33));
  EXPECT_GT(DistanceMap(ball.View()).View().steepest, 1.0);
  EXPECT_LT(DistanceMap(ball.View()).View().steepest, 1.1);
  const SampledDistance hollow(
    [](const glm::dvec3& p) { return 9.0 - glm::length(p); }, CubeGrid(33));
  EXPECT_NEAR(DistanceMap(hollow.View()).View().steepest, std::sqrt(3.0), 1e-6);
}

} // namespace
