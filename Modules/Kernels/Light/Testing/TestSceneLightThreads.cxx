// The same light whatever the number of threads.
#include "Grid/Testing/WithThreads.h"
#include "Light/Testing/LitPictures.h"

namespace
{

using namespace hasp::testing;

TEST(SceneLightThreads, GiveTheSameLight)
{
  TwoBalls of;
  of.far = SunnySky();
  of.material.specular = 0.04F;
  of.lamps.emplace_back();
  const hasp::LitScene scene = of.Scene();
  const auto draw = [&](int threads, std::size_t blocks)
  {
    return WithThreads(threads,
      [&]
      {
        hasp::SceneLightCache cache(hasp::SceneLightSettings{ blocks });
        std::vector<hasp::LitPicture> all;
        for (int frame = 0; frame < 6; ++frame) // moving, then still
          cache.Light(scene, BallsView({ 51, 43 }, std::min(frame, 3)), {},
            frame < 5 ? Traced(3) : Open(9.0), all.emplace_back());
        return all;
      });
  };
  for (const std::size_t blocks : { 64, 8192 }) // too few, so that they are fought for, and enough
  {
    const auto one = draw(1, blocks);
    for (const int threads : { 2, 3, 8 })
      EXPECT_EQ(draw(threads, blocks), one) << threads;
  }
}

} // namespace
