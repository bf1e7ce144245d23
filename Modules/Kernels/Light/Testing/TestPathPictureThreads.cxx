// Pictures by paths, sample by sample: the same whatever the number of threads, and whole ones
// alone however they are cancelled.
#include "Grid/Testing/WithThreads.h"
#include "Light/Testing/LightScenes.h"

#include <gtest/gtest.h>

#include <thread>

namespace
{

using namespace hasp::testing;
using hasp::LitScene;
using hasp::PathTracedPicture;

LitScene BallOnPlane()
{
  const auto far = Surroundings({ 16, 8 }, [](const glm::dvec3& d) { return 1.2 + d.z; });
  return { { Body(SphereCells({ 0, 0, 5 }, 5.0, 21), Scattering({ glm::vec3(0.7F), 0.04F, 0.4F })),
             Body(PlaneMesh(12.0), Matt(0.5)) },
    { hasp::LitLamp() }, far };
}

hasp::PictureView View(const glm::ivec2& size)
{
  return Camera({ 30, -20, 22 }, { 0, 0, 3 }, size);
}

TEST(PathPictureThreads, GiveTheSamePicture)
{
  const LitScene scene = BallOnPlane();
  const auto draw = [&](int threads)
  {
    return WithThreads(threads,
      [&]
      {
        PathTracedPicture picture;
        for (int n = 0; n < 4; ++n)
          EXPECT_TRUE(hasp::AddPathSample(scene, View({ 71, 53 }), { {}, 5 }, picture));
        return picture;
      });
  };
  const PathTracedPicture one = draw(1);
  EXPECT_EQ(one.samples, 4);
  for (const int threads : { 2, 3, 8 })
  {
    const PathTracedPicture many = draw(threads);
    EXPECT_EQ(many.sums, one.sums) << threads;
    EXPECT_EQ(many.covered, one.covered) << threads;
    EXPECT_EQ(many.rays, one.rays) << threads;
  }
}

TEST(PathPictureThreads, CancelledSamplesLeaveNoTrace)
{
  const LitScene scene = BallOnPlane();
  const hasp::PictureView view = View({ 40, 36 });
  const hasp::PathPictureSettings settings{ { 2 }, 9 };
  std::vector<PathTracedPicture> truths(1); // after so many samples
  for (int n = 0; n < 8; ++n)
  {
    truths.push_back(n ? truths.back() : PathTracedPicture());
    hasp::AddPathSample(scene, view, settings, truths.back());
  }
  std::atomic<bool> cancel = false;
  // Sets it and takes it back, so that samples also end with it taken back.
  const std::jthread other(
    [&](const std::stop_token& over)
    {
      for (std::uint32_t n = 1; !over.stop_requested(); n = n * 1664525U + 1013904223U)
      {
        for (std::uint32_t wait = n >> 20U; wait > 0 && !over.stop_requested(); --wait)
          continue;
        cancel = n >> 31U;
      }
    });
  PathTracedPicture picture;
  int cancelled = 0;
  for (int n = 0; n < 20'000 && cancelled < 1000; ++n)
  {
    const int before = picture.samples;
    const bool whole = hasp::AddPathSample(scene, view, settings, picture, &cancel);
    cancelled += !whole;
    ASSERT_EQ(picture.samples, before + whole) << n;
    if (picture.samples > 0)
    {
      ASSERT_EQ(picture.sums, truths[picture.samples].sums) << n;
      ASSERT_EQ(picture.covered, truths[picture.samples].covered) << n;
    }
    if (picture.samples == 7)
      picture = {};
  }
  EXPECT_EQ(cancelled, 1000);
}

TEST(PathPictureThreads, CancelledFromTheStartNothingIsThere)
{
  const LitScene scene = BallOnPlane();
  const std::atomic<bool> cancel = true;
  PathTracedPicture picture;
  EXPECT_FALSE(hasp::AddPathSample(scene, View({ 40, 36 }), {}, picture, &cancel));
  EXPECT_EQ(picture.samples, 0);
  EXPECT_EQ(picture.Pixel(0), glm::vec4(0.0F));
}

} // namespace
