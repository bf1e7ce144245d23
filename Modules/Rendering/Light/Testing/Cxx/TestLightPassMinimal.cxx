// What a mode does not need is not there: no environment, no kept light, no paths, no thread; and
// without a pass there is nothing at all.
#include "LightTestScene.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{

using hasp::testing::LightTestScene;

int Threads()
{
  int count = 0;
  for ([[maybe_unused]] const auto& thread : std::filesystem::directory_iterator("/proc/self/task"))
    ++count;
  return count;
}

struct BallScene : LightTestScene
{
  BallScene()
  {
    this->AddCellBall(20, { 0, 0, 0 }, 0.8);
    this->AddLamp({ 0, -100, 100 });
    this->Look({ 0, -130, 60 });
  }
  std::size_t Bytes(const std::string& name) const
  {
    return this->Resource("light, " + name).bytes;
  }
};

TEST(LightPassMinimal, BeforeTheFirstFrameThereIsNothing)
{
  const BallScene scene;
  for (const char* name : { "trees", "environment", "kept", "paths", "picture" })
    EXPECT_EQ(scene.Bytes(name), 0U) << name;
}

TEST(LightPassMinimal, LampsHaveNoEnvironmentAndKeepNothing)
{
  BallScene scene;
  scene.Pass->SetModeToLamps();
  scene.Draw(2);
  EXPECT_GT(scene.Bytes("trees"), 0U);
  for (const char* name : { "environment", "kept", "paths" })
    EXPECT_EQ(scene.Bytes(name), 0U) << name;
}

TEST(LightPassMinimal, AmbientOcclusionHasNoEnvironmentAndNoPaths)
{
  BallScene scene;
  scene.Pass->SetModeToAmbientOcclusion();
  scene.Draw(2);
  EXPECT_GT(scene.Bytes("kept"), 0U);
  EXPECT_EQ(scene.Bytes("environment"), 0U);
  EXPECT_EQ(scene.Bytes("paths"), 0U);
}

TEST(LightPassMinimal, PathsAloneKeepNothingAndTheirThreadEnds)
{
  BallScene scene;
  scene.Pass->SetModeToTraced();
  scene.Draw(2);
  EXPECT_EQ(scene.Bytes("paths"), 0U);
  const int before = Threads(); // of VTK, OpenGL and the cores
  scene.Pass->SetModeToPathTraced();
  scene.Pass->TemporalAccumulationOff();
  scene.Pass->SetSamplesPerPixel(2);
  scene.Pass->WaitForSamplesOn();
  scene.Draw();
  EXPECT_GT(scene.Bytes("paths"), 0U);
  EXPECT_EQ(scene.Bytes("kept"), 0U);
  scene.Pass->SetModeToLamps();
  scene.Draw();
  EXPECT_LE(Threads(), before);
  for (const char* name : { "environment", "kept", "paths" })
    EXPECT_EQ(scene.Bytes(name), 0U) << name;
  BallScene lamps; // the picture is as large as if there had never been paths: no background
  lamps.Pass->SetModeToLamps();
  lamps.Draw();
  EXPECT_EQ(scene.Bytes("picture"), lamps.Bytes("picture"));
}

TEST(LightPassMinimal, WithoutAPassMappersHoldNoLight)
{
  BallScene scene;
  scene.Renderer->SetPass(nullptr);
  scene.Draw(2);
  for (const char* name : { "trees", "environment", "kept", "paths", "picture" })
    EXPECT_EQ(scene.Bytes(name), 0U) << name;
}

} // namespace
