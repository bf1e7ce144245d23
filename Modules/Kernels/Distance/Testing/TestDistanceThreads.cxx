// The same bits whatever the number of threads: coverage, distance, contour and what trees are
// asked.
#include "Distance/ChamferDistance.h"
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/GridSolid.h"
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Testing/RandomSolid.h"

#include <gtest/gtest.h>

namespace
{

struct Results
{
  std::vector<float> coverage, distance, band, grey, chamfer, binary;
  hasp::TriangleMesh mesh;
};

TEST(DistanceThreads, GiveTheSameBits)
{
  const hasp::GridGeometry ct{ { 40, 35, 30 }, { -20, -17, -15 }, glm::dvec3(1), glm::dmat3(1) };
  const auto samples =
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticTorus({}, { 0, 0.6, 0.8 }, 9, 4), ct, 100, 0);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), ct };
  const hasp::GridGeometry target{ { 38, 37, 33 }, { -17, -16, -14 }, { 0.9, 0.9, 0.8 },
    glm::dmat3(1) };
  const auto make = [&](int threads)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        Results r;
        hasp::CoverageSettings settings;
        settings.isovalue = 0;
        r.coverage = hasp::Coverage(grid, target, settings);
        r.distance = hasp::CoverageDistance(target, r.coverage);
        r.band = hasp::CoverageDistanceBand(target, r.coverage);
        r.grey = hasp::GreyDistance(grid, 0);
        r.chamfer = hasp::ChamferDistance(target, r.coverage);
        std::vector<std::uint8_t> inside(r.coverage.size());
        for (std::size_t n = 0; n < inside.size(); ++n)
          inside[n] = r.coverage[n] >= 0.5F;
        r.binary = hasp::SignedEuclideanDistance(target, inside);
        r.mesh = hasp::ContourTetrahedra({ r.distance.data(), target });
        return r;
      });
  };
  const Results one = make(1);
  ASSERT_GT(one.mesh.triangles.size(), 1000U);
  for (const int threads : { 2, 3, 4, 8 })
  {
    const Results many = make(threads);
    EXPECT_EQ(many.coverage, one.coverage) << threads;
    EXPECT_EQ(many.distance, one.distance) << threads;
    EXPECT_EQ(many.band, one.band) << threads;
    EXPECT_EQ(many.grey, one.grey) << threads;
    EXPECT_EQ(many.chamfer, one.chamfer) << threads;
    EXPECT_EQ(many.binary, one.binary) << threads;
    EXPECT_EQ(many.mesh.points, one.mesh.points) << threads;
    EXPECT_EQ(many.mesh.triangles, one.mesh.triangles) << threads;
  }
}

TEST(DistanceThreads, AskATreeForTheSameBits)
{
  const hasp::GridGeometry g{ { 150, 90, 70 }, { -7.5, -4.5, -3.5 }, glm::dvec3(0.1),
    glm::dmat3(1) };
  const auto tree = hasp::RandomSolid(3, 3);
  const auto make = [&](int threads)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        const auto near = hasp::EvaluateNearSurface(*tree, g, 0.25);
        const auto sampled =
          hasp::MakeGridSolid(std::make_shared<std::vector<float>>(hasp::DenseValues(near)), g);
        const auto mesh = hasp::SharpContour(*tree, g);
        return std::make_tuple(
          near.sides, near.near, near.values, sampled->Steepness(), mesh.points, mesh.triangles);
      });
  };
  const auto one = make(1);
  ASSERT_GT(std::get<1>(one).size(), 50U);
  ASSERT_GT(std::get<4>(one).size(), 1000U);
  for (const int threads : { 2, 4, 8 })
    EXPECT_EQ(make(threads), one) << threads;
}

} // namespace
