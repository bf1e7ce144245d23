#include "Distance/LevelSet.h"

#include "Distance/SolidShapes.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/Testing/WithThreads.h"
#include "Testing/LevelSetShapes.h"

#include <openvdb/tools/LevelSetMeasure.h>

#include <gtest/gtest.h>

namespace
{

using hasp::Turned;

TEST(LevelSet, RefusesWhatIsNoDistance)
{
  const auto g = Turned({ 20, 20, 20 }, glm::dvec3(0.5));
  const auto values = hasp::SampledSolid(*hasp::MakeCapsule({}, {}, 3), g);
  const hasp::GridView<const float> view{ values.data(), g };
  for (const double band : { 1.7, 1001.0, -3.0, std::nan("") })
    EXPECT_THROW(hasp::LevelSetOf(view, band), std::invalid_argument) << band;
  const auto slices = Turned({ 20, 20, 20 }, { 0.5, 0.5, 5 }); // a diagonal of 10.1 voxels
  EXPECT_THROW(hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), slices }, 10),
    std::invalid_argument);
  EXPECT_NO_THROW(hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), slices }, 10.2));
  const auto flat = Turned({ 20, 20, 1 }, glm::dvec3(0.5));
  EXPECT_THROW(
    hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), flat }), std::invalid_argument);
  auto invalid = g;
  invalid.spacing.z = 0;
  EXPECT_THROW(
    hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), invalid }), std::invalid_argument);
  EXPECT_THROW(hasp::LevelSetOf(view, 3, [](double) { return false; }), hasp::Cancelled);
  auto broken = values;
  broken[77] = std::nanf("");
  EXPECT_THROW(
    hasp::LevelSetOf(hasp::GridView<const float>{ broken.data(), g }), std::invalid_argument);
  EXPECT_THROW(hasp::SampleLevelSet(*hasp::LevelSetOf(view), invalid), std::invalid_argument);
  auto frustum = openvdb::FloatGrid::create(3);
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
    { openvdb::Vec3d(0), openvdb::Vec3d(9) }, 0.5, 10));
  EXPECT_THROW(hasp::SampleLevelSet(*frustum, g), std::invalid_argument);
}

TEST(LevelSet, KeepsTheBandAsItIsAndTheSignElsewhere)
{
  const auto g = Turned({ 45, 37, 29 }, { 0.5, 0.6, 0.8 });
  const auto values = hasp::SampledSolid(*hasp::MakeCapsule({ 0.3, 0, 0 }, { 0.3, 0, 0 }, 7), g);
  const auto grid = hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), g }, 4);
  EXPECT_EQ(grid->background(), 2.0F);
  EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
  std::size_t active = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
      {
        const float d = values[(k * g.dims.y + j) * g.dims.x + i];
        const openvdb::Coord at(i, j, k);
        ASSERT_EQ(grid->tree().isValueOn(at), std::abs(d) < 2.0F);
        ASSERT_EQ(grid->tree().getValue(at), std::abs(d) < 2.0F ? d : std::copysign(2.0F, d));
        active += std::abs(d) < 2.0F;
        const glm::dvec3 world = g.IndexToWorld({ i, j, k });
        const openvdb::Vec3d theirs = grid->indexToWorld(at);
        ASSERT_LT(glm::distance(world, { theirs.x(), theirs.y(), theirs.z() }), 1e-9);
      }
  EXPECT_EQ(grid->activeVoxelCount(), active); // nothing beyond the samples
  EXPECT_GT(active, 5000U);
}

TEST(LevelSet, IsClosedWhereTheSolidReachesTheBorder)
{
  const auto g = Turned({ 21, 17, 13 }, { 0.5, 0.5, 0.7 });
  const std::vector<float> all(g.Size(), -std::numeric_limits<float>::infinity());
  const auto grid = hasp::LevelSetOf(hasp::GridView<const float>{ all.data(), g }, 3);
  const auto box = hasp::MakeBox({}, g.direction, 0.5 * glm::dvec3(g.Cells()) * g.spacing);
  for (int k = -7; k < g.dims.z + 7; ++k)
    for (int j = -7; j < g.dims.y + 7; ++j)
      for (int i = -7; i < g.dims.x + 7; ++i)
        // Rounding to floats of 1.5 mm.
        ASSERT_NEAR(grid->tree().getValue({ i, j, k }),
          glm::clamp(box->At(g.IndexToWorld({ i, j, k })), -1.5, 1.5), 3e-7);
}

TEST(LevelSet, OpenVdbMeasuresTheVolumeThatItEncloses)
{
  auto g = Turned({ 60, 60, 60 }, glm::dvec3(0.4));
  const auto values = hasp::SampledSolid(*hasp::MakeCapsule({}, {}, 8), g);
  const auto grid = hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), g });
  // Turned voxels are cubes to us; OpenVDB asks for its own kind of transform.
  grid->setTransform(openvdb::math::Transform::createLinearTransform(0.4));
  // Its delta function is smoothed over 1.5 voxels: 0.6 / 8 squared, and a few of it.
  EXPECT_NEAR(openvdb::tools::levelSetVolume(*grid), 4.0 / 3.0 * M_PI * 512, 0.01 * 2145);
}

TEST(LevelSet, ComesBackAsSamplesOfAnyGrid)
{
  const auto g = Turned({ 45, 37, 29 }, { 0.5, 0.6, 0.8 });
  const auto ball = hasp::MakeCapsule({ 0.3, 0, 0 }, { 0.3, 0, 0 }, 7);
  const auto values = hasp::SampledSolid(*ball, g);
  const auto grid = hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), g }, 4);
  const auto same = hasp::SampleLevelSet(*grid, g);
  for (std::size_t n = 0; n < values.size(); ++n) // weights of 1e-15 and of 1
    ASSERT_NEAR(same[n], glm::clamp(values[n], -2.0F, 2.0F), 1e-6) << n;
  const hasp::GridGeometry other{ glm::ivec3(30), glm::dvec3(-10.5), glm::dvec3(0.7),
    glm::dmat3(1) };
  const auto sampled = hasp::SampleLevelSet(*grid, other);
  for (std::size_t n = 0; n < sampled.size(); ++n)
  {
    const double truth = ball->At(other.IndexToWorld({ n % 30, n / 30 % 30, n / 900 }));
    // Trilinear, 0.6 / (8 * 5) at the band's inner edge; where the band ends, it is cut short.
    if (std::abs(truth) < 1.0)
    {
      ASSERT_NEAR(sampled[n], truth, 0.03);
      continue;
    }
    ASSERT_TRUE(sampled[n] * truth > 0 && std::abs(sampled[n]) > 0.95) << sampled[n];
    ASSERT_TRUE(std::abs(truth) < 3.2 || std::abs(sampled[n]) == 2.0F);
  }
}

TEST(LevelSet, TakesMemoryWhereTheSurfaceIs)
{
  const auto g = Turned(glm::ivec3(160), glm::dvec3(0.5));
  const auto values = hasp::SampledSolid(*hasp::MakeCapsule({}, {}, 30), g);
  const auto grid = hasp::LevelSetOf(hasp::GridView<const float>{ values.data(), g });
  // A surface of 45,000 voxels, 3 to each side, and blocks of 8^3 around: 2,200 of 8,000.
  EXPECT_LT(grid->memUsage(), values.size() * sizeof(float) / 2);
  EXPECT_LT(grid->activeVoxelCount(), 6.2 * 4 * M_PI * 60 * 60);
}

hasp::TriangleMesh BoxMesh(const glm::dvec3& low, const glm::dvec3& high)
{
  hasp::TriangleMesh mesh;
  for (int n = 0; n < 8; ++n)
    mesh.points.push_back(glm::mix(low, high, glm::dvec3(n & 1, n >> 1 & 1, n >> 2)));
  for (const glm::uvec4& q :
    { glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
      glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5) })
  {
    mesh.triangles.emplace_back(q.x, q.y, q.z);
    mesh.triangles.emplace_back(q.x, q.z, q.w);
  }
  return mesh;
}

TEST(LevelSet, OfAMeshHoldsDistancesToItsTriangles)
{
  const glm::dvec3 low(-3.1, -4.3, 20.2), high(5.7, 2.2, 31.9);
  const auto box = hasp::MakeBox(0.5 * (low + high), glm::dmat3(1), 0.5 * (high - low));
  auto mesh = BoxMesh(low, high);
  for (const bool turned : { false, true })
  {
    if (turned) // inside out: what a flood from outside does not reach is inside all the same
      for (glm::uvec3& t : mesh.triangles)
        std::swap(t.x, t.y);
    const auto grid = hasp::LevelSetOf(mesh, 0.4, 3);
    EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
    for (int k = 40; k < 90; ++k)
      for (int j = -20; j < 15; ++j)
        for (int i = -15; i < 22; ++i)
        {
          const double truth = box->At(0.4 * glm::dvec3(i, j, k));
          // Floats of 80 voxels; a voxel of the last layer may be out of the band.
          ASSERT_NEAR(grid->tree().getValue({ i, j, k }), glm::clamp(truth, -1.2, 1.2),
            std::abs(truth) < 0.8 ? 1e-5 : 0.05)
            << i << " " << j << " " << k;
        }
  }
}

TEST(LevelSet, OfAMeshThatIsNotClosedIsRefused)
{
  const auto good = BoxMesh({ 0, 0, 0 }, { 3, 4, 5 });
  EXPECT_NO_THROW(hasp::LevelSetOf(good, 0.5));
  auto open = good;
  open.triangles.pop_back();
  auto wrong = good;
  wrong.triangles[3].y = 8;
  auto infinite = good;
  infinite.points[2].z = std::numeric_limits<double>::infinity();
  for (const auto& mesh : { open, wrong, infinite, hasp::TriangleMesh{} })
    EXPECT_THROW(hasp::LevelSetOf(mesh, 0.5), std::invalid_argument);
  for (const double spacing : { 0.0, -1.0, std::nan(""), 1e-6 }) // five million voxels
    EXPECT_THROW(hasp::LevelSetOf(good, spacing), std::invalid_argument);
  for (const double band : { 1.0, 1e9, std::nan("") })
    EXPECT_THROW(hasp::LevelSetOf(good, 0.5, band), std::invalid_argument);
  for (const double until : { 0.0, 0.4 })
    EXPECT_THROW(hasp::LevelSetOf(good, 0.05, 3, [until](double share) { return share < until; }),
      hasp::Cancelled);
}

TEST(LevelSet, IsTheSameWithAnyNumberOfThreads)
{
  const auto g = Turned({ 60, 50, 40 }, { 0.5, 0.5, 0.6 });
  const auto values = hasp::SampledSolid(*hasp::MakeCapsule({ -3, 0, 0 }, { 3, 2, 0 }, 6), g);
  const hasp::GridView<const float> view{ values.data(), g };
  const auto mesh = hasp::ContourTetrahedra(view);
  const auto make = [&](int threads)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        return std::make_pair(hasp::SampleLevelSet(*hasp::LevelSetOf(view), g),
          hasp::SampleLevelSet(*hasp::LevelSetOf(mesh, 0.5), g));
      });
  };
  const auto one = make(1);
  for (const int threads : { 2, 4 })
    EXPECT_EQ(make(threads), one) << threads;
}

} // namespace
