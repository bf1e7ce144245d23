// What a ray cache holds comes when it is asked for and goes with it; and what Automatic does.
#include "DrawingChoice.h"
#include "HaspGL.h"
#include "RaycastTestScene.h"

#include <array>
#include <set>

namespace
{

using hasp::testing::Find;
using hasp::testing::Names;
using Ball = hasp::testing::RaycastBall;

class RayCachingLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(RayCachingLives, NothingIsMadeBeforeItIsDrawn)
{
  Ball ball(vtkHaspRayCachingMapper::Cache);
  for (const char* name : { "ray cache", "cached cells, host", "depth of the last pictures" })
    EXPECT_EQ(Find(ball.Raycaster, name).bytes, 0U) << name;
  ball.Draw();
  for (const char* name : { "ray cache", "cached cells, host", "depth of the last pictures" })
    EXPECT_GT(Find(ball.Raycaster, name).bytes, 0U) << name;
  EXPECT_EQ(Find(ball.Raycaster, "active cells, host").bytes, 0U);
}

TEST_F(RayCachingLives, MemoryOfTheCacheIsFixed)
{
  Ball ball(vtkHaspRayCachingMapper::Cache);
  ball.Draw();
  const std::size_t bytes = Find(ball.Raycaster, "ray cache").bytes;
  for (int frame = 0; frame < 100; ++frame)
  {
    ball.Renderer->GetActiveCamera()->Azimuth(3.6);
    ball.Raycaster->SetIsoValue(frame % 10 * 30.0);
    ball.Draw();
    ASSERT_EQ(Find(ball.Raycaster, "ray cache").bytes, bytes);
  }
}

TEST_F(RayCachingLives, MappersComeAndGo)
{
  Ball ball(vtkHaspRayCachingMapper::Cache);
  ball.Draw();
  std::array<int, 3> names{};
  for (int n = 0; n < 100; ++n)
  {
    vtkNew<vtkHaspRayCachingMapper> mapper;
    mapper->SetInputData(ball.Raycaster->GetImage());
    mapper->SetIsoValue(0.0);
    mapper->SetModeToCache();
    ball.Actor->SetMapper(mapper);
    ASSERT_TRUE(ball.Shows());
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    mapper->ReleaseGraphicsResources(ball.Window);
    if (n == 1)
      names = Names(ball.Window);
  }
  EXPECT_EQ(Names(ball.Window), names);
}

TEST_F(RayCachingLives, OneCacheServesTwoWindows)
{
  Ball first(vtkHaspRayCachingMapper::Cache);
  for (int frame = 0; frame < 30; ++frame)
    first.Draw();
  const std::size_t bytes = Find(first.Raycaster, "ray cache").bytes;
  {
    Ball second(vtkHaspRayCachingMapper::Cache);
    second.Actor->SetMapper(first.Raycaster);
    EXPECT_TRUE(second.Shows()); // complete in the first frame
    for (int frame = 0; frame < 3; ++frame)
      second.Draw();
    EXPECT_FALSE(first.Raycaster->IsRefining());
    EXPECT_EQ(Find(first.Raycaster, "ray cache").bytes, bytes);
  }
  EXPECT_TRUE(first.Shows());
  EXPECT_TRUE(first.Errors.empty());
}

TEST_F(RayCachingLives, AnotherImageStartsAnew)
{
  Ball ball(vtkHaspRayCachingMapper::Cache);
  EXPECT_TRUE(ball.Shows());
  const hasp::GridGeometry small{ { 10, 10, 10 }, { 100, 100, 100 }, { 1, 1, 1 }, glm::dmat3(1) };
  ball.Raycaster->SetInputData(hasp::MakeImage(small, std::vector<float>(small.Size(), 1.0F)));
  EXPECT_FALSE(ball.Shows());
  vtkNew<vtkImageData> doubles;
  doubles->SetDimensions(9, 9, 9);
  doubles->AllocateScalars(VTK_DOUBLE, 1);
  ball.Raycaster->SetInputData(doubles);
  ball.Draw();
  ball.Draw();
  EXPECT_EQ(ball.Errors.size(), 1U); // said once
}

/// --explain shows it.
TEST_F(RayCachingLives, SaysWhatDrewAndTheShareOfTheCache)
{
  const auto drawnBy = [](vtkHaspRayCachingMapper* mapper)
  { return Find(mapper, "drawn by").reason; };
  Ball ball(vtkHaspRayCachingMapper::Cache);
  EXPECT_EQ(drawnBy(ball.Raycaster), "nothing drawn");
  ball.Draw();
  EXPECT_NE(drawnBy(ball.Raycaster).find("; all pixels from the cache, which held 0.00 % of what "),
    std::string::npos)
    << "rays found an empty cache: " << drawnBy(ball.Raycaster);
  for (int frame = 0; frame < 60; ++frame)
    ball.Draw();
  EXPECT_NE(
    drawnBy(ball.Raycaster).find("; all pixels from the cache, which held 100.00 % of what "),
    std::string::npos)
    << drawnBy(ball.Raycaster);
  ball.Raycaster->SetModeToRaycast();
  ball.Draw();
  EXPECT_EQ(drawnBy(ball.Raycaster), "raycast: asked for; no pixel from the cache");
}

TEST_F(RayCachingLives, NoResourceIsListedTwice)
{
  for (const int mode : { vtkHaspRayCachingMapper::Automatic, vtkHaspRayCachingMapper::Cache,
         vtkHaspRayCachingMapper::RaycastSkipping })
  {
    Ball ball(mode);
    ball.Draw();
    hasp::ResourceList list;
    ball.Raycaster->ListResources(list);
    std::set<std::string> names;
    for (const hasp::ResourceUse& use : list)
      EXPECT_TRUE(names.insert(use.resource).second) << use.resource << ", mode " << mode;
    EXPECT_TRUE(names.contains("min-max blocks"));
  }
  Ball cache(vtkHaspRayCachingMapper::Cache), automatic(vtkHaspRayCachingMapper::Automatic);
  cache.Draw();
  automatic.Draw();
  EXPECT_EQ(Find(automatic.Raycaster, "min-max blocks").bytes,
    2 * Find(cache.Raycaster, "min-max blocks").bytes)
    << "those of the mapper inside are not left out";
}

/// A still picture: all of it in the first frame, and the second finds nothing new.
TEST_F(RayCachingLives, ARayAPixelCompletesAPictureAtOnce)
{
  Ball ball(vtkHaspRayCachingMapper::Cache);
  ball.Raycaster->SetRaysPerTile(256);
  EXPECT_LE(ball.FramesToRest(), 3);
  ball.Draw();
  const auto judged = ball.Judge(ball.Truth());
  EXPECT_GT(judged.surface, 1000);
  EXPECT_LE(judged.missed + judged.invented, 1);
}

/// All of the surface in every frame, while it tries what is faster, and afterwards.
TEST_F(RayCachingLives, AutomaticAlwaysShowsTheWhole)
{
  Ball ball(vtkHaspRayCachingMapper::Automatic);
  ball.Draw();
  const auto truth = ball.Truth();
  for (int frame = 0; frame < 40; ++frame)
  {
    ball.Draw();
    const auto judged = ball.Judge(truth);
    ASSERT_GT(judged.surface, 1000);
    ASSERT_LE(judged.missed + judged.invented, 1) << "frame " << frame;
  }
  EXPECT_NE(ball.Raycaster->GetModeChoice().find(" ms"), std::string::npos);
}

TEST_F(RayCachingLives, AnotherRendererIsMeasuredAnew)
{
  Ball ball(vtkHaspRayCachingMapper::Automatic);
  const auto unknown = [&]
  { return ball.Raycaster->GetModeChoice().find("cache not measured") != std::string::npos; };
  for (int frame = 0; frame < 6; ++frame)
    ball.Draw();
  ASSERT_FALSE(unknown()) << ball.Raycaster->GetModeChoice();
  ball.Raycaster->SetRenderer(ball.Raycaster->GetRenderer());
  ball.Draw();
  EXPECT_FALSE(unknown()) << "it is the same one";
  ball.Raycaster->SetRenderer(vtkHaspClusteredCellMapper::Rasterize);
  ball.Draw();
  EXPECT_TRUE(unknown()) << ball.Raycaster->GetModeChoice();
}

TEST_F(RayCachingLives, TheFasterWayIsChosen)
{
  for (const bool cacheIsFaster : { false, true })
    for (const bool changed : { false, true })
    {
      DrawingChoice choice;
      for (int n = 0; n < 2; ++n)
      {
        EXPECT_FALSE(choice.Next(changed, true).cache);
        EXPECT_TRUE(choice.Next(changed, true).whole);
        choice.WholeTook(changed, n == 0 ? 500 : 50); // the first frame compiles shaders
      }
      for (int n = 0; n < 2; ++n)
      {
        EXPECT_TRUE(choice.Next(changed, true).cache);
        EXPECT_TRUE(choice.Next(changed, true).whole) << "the picture must be complete";
        choice.CacheTook(changed, n == 0 ? 500 : cacheIsFaster ? 49 : 51);
      }
      EXPECT_EQ(choice.Next(changed, true).cache, cacheIsFaster);
      EXPECT_EQ(choice.Next(changed, true).whole, !cacheIsFaster);
      EXPECT_EQ(choice.Next(changed, false).whole, !cacheIsFaster || !changed)
        << "at rest a cache that is still filling is not left alone";
      EXPECT_TRUE(choice.Next(!changed, true).whole)
        << "frames of the other kind are measured apart";
      EXPECT_TRUE(choice.MayDraw(true).cache);
      EXPECT_TRUE(choice.MayDraw(true).whole);
    }
}

TEST_F(RayCachingLives, WhatLosesAtRestAndAfterAChangeIsNotKept)
{
  for (const int wins : { 0, 1, 2 }) // of the cache
  {
    DrawingChoice choice;
    for (const int n : { 0, 0, 1, 1 })
    {
      choice.WholeTook(n, 50);
      choice.CacheTook(n, n < wins ? 40 : 60);
    }
    EXPECT_EQ(choice.MayDraw(true).cache, wins > 0);
    EXPECT_EQ(choice.MayDraw(true).whole, wins < 2);
    EXPECT_TRUE(choice.MayDraw(false).whole) << "until the cache is filled";
  }
}

#if HASP_WITH_EMBREE
TEST_F(RayCachingLives, LightLetsTheCacheGo)
{
  Ball ball(vtkHaspRayCachingMapper::Automatic);
  for (int frame = 0; frame < 4; ++frame)
    ball.Draw();
  EXPECT_GT(Find(ball.Raycaster, "ray cache").bytes, 0U);
  ball.Raycaster->ShadowsOn();
  ball.Draw();
  for (const char* name : { "ray cache", "cached cells, host", "depth of the last pictures" })
    EXPECT_EQ(Find(ball.Raycaster, name).bytes, 0U) << name;
  ball.Raycaster->ShadowsOff();
  EXPECT_TRUE(ball.Shows());
}
#endif

} // namespace
