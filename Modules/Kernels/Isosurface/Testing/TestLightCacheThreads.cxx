// The same light whatever the number of threads.
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Isosurface/Testing/LitScene.h"

namespace
{

using namespace hasp::testing;

TEST(LightCacheThreads, GiveTheSameLight)
{
  const hasp::GridGeometry g = Cube({ 60, 50, 55 });
  const TracedVolume<std::int16_t> scene(
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(9), g, 100, 0), g, 0.5);
  const auto draw = [&](int threads, std::size_t blocks)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        hasp::LightCache cache(hasp::LightCacheSettings{ blocks });
        std::vector<hasp::PictureLight> all;
        for (int frame = 0; frame < 6; ++frame)
        {
          const auto view =
            ViewFrom(g, glm::dvec3(90 + frame, -40, 60), glm::dvec3(20, 30, 14), { 151, 103 });
          hasp::TracedPicture picture;
          scene.tracer.TracePicture(view, picture);
          cache.Light(
            scene.tracer, view, picture, { 7.0, glm::dvec4(1, -1, 1, 0) }, all.emplace_back());
        }
        return all;
      });
  };
  for (const std::size_t blocks : { 128, 8192 }) // too few, so that they are fought for, and enough
  {
    const auto one = draw(1, blocks);
    for (const int threads : { 2, 3, 8 })
      EXPECT_EQ(draw(threads, blocks), one) << threads;
  }
}

} // namespace
