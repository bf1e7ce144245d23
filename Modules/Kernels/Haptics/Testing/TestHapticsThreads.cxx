// The same bits whatever the number of threads: distance map and point shell.
#include "Grid/Testing/WithThreads.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;

struct Results
{
  std::vector<std::int16_t> samples;
  std::vector<float> points;
  float steepest = 0.0F;
  double area = 0.0;
};

TEST(HapticsThreads, GiveTheSameBits)
{
  const SampledDistance body(BumpyBall(14.0, 1.0), SkewGrid({ 56, 37, 27 }));
  const auto make = [&](int threads)
  {
    return WithThreads(threads,
      [&]
      {
        Results r;
        const hasp::DistanceMap map(body.View(), { 3.0, {}, false });
        const auto view = map.View();
        for (int b = 0; b < view.blocks.x * view.blocks.y * view.blocks.z; ++b)
          r.samples.insert(r.samples.end(), view.samples + view.firstSample[b],
            view.samples + view.firstSample[b] + view.BrickSamples);
        r.steepest = view.steepest;
        const auto shell = hasp::PointShell::OfSurface(body.View(), {}, { 5000, 256, 1 });
        for (int level = 0; level < shell->Levels(); ++level)
        {
          const hasp::ContactPoints p = shell->Level(level);
          for (const float* column : { p.x, p.y, p.z, p.nx, p.ny, p.nz })
            r.points.insert(r.points.end(), column, column + p.count);
        }
        r.area = shell->SurfaceArea();
        return r;
      });
  };
  const Results one = make(1);
  EXPECT_FALSE(one.points.empty());
  for (const int threads : { 2, 5 })
  {
    const Results more = make(threads);
    EXPECT_EQ(more.samples, one.samples);
    EXPECT_EQ(more.points, one.points);
    EXPECT_EQ(more.steepest, one.steepest);
    EXPECT_EQ(more.area, one.area);
  }
}

} // namespace
