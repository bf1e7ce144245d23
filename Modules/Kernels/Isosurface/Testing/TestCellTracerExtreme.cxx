// What breaks ray tracers: rays along faces, edges and corners, extreme samples, spacings and
// shapes.
#include "Isosurface/RayCaster.h"
#include "Isosurface/Testing/TracedVolume.h"

#include <limits>

namespace
{

using namespace hasp::testing;
constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename T>
TracedVolume<T> Filled(const glm::ivec3& dims, double iso, const auto& value)
{
  const hasp::GridGeometry g{ dims, {}, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<T> samples;
  samples.reserve(g.Size());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        samples.push_back(static_cast<T>(value(i, j, k)));
  return { std::move(samples), g, iso };
}

double DistanceToMiddle(int i, int j, int k, double middle)
{
  return glm::length(glm::dvec3(i, j, k) - middle);
}

/// Rays through lattice points, along axes, in faces and along edges: all that rounding has not
/// moved.
TEST(CellTracerExtreme, LatticeRaysMeetNoiseWhereTruthDoes)
{
  const auto scene = Noise<std::int16_t>({ 19, 19, 19 }, 11);
  std::mt19937 random(12);
  std::uniform_int_distribution<int> step(-2, 2), halves(0, 36);
  int hits = 0;
  for (int n = 0; n < 40000; ++n)
  {
    const glm::dvec3 origin = 0.5 * glm::dvec3(halves(random), halves(random), halves(random));
    const glm::ivec3 d(step(random), step(random), step(random));
    if (d == glm::ivec3(0))
      continue;
    const glm::dvec3 unit = glm::normalize(glm::dvec3(d));
    const auto truth = TraceTruth(scene.view, scene.isovalue, origin, unit, -1e3, 1e3);
    const auto hit = scene.tracer.Trace({ origin, unit, -1e3, 1e3 });
    if (truth.tangency < Undecided)
      continue;
    ASSERT_EQ(hit.has_value(), truth.t.has_value()) << n;
    if (!hit)
      continue;
    ASSERT_NEAR(hit->t, *truth.t, HitTolerance) << n;
    ++hits;
  }
  EXPECT_GT(hits, 20000);
}

TEST(CellTracerExtreme, RaysInTheOutermostFacesAndEdgesCount)
{
  // Solid for x >= 4.5: every ray along +x meets it there, on each border of the volume too.
  const auto half =
    Filled<std::int16_t>({ 10, 10, 10 }, 0.5, [](int i, int, int) { return i >= 5; });
  for (const double y : { 0.0, 3.0, 8.0, 9.0, -1e-10, 9.0 + 1e-10 })
    for (const double z : { 0.0, 8.0, 9.0 })
    {
      const auto hit = half.tracer.Trace({ { -5, y, z }, { 1, 0, 0 } });
      ASSERT_TRUE(hit) << y << " " << z;
      EXPECT_NEAR(hit->t, 9.5, 1e-6);
      EXPECT_TRUE(half.tracer.Trace({ { -5, y, z }, { 1, -0.0, -0.0 } })) << y << " " << z;
      EXPECT_TRUE(half.tracer.Trace({ { 14, y, z }, { -1, 0, 0 } })) << y << " " << z;
    }
  EXPECT_FALSE(half.tracer.Trace({ { -5, 9.1, 3 }, { 1, 0, 0 } }));
  // All but parallel: an axis is crossed once in 1e12 voxels, or never.
  for (const double small : { 1e-7, 1e-12, 1e-30, 1e-200, 5e-324 })
    for (const double sign : { -1.0, 1.0 })
      for (const double y : { 3.0, 3.5, 4.0, 8.0 })
        EXPECT_TRUE(half.tracer.Trace({ { 0, y, 5 }, { 1, sign * small, -sign * small } }))
          << small << " " << y;
}

TEST(CellTracerExtreme, DirectionsOfAnyLength)
{
  const auto half = Filled<float>({ 10, 10, 10 }, 4.25, [](int i, int, int) { return i; });
  for (const double length : { 1e-300, 1e-100, 1e-6, 1.0, 1e6, 1e100, 1e300 })
  {
    const auto hit = half.tracer.Trace({ { 1, 5.2, 5.3 }, glm::dvec3(length, 0, 0) });
    ASSERT_TRUE(hit) << length;
    EXPECT_NEAR(hit->t * length, 3.25, 1e-6);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { 0, 0, 0 } }));
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { nan, 0, 1 } }));
  EXPECT_FALSE(half.tracer.Trace({ { nan, 5, 5 }, { 1, 0, 0 } }));
  EXPECT_FALSE(half.tracer.Trace({ { Infinity, 5, 5 }, { -1, 0, 0 } }));
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { Infinity, 0, 0 } }));
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { 1, 0, 0 }, nan, 5 }));
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { 1, 0, 0 }, 0, nan }));
  EXPECT_FALSE(half.tracer.Trace({ { 1, 5, 5 }, { 1, 0, 0 }, 5, 2 }));
}

TEST(CellTracerExtreme, EyeFarAwayIsAsGoodAsANearOne)
{
  const auto scene = Noise<std::int16_t>({ 30, 30, 30 }, 13);
  RandomRays next({ 30, 30, 30 }, 14);
  int hits = 0;
  for (int n = 0; n < 5000; ++n)
  {
    const hasp::CellRay near = next.Next();
    const auto truth =
      TraceTruth(scene.view, scene.isovalue, near.origin, near.direction, -100, 100);
    if (truth.tangency < 1e-5) // moved by 1e-10 voxel: as wide a band as the noise is steep
      continue;
    for (const double away : { 1e3, 1e6, 1e8 })
    {
      const auto hit = scene.tracer.Trace({ near.origin - away * near.direction, near.direction });
      ASSERT_EQ(hit.has_value(), truth.t.has_value()) << n << " " << away;
      if (hit)
      {
        ASSERT_NEAR(hit->t - away, *truth.t, HitTolerance) << n << " " << away;
      }
    }
    hits += truth.t.has_value();
  }
  EXPECT_GT(hits, 1000);
}

TEST(CellTracerExtreme, RaysThatBeginInsideSeeTheOtherSide)
{
  const auto ball = Filled<float>(
    { 24, 24, 24 }, 0.0, [](int i, int j, int k) { return 8.0 - DistanceToMiddle(i, j, k, 11.5); });
  std::mt19937 random(15);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 50000; ++n)
  {
    const auto hit =
      ball.tracer.Trace({ glm::dvec3(11.5), { normal(random), normal(random), normal(random) } });
    ASSERT_TRUE(hit) << "no ray may slip out, ray " << n;
    ASSERT_TRUE(hit->fromInside);
    ASSERT_NEAR(glm::distance(hit->Position(), glm::dvec3(11.5)), 8.0, 0.1);
  }
}

TEST(CellTracerExtreme, TangentRaysNeverCrashAndDecideOutsideTheBand)
{
  const auto ball = Filled<float>(
    { 24, 24, 24 }, 0.0, [](int i, int j, int k) { return 8.0 - DistanceToMiddle(i, j, k, 11.5); });
  std::mt19937 random(16);
  std::uniform_real_distribution<double> offset(-1e-4, 1e-4), along(6.0, 17.0);
  int decided = 0;
  for (int n = 0; n < 5000; ++n)
  {
    // A ray in a plane that touches the sampled ball near its top: found by sampling the profile
    // there.
    const double y = along(random);
    const auto down = ball.tracer.Trace({ { 11.5, y, 30 }, { 0, 0, -1 } });
    if (!down)
      continue;
    const hasp::CellRay ray{ { -5, y, down->Position().z + offset(random) }, { 1, 0, 0 } };
    const auto truth = TraceTruth(ball.view, 0.0F, ray.origin, ray.direction, 0, 100);
    const auto hit = ball.tracer.Trace(ray);
    if (truth.tangency < Undecided)
      continue;
    ++decided;
    ASSERT_EQ(hit.has_value(), truth.t.has_value()) << n << " " << truth.tangency;
    if (hit)
    {
      ASSERT_NEAR(hit->t, *truth.t, HitTolerance) << n << " " << truth.tangency;
    }
  }
  EXPECT_GT(decided, 2500);
}

TEST(CellTracerExtreme, EveryCellActiveNoneActiveThinVolumes)
{
  const auto checker =
    Filled<std::int16_t>({ 20, 17, 9 }, 0.5, [](int i, int j, int k) { return (i + j + k) & 1; });
  EXPECT_EQ(checker.cells->Count(), 19U * 16U * 8U);
  ExpectTruth(checker, 5000, 41, 5e-3); // saddles through 0 in every cell
  const auto none = Filled<std::int16_t>({ 20, 17, 9 }, 0.5, [](int, int, int) { return 1; });
  EXPECT_EQ(none.cells->Count(), 0U);
  EXPECT_FALSE(none.tracer.Trace({ { -1, 5, 5 }, { 1, 0, 0 } }));
  EXPECT_FALSE(none.tracer.Occluded({ { -1, 5, 5 }, { 1, 0, 0 } }));
  for (const glm::ivec3& dims :
    { glm::ivec3(2, 300, 40), glm::ivec3(300, 2, 2), glm::ivec3(2, 2, 2) })
    ExpectTruth(Noise<std::int16_t>(dims, 17), 4000, 42);
  const auto flat = Noise<std::int16_t>({ 1, 30, 30 }, 18); // no cells at all
  EXPECT_FALSE(flat.tracer.Trace({ { -1, 5, 5 }, { 1, 0, 0 } }));
}

TEST(CellTracerExtreme, SamplesAtTheLimits)
{
  std::mt19937 random(19);
  std::uniform_int_distribution<int> two(0, 1), full(-32768, 32767);
  ExpectTruth(Filled<std::int16_t>(
                { 15, 15, 15 }, -0.5, [&](int, int, int) { return two(random) ? 32767 : -32768; }),
    5000, 43);
  ExpectTruth(Filled<std::int16_t>({ 15, 15, 15 }, 32766.5,
                [&](int, int, int) { return two(random) ? 32767 : 32766; }),
    5000, 44);
  ExpectTruth(Filled<std::uint16_t>(
                { 15, 15, 15 }, 40000, [&](int, int, int) { return 32768 + full(random); }),
    5000, 45);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  for (const float scale : { 1e-44F, 1e-40F, 1e-38F, 1e-30F, 1e30F, 3e38F })
  {
    // Below 1e-38 samples are whole multiples of 1.4e-45, which TraceTruth sees as they are.
    const auto tiny =
      Filled<float>({ 15, 15, 15 }, 0.0, [&](int, int, int) { return scale * unit(random); });
    ASSERT_GT(tiny.cells->Count(), 1000U) << scale;
    ExpectTruth(tiny, 3000, 46);
  }
}

TEST(CellTracerExtreme, CornersEqualToTheIsovalue)
{
  // Whole numbers with an isovalue among them: surfaces through corners, along edges, in whole
  // faces.
  std::mt19937 random(20);
  std::uniform_int_distribution<int> three(-1, 1);
  ExpectTruth(
    Filled<std::int16_t>({ 16, 16, 16 }, 0.0, [&](int, int, int) { return three(random); }), 20000,
    47, 0.05);
}

TEST(CellTracerExtreme, WorldRaysWithExtremeSpacings)
{
  for (const glm::dvec3& spacing :
    { glm::dvec3(1e-6), glm::dvec3(1e6), glm::dvec3(1, 1, 100), glm::dvec3(0.3, 0.3, 3) })
  {
    const hasp::GridGeometry g{ { 20, 20, 20 }, {}, spacing, glm::dmat3(1) };
    auto noise = Noise<std::int16_t>({ 20, 20, 20 }, 21);
    const TracedVolume<std::int16_t> scene(std::move(noise.samples), g, 99.5);
    const hasp::RayCaster caster(scene.grid, scene.blocks, scene.isovalue);
    RandomRays next(g.dims, 48);
    for (int n = 0; n < 3000; ++n)
    {
      const hasp::CellRay ray = next.Next();
      const glm::dvec3 origin = g.IndexToWorld(ray.origin);
      const auto other = caster.Cast(origin, g.IndexToWorld(ray.origin + ray.direction) - origin);
      const auto hit = scene.tracer.Trace(ray);
      const auto truth = TraceTruth(scene.view, scene.isovalue, ray.origin, ray.direction, 0, 1e9);
      if (truth.tangency < Undecided)
        continue;
      ASSERT_EQ(hit.has_value(), other.has_value()) << n;
      if (hit)
      {
        ASSERT_NEAR(hit->t, other->t, HitTolerance) << n;
        // The distance limit counts millimetres, whatever a voxel is.
        const float open =
          scene.tracer.AmbientOcclusion(*hit, { 8, 1e-3 * std::min(spacing.x, spacing.z) }, n);
        ASSERT_GE(open, 0.0F);
      }
    }
  }
}

} // namespace
