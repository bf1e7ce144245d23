// The same bits whatever the number of threads: coverage, distance and contour.
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"

#include <gtest/gtest.h>

namespace
{

struct Results
{
  std::vector<float> coverage, distance, binary;
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
  for (const int threads : { 2, 3, 8 })
  {
    const Results many = make(threads);
    EXPECT_EQ(many.coverage, one.coverage) << threads;
    EXPECT_EQ(many.distance, one.distance) << threads;
    EXPECT_EQ(many.binary, one.binary) << threads;
    EXPECT_EQ(many.mesh.points, one.mesh.points) << threads;
    EXPECT_EQ(many.mesh.triangles, one.mesh.triangles) << threads;
  }
}

} // namespace
