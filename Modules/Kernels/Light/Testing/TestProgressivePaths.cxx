// Paths on a thread of their own: begun, asked, waited for, cancelled and begun anew.
#include "Light/ProgressivePaths.h"
#include "Light/Testing/LitPictures.h"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace hasp::testing;
using hasp::PathTracedPicture;
using hasp::ProgressivePaths;
using hasp::ProgressiveWork;

ProgressiveWork WorkOf(int samples, int side = 24)
{
  static const TwoBalls of;
  const auto scene =
    std::make_shared<const hasp::LitScene>(of.Bodies(), std::vector<hasp::LitLamp>(), Uniform(1.0));
  return { scene, BallsView({ side, side }), {}, samples };
}

TEST(ProgressivePaths, GiveThePictureOfTheirSamples)
{
  ProgressivePaths paths;
  const ProgressiveWork work = WorkOf(5);
  EXPECT_EQ(paths.Samples(), 0);
  EXPECT_FALSE(paths.Running());
  EXPECT_EQ(paths.Bytes(), 0U);
  paths.Start(work);
  paths.WaitFor(5);
  PathTracedPicture picture, truth;
  ASSERT_TRUE(paths.Latest(picture));
  EXPECT_EQ(picture.samples, 5);
  EXPECT_FALSE(paths.Latest(picture)) << "there is no newer one";
  for (int n = 0; n < 5; ++n)
    ASSERT_TRUE(AddPathSample(*work.scene, work.view, work.settings, truth));
  EXPECT_EQ(picture.sums, truth.sums);
  EXPECT_EQ(picture.covered, truth.covered);
}

TEST(ProgressivePaths, BeginAnewAndEndWheneverTheyAreTold)
{
  ProgressivePaths paths;
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n)
  {
    paths.Start(WorkOf(1 << 20, 16));
    if (random() % 4 == 0)
      paths.WaitFor(1);
    PathTracedPicture picture;
    if (paths.Latest(picture))
    {
      EXPECT_EQ(picture.size, glm::ivec2(16));
    }
    if (random() % 2 == 0)
    {
      paths.Cancel();
      EXPECT_FALSE(paths.Running());
      paths.WaitFor(1 << 20); // returns: no more will come
      paths.Cancel();
    }
  }
  paths.Release();
  EXPECT_EQ(paths.Samples(), 0);
}

TEST(ProgressivePaths, RefuseWhatCannotBeTraced)
{
  ProgressivePaths paths;
  ProgressiveWork none = WorkOf(1);
  none.scene = nullptr;
  EXPECT_THROW(paths.Start(none), std::invalid_argument);
  EXPECT_THROW(paths.Start(WorkOf(0)), std::invalid_argument);
  ProgressiveWork bounces = WorkOf(1);
  bounces.settings.paths.bounces = 0;
  EXPECT_THROW(paths.Start(bounces), std::invalid_argument);
  EXPECT_FALSE(paths.Running());
  paths.WaitFor(1);
}

TEST(ProgressivePaths, TellOnceWhatStoppedThem)
{
  ProgressivePaths paths;
  ProgressiveWork flat = WorkOf(4);
  flat.view.indexToClip = glm::dmat4(0.0); // cannot be inverted, which the thread finds
  paths.Start(flat);
  paths.WaitFor(4);
  PathTracedPicture picture;
  EXPECT_THROW(paths.Latest(picture), std::invalid_argument);
  EXPECT_FALSE(paths.Latest(picture));
}

} // namespace
