// Against truth in long double, and against RayCaster, which walks the volume itself.
#include "Grid/AnalyticVolumes.h"
#include "Grid/Phantom.h"
#include "Isosurface/CellHits.h"
#include "Isosurface/RayCaster.h"
#include "Isosurface/Testing/TracedVolume.h"

namespace
{

using namespace hasp::testing;

TEST(CellTracer, MeetsNoiseWhereTruthDoes)
{
  ExpectTruth(Noise<std::int16_t>({ 21, 18, 19 }, 1), 100000, 31);
}

TEST(CellTracer, MeetsEverySampleTypeWhereTruthDoes)
{
  ExpectTruth(Noise<std::uint8_t>({ 14, 9, 17 }, 2), 30000, 32);
  ExpectTruth(Noise<std::uint16_t>({ 14, 9, 17 }, 3), 30000, 33);
  ExpectTruth(Noise<float>({ 14, 9, 17 }, 4), 30000, 34);
}

TEST(CellTracer, MeetsWhatSingleLinesMeet)
{
  const auto scene = Noise<std::int16_t>({ 21, 18, 19 }, 6);
  RandomRays next(scene.view.geometry.dims, 37);
  int hits = 0, apart = 0;
  for (int n = 0; n < 1000; ++n)
  {
    const hasp::CellRay ray = next.Next();
    const auto line = FirstHit(*scene.cells, ray.origin, ray.origin + 100.0 * ray.direction);
    const auto hit = scene.tracer.Trace(ray);
    if (line && hit && std::abs(100.0 * line->t - hit->t) < HitTolerance)
      ++hits;
    else
      apart += line || hit;
  }
  EXPECT_GT(hits, 500);
  EXPECT_LE(apart, 1); // rays that touch the surface: either answer is right
}

TEST(CellTracer, MeetsAGyroidWhereTruthDoes)
{
  const hasp::GridGeometry g = Cube({ 40, 41, 42 });
  ExpectTruth(
    TracedVolume<float>(hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(12), g, 1, 0), g, 0.1),
    30000, 35);
}

TEST(CellTracer, MeetsCompactCellsWhereTheirLevelsSay)
{
  // Truth: the volume that the compact cells decode to.
  const auto scene = Noise<std::int16_t>({ 18, 15, 12 }, 5, hasp::CellPrecision::Compact);
  const hasp::GridGeometry g = scene.view.geometry;
  std::vector<float> decoded(g.Size());
  for (std::size_t n = 0; n < decoded.size();
       ++n) // never next to the surface where no cell is active
    decoded[n] = float(scene.samples[n]) - scene.isovalue;
  const hasp::GridView<float> view{ decoded.data(), g };
  for (std::size_t n = 0; n < scene.cells->Count(); ++n)
  {
    const glm::ivec3 cell = scene.cells->Cell(n);
    const auto& cluster = scene.cells->clusters[scene.cells->ClusterOf(n)];
    const auto corners = scene.cells->CornersFromIsovalue(cluster, cell - cluster.Origin());
    for (int c = 0; c < 8; ++c)
      view(cell.x + (c & 1), cell.y + (c >> 1 & 1), cell.z + (c >> 2)) = corners[c];
  }
  RandomRays next(g.dims, 36);
  for (int n = 0; n < 8000; ++n)
  {
    const hasp::CellRay ray = next.Next();
    const auto truth = TraceTruth(
      hasp::GridView<const float>{ decoded.data(), g }, 0.0F, ray.origin, ray.direction, 0, 1e9);
    const auto hit = scene.tracer.Trace(ray);
    if (truth.tangency < Undecided)
      continue;
    ASSERT_EQ(hit.has_value(), truth.t.has_value()) << n;
    if (hit)
    {
      ASSERT_NEAR(hit->t, *truth.t, HitTolerance) << n;
    }
  }
}

template <typename T>
void ExpectRayCaster(const TracedVolume<T>& scene, int rays, unsigned seed)
{
  const hasp::GridGeometry& g = scene.view.geometry;
  const hasp::RayCaster caster(scene.grid, scene.blocks, scene.isovalue);
  RandomRays next(g.dims, seed);
  int hits = 0;
  for (int n = 0; n < rays; ++n)
  {
    const hasp::CellRay ray = next.Next();
    const glm::dvec3 origin = g.IndexToWorld(ray.origin);
    const auto other = caster.Cast(origin, g.IndexToWorld(ray.origin + ray.direction) - origin);
    const auto hit = scene.tracer.Trace(ray);
    if (hit.has_value() == other.has_value() &&
        (!hit || std::abs(hit->t - other->t) <= HitTolerance))
    {
      hits += hit.has_value();
      continue;
    }
    const auto truth = TraceTruth(scene.view, scene.isovalue, ray.origin, ray.direction, 0, 1e9);
    ASSERT_LT(truth.tangency, Undecided)
      << n << ": RayCaster and CellTracer differ, and neither may";
  }
  EXPECT_GT(hits, rays / 5);
}

TEST(CellTracer, AgreesWithRayCasterOnAHead)
{
  hasp::PhantomSettings settings;
  settings.noiseHU = 25;
  const hasp::GridGeometry g = hasp::PhantomGridOfSize({ 96, 96, 96 }, settings);
  ExpectRayCaster(TracedVolume<std::int16_t>(SamplePhantom(g, settings), g, 226), 400000, 37);
}

TEST(CellTracer, AgreesWithRayCasterOnAGyroid)
{
  const hasp::GridGeometry g = Cube({ 90, 80, 70 });
  ExpectRayCaster(
    TracedVolume<std::int16_t>(
      hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(17), g, 1000, 0), g, 0.5),
    300000, 38);
}

TEST(CellTracer, AgreesWithRayCasterOnNoise)
{
  ExpectRayCaster(Noise<std::int16_t>({ 50, 40, 60 }, 6), 300000, 39);
}

TEST(CellTracer, CutsRaysAtBothEnds)
{
  const hasp::GridGeometry g = Cube({ 30, 30, 30 });
  std::vector<std::int16_t> samples(g.Size());
  for (int k = 0; k < 30; ++k)
    for (int n = 0; n < 900; ++n) // planes at x = 9.5 and 20.5, solid between them
      samples[k * 900 + n] = n % 30 >= 10 && n % 30 <= 20 ? 1 : 0;
  const TracedVolume<std::int16_t> scene(std::move(samples), g, 0.5);
  const hasp::CellRay ray{ { 2, 14.3, 15.2 }, { 2, 0, 0 } };
  const auto hit = scene.tracer.Trace(ray);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t, 3.75);
  EXPECT_FALSE(hit->fromInside);
  EXPECT_FLOAT_EQ(hit->gradient.x, 1.0F);
  const auto second = scene.tracer.Trace({ ray.origin, ray.direction, 4.0, 100.0 });
  ASSERT_TRUE(second);
  EXPECT_DOUBLE_EQ(second->t, 9.25);
  EXPECT_TRUE(second->fromInside);
  EXPECT_FALSE(scene.tracer.Trace({ ray.origin, ray.direction, 4.0, 9.2 }));
  EXPECT_FALSE(scene.tracer.Occluded({ ray.origin, ray.direction, 4.0, 9.2 }));
  EXPECT_TRUE(scene.tracer.Occluded({ ray.origin, ray.direction, 4.0, 9.3 }));
  EXPECT_FALSE(scene.tracer.Trace({ ray.origin, -ray.direction }));
}

TEST(CellTracer, RefusesCellsThatLie)
{
  EXPECT_THROW(hasp::CellTracer(nullptr), std::invalid_argument);
  const auto scene = Noise<std::int16_t>({ 12, 12, 12 }, 7);
  const auto bad = [&](const auto& spoil)
  {
    auto cells = std::make_shared<hasp::ClusteredCells>(*scene.cells);
    spoil(*cells);
    EXPECT_THROW(hasp::CellTracer{ cells }, std::invalid_argument);
  };
  bad([](hasp::ClusteredCells& c) { c.corners.resize(c.corners.size() - 3); });
  bad([](hasp::ClusteredCells& c) { c.clusters.back().active = {}; });
  bad([](hasp::ClusteredCells& c) { c.clusters.back().firstWord = 0xFFFFFFFFU; });
  bad([](hasp::ClusteredCells& c) { c.geometry.dims.x = 9; });
  auto few = std::make_shared<hasp::ClusteredCells>(
    *Noise<std::int16_t>({ 12, 12, 12 }, 7, hasp::CellPrecision::Compact).cells);
  few->levels.resize(100);
  EXPECT_THROW(hasp::CellTracer{ few }, std::invalid_argument);
}

TEST(CellTracer, CountsItsBytes)
{
  const auto small = Noise<std::int16_t>({ 9, 9, 9 }, 8),
             large = Noise<std::int16_t>({ 65, 65, 65 }, 8);
  EXPECT_GT(small.tracer.Bytes(), sizeof(hasp::CellCluster) / 8);
  // 512 clusters; a leaf and its share of the nodes take about 100 bytes, and Embree rounds up.
  EXPECT_GT(large.tracer.Bytes(), 512U * 50U);
  EXPECT_LT(large.tracer.Bytes(), 512U * 250U);
}

} // namespace
