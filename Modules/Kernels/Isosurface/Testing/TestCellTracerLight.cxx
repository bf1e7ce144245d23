// Ambient occlusion and shadows against closed forms.
#include "Isosurface/Testing/TracedVolume.h"

#include <glm/gtc/constants.hpp>

#include <functional>

namespace
{

using hasp::testing::TracedVolume;
constexpr double Pi = glm::pi<double>();

/// A float volume of a field given at world positions, > 0 inside.
TracedVolume<float> Solid(
  const hasp::GridGeometry& g, const std::function<double(const glm::dvec3&)>& field)
{
  std::vector<float> samples;
  samples.reserve(g.Size());
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        samples.push_back(static_cast<float>(field(g.IndexToWorld({ i, j, k }))));
  return { std::move(samples), g, 0.0 };
}

hasp::GridGeometry Grid(const glm::ivec3& dims, const glm::dvec3& spacing)
{
  return { dims, {}, spacing, glm::dmat3(1) };
}

/// Straight down on the world position x, y.
std::optional<hasp::CellHit> Down(const TracedVolume<float>& volume, double x, double y)
{
  const hasp::GridGeometry& g = volume.view.geometry;
  const glm::dvec3 from = g.WorldToIndex({ x, y, 0.0 });
  return volume.tracer.Trace({ { from.x, from.y, g.dims.z }, { 0, 0, -1 } });
}

TEST(CellTracerLight, OpenPlaneIsFullyOpen)
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.2, 0.9));
  for (const glm::dvec3& spacing : { glm::dvec3(1), glm::dvec3(0.4, 0.9, 2.0) })
  {
    const hasp::GridGeometry g = Grid({ 40, 40, 40 }, spacing);
    const glm::dvec3 middle = g.IndexToWorld({ 19.3, 19.6, 19.1 });
    const auto plane = Solid(g, [&](const glm::dvec3& p) { return glm::dot(middle - p, normal); });
    int hits = 0;
    for (unsigned n = 0; n < 400; ++n)
      if (const auto hit =
            Down(plane, (3 + n % 20 * 1.7) * spacing.x, (3 + n / 20 * 1.6) * spacing.y))
      {
        ++hits;
        ASSERT_EQ(plane.tracer.AmbientOcclusion(*hit, { 64, 1e9 }, n), 1.0F) << n;
        ASSERT_EQ(plane.tracer.Light(*hit, { normal, 0.3, 64 }, n), 1.0F) << n;
        ASSERT_EQ(plane.tracer.Light(*hit, { -normal }, n), 0.0F) << "the surface shades itself";
      }
    EXPECT_GT(hits, 200);
  }
}

TEST(CellTracerLight, ClosedCavityIsFullyDark)
{
  // From within a sphere every way out is blocked: one leak among the rays would show.
  const hasp::GridGeometry g = Grid({ 33, 33, 33 }, { 1, 0.7, 1.3 });
  const glm::dvec3 middle = g.IndexToWorld({ 16, 16, 16 });
  const auto ball = Solid(g, [&](const glm::dvec3& p) { return 9.0 - glm::distance(p, middle); });
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (unsigned n = 0; n < 2000; ++n)
  {
    const glm::dvec3 d(normal(random), normal(random), normal(random));
    const auto hit = ball.tracer.Trace({ { 16, 16, 16 }, d });
    ASSERT_TRUE(hit && hit->fromInside) << n;
    ASSERT_EQ(ball.tracer.AmbientOcclusion(*hit, { 32, 1e9 }, n), 0.0F) << n;
    // From outside the ball is convex: trilinear patches of a curved surface bulge by less than a
    // hundredth of a voxel, so that few rays are caught.
    const auto outer = ball.tracer.Trace({ glm::dvec3(16) + 40.0 * glm::normalize(d), -d });
    ASSERT_TRUE(outer && !outer->fromInside) << n;
    ASSERT_GT(ball.tracer.AmbientOcclusion(*outer, { 32, 1e9 }, n), 0.9F) << n;
  }
}

TEST(CellTracerLight, WallWithinReachMatchesTheClosedForm)
{
  // A floor beside a tall, long wall `a` away; what is farther than r does not count.
  // Cosine-weighted directions are even over the unit disc, and those that meet the wall in time
  // fill the segment beyond a / r of its middle.
  const hasp::GridGeometry g = Grid({ 60, 70, 60 }, { 0.5, 0.5, 0.5 });
  const auto corner = Solid(g, [](const glm::dvec3& p) { return std::max(5.0 - p.z, 6.0 - p.x); });
  const double reach = 12.0;
  for (const double a : { 2.0, 4.0, 7.0, 11.0 })
  {
    const auto hit = Down(corner, 6.0 + a, 17.2);
    ASSERT_TRUE(hit);
    const double c = a / reach;
    const double expected = 1.0 - (std::acos(c) - c * std::sqrt(1 - c * c)) / Pi;
    // 4096 even points: 0.003; the corner itself is bevelled by half a voxel: as much at a = 2.
    EXPECT_NEAR(corner.tracer.AmbientOcclusion(*hit, { 4096, reach }, 7), expected, 0.006) << a;
  }
  const auto far = Down(corner, 6.0 + 12.5, 17.2);
  ASSERT_TRUE(far);
  EXPECT_EQ(corner.tracer.AmbientOcclusion(*far, { 256, reach }, 7), 1.0F);
}

TEST(CellTracerLight, BowlMatchesTheClosedForm)
{
  // At the bottom of a bowl the sky is a disc of half angle w: sin^2 w of the cosine-weighted
  // light.
  const hasp::GridGeometry g = Grid({ 49, 49, 49 }, { 1, 1, 1 });
  const glm::dvec3 middle(24, 24, 30);
  for (const double rim : { 30.0, 20.0 }) // half a sphere; less of one
  {
    const auto bowl = Solid(
      g, [&](const glm::dvec3& p) { return std::min(glm::distance(p, middle) - 20.0, rim - p.z); });
    const auto hit = Down(bowl, 24.0, 24.0);
    ASSERT_TRUE(hit);
    const double height = rim - 10.0, radius2 = 400.0 - (rim - 30.0) * (rim - 30.0);
    const double expected = radius2 / (radius2 + height * height);
    // The rim is bevelled by up to a voxel of its 20: 0.02 of the angle.
    EXPECT_NEAR(bowl.tracer.AmbientOcclusion(*hit, { 4096, 1e9 }, 3), expected, 0.02) << rim;
  }
}

TEST(CellTracerLight, SphereCastsTheRightHardShadow)
{
  const hasp::GridGeometry g = Grid({ 64, 64, 64 }, { 1, 1, 1 });
  const glm::dvec3 middle(30, 32, 30), light = glm::normalize(glm::dvec3(-0.4, 0.3, 1.0));
  constexpr double radius = 9.0;
  const auto scene = Solid(g,
    [&](const glm::dvec3& p) { return std::max(10.3 - p.z, radius - glm::distance(p, middle)); });
  int shaded = 0, lit = 0;
  for (int j = 2; j < 62; ++j)
    for (int i = 2; i < 62; ++i)
    {
      // From below the ball, upwards past the floor's plane nothing stands: start between the two.
      const auto hit = scene.tracer.Trace({ { i + 0.31, j + 0.57, 15 }, { 0, 0, -1 } });
      ASSERT_TRUE(hit && !hit->fromInside);
      const glm::dvec3 p = hit->Position();
      const double off = glm::length(glm::cross(p - middle, light));
      if (std::abs(off - radius) < 0.1) // the sampled ball is a few hundredths smaller
        continue;
      const bool shade = off < radius;
      ASSERT_EQ(scene.tracer.Light(*hit, { light }), shade ? 0.0F : 1.0F) << i << " " << j;
      ASSERT_EQ(scene.tracer.Light(*hit, { light, 0.0, 1, 4.0 }), 1.0F) << "the light hangs lower";
      ++(shade ? shaded : lit);
    }
  EXPECT_GT(shaded, 200);
  EXPECT_GT(lit, 2000);
}

TEST(CellTracerLight, ManyHitsSeeWhatEachSees)
{
  const hasp::GridGeometry g = Grid({ 40, 40, 40 }, { 0.7, 1.1, 0.9 });
  const auto scene = Solid(g, [](const glm::dvec3& p)
    { return std::sin(0.5 * p.x) + std::sin(0.4 * p.y) + std::sin(0.45 * p.z); });
  std::vector<hasp::CellHit> hits;
  for (int n = 0; n < 4000; ++n)
  {
    const glm::dvec3 at(0.31 + n % 63 * 0.61, 0.17 + n / 63 * 0.6, n % 5 == 0 ? 17.3 : 39.0);
    if (const auto hit = scene.tracer.Trace({ at, { 0.01, 0.02, n % 5 == 1 ? -1.0 : -0.8 } }))
      hits.push_back(*hit);
  }
  ASSERT_GT(hits.size(), 2000U);
  for (const glm::dvec4& light : { glm::dvec4(0.3, -0.2, 0.9, 0.0), glm::dvec4(9, 20, 30, 1) })
  {
    std::size_t lit = 0, count = 1;
    for (std::size_t from = 0; from + count <= hits.size(); from += count, count = count % 16 + 1)
    {
      const std::span<const hasp::CellHit> some(hits.data() + from, count);
      const std::uint32_t seen = scene.tracer.Sees(some, light);
      for (std::size_t n = 0; n < count; ++n)
      {
        glm::dvec3 way(light);
        double distance = 1e300;
        if (light.w != 0.0)
          distance = glm::length(way -= g.IndexToWorld(some[n].Position()));
        const bool sees = scene.tracer.Light(some[n], { way, 0.0, 1, distance }) > 0.0F;
        ASSERT_EQ((seen >> n & 1U) != 0, sees) << from << " + " << n;
        lit += sees;
      }
      ASSERT_EQ(std::uint64_t(seen) >> count, 0U);
    }
    EXPECT_GT(lit, hits.size() / 10);
    EXPECT_LT(lit, hits.size() * 9 / 10);
  }
  EXPECT_EQ(scene.tracer.Sees({}, { 0, 0, 1, 0 }), 0U);
  const std::span<const hasp::CellHit> many(hits.data(), 17);
  EXPECT_THROW(scene.tracer.Sees(many, { 0, 0, 1, 0 }), std::invalid_argument);
  EXPECT_THROW(scene.tracer.Sees(many.first(1), glm::dvec4(0)), std::invalid_argument);
}

TEST(CellTracerLight, SoftShadowOfAnEdgeMatchesTheClosedForm)
{
  // The top edge of a long wall hides the part of a small disc of light below it: a segment of a
  // circle.
  const hasp::GridGeometry g = Grid({ 64, 90, 64 }, { 1, 1, 1 });
  const auto corner = Solid(
    g, [](const glm::dvec3& p) { return std::max(10.0 - p.z, std::min(20.5 - p.x, 30.5 - p.z)); });
  const double halfAngle = 0.1;
  for (const double offset :
    { -1.5, -0.6, 0.0, 0.5, 1.5 }) // of the light's middle over the edge, in half angles
  {
    const auto hit = Down(corner, 36.2, 45.3);
    ASSERT_TRUE(hit);
    const glm::dvec3 p = hit->Position(), edge(20.5, p.y, 30.5);
    const double angle = std::atan2(edge.z - p.z, p.x - edge.x) + offset * halfAngle;
    const glm::dvec3 light(-std::cos(angle), 0, std::sin(angle));
    const double h = std::clamp(offset, -1.0, 1.0);
    const double expected = 1.0 - (std::acos(h) - h * std::sqrt(1 - h * h)) / Pi;
    // The edge is bevelled by at most 0.5 voxel at 26 voxels: a fifth of the half angle, most of it
    // gone where the disc is cut near its rim.
    EXPECT_NEAR(corner.tracer.Light(*hit, { light, halfAngle, 1024 }, 11), expected, 0.12)
      << offset;
    if (std::abs(offset) > 1.0)
    {
      EXPECT_EQ(corner.tracer.Light(*hit, { light, halfAngle, 256 }, 5), offset > 0 ? 1.0F : 0.0F);
    }
  }
}

TEST(CellTracerLight, SameSeedSameRaysAndRangesAreChecked)
{
  const hasp::GridGeometry g = Grid({ 30, 30, 30 }, { 1, 1, 1 });
  const auto corner = Solid(g, [](const glm::dvec3& p) { return std::max(5.0 - p.z, 6.0 - p.x); });
  const auto hit = Down(corner, 9.0, 15.0);
  ASSERT_TRUE(hit);
  const auto open = [&](unsigned seed) {
    return corner.tracer.AmbientOcclusion(*hit, { 16, 9 }, seed);
  };
  EXPECT_EQ(open(5), open(5));
  bool differs = false;
  for (unsigned seed = 0; seed < 20; ++seed)
    differs |= open(seed) != open(5);
  EXPECT_TRUE(differs);
  EXPECT_THROW(corner.tracer.AmbientOcclusion(*hit, { 0, 9 }), std::invalid_argument);
  EXPECT_THROW(corner.tracer.AmbientOcclusion(*hit, { 4, 0 }), std::invalid_argument);
  EXPECT_THROW(corner.tracer.Light(*hit, { glm::dvec3(0) }), std::invalid_argument);
  EXPECT_THROW(corner.tracer.Light(*hit, { { 0, 0, 1 }, 2.0 }), std::invalid_argument);
  EXPECT_THROW(corner.tracer.Light(*hit, { { 0, 0, 1 }, 0.1, 0 }), std::invalid_argument);
}

} // namespace
