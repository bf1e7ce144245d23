// What a window shows of a scene: as the scene's own window does, layer by layer, prop by prop.
#include "StereoTestScene.h"

#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkRendererCollection.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

namespace
{

using hasp::StereoLayout;
using stereotest::BallsScene;
using stereotest::Bytes;
using stereotest::MakeWindow;
using stereotest::Picture;

const glm::ivec2 Size{ 120, 80 };

TEST(StereoWindows, ShowTheSceneAsItsOwnWindowDoes)
{
  BallsScene scene;
  const auto home = MakeWindow(Size), other = MakeWindow(Size);
  home->AddRenderer(scene.Renderer);
  scene.Windows->AddWindow(home, "left");
  scene.Windows->AddWindow(other, "left");
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes plain = Picture(home);
  EXPECT_EQ(Picture(other), plain);
  scene.Renderer->UseSSAOOn(); // shades what lies in hollows
  scene.Renderer->SetSSAORadius(40.0);
  scene.Renderer->SetSSAOBias(0.5);
  scene.Renderer->SetSSAOKernelSize(64);
  auto* gl = vtkOpenGLRenderer::SafeDownCast(scene.Renderer);
  vtkNew<vtkTexture> around;
  gl->SetEnvironmentTexture(around, true);
  gl->SetEnvironmentUp(0, 0, 1);
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_NE(Picture(home), plain);
  EXPECT_EQ(Picture(other), Picture(home));
  auto* shown = vtkOpenGLRenderer::SafeDownCast(other->GetRenderers()->GetFirstRenderer());
  EXPECT_EQ(shown->GetEnvironmentTexture(), around);
  EXPECT_TRUE(shown->GetEnvMapIrradiance()->GetConvertToLinear());
  EXPECT_EQ(shown->GetEnvironmentUp()[2], 1.0);
}

TEST(StereoWindows, ShowThePropsThatComeAndGo)
{
  BallsScene scene;
  const auto window = MakeWindow(Size);
  scene.Windows->AddWindow(window, "side-by-side");
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes before = Picture(window);
  const auto ball = stereotest::MakeBall({ 20, -200, 20 }, 25);
  scene.Renderer->AddActor(ball);
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_NE(Picture(window), before);
  scene.Renderer->RemoveActor(ball);
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(window), before);
}

TEST(StereoWindows, DrawPropsInTheScenesOrder)
{
  BallsScene scene;
  const auto home = MakeWindow(Size), other = MakeWindow(Size);
  home->AddRenderer(scene.Renderer);
  scene.Windows->AddWindow(home, "left");
  scene.Windows->AddWindow(other, "left");
  const auto below = stereotest::MakeBall({ 0, -300, 0 }, 25, { 1, 0, 0 });
  const auto above = stereotest::MakeBall({ 0, -300, 0 }, 25, { 0, 1, 0 }); // hides it: drawn later
  scene.Renderer->AddActor(below);
  scene.Renderer->AddActor(above);
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes first = Picture(home);
  EXPECT_EQ(Picture(other), first);
  scene.Renderer->RemoveActor(below);
  scene.Renderer->AddActor(below);
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_NE(Picture(home), first);
  EXPECT_EQ(Picture(other), Picture(home));
  EXPECT_EQ(below->GetNumberOfConsumers(), 2) << "both renderers";
}

TEST(StereoWindows, ShowLayersOfTheSameCameraToEachEyeToo)
{
  BallsScene one, two; // all in one renderer; a part of it in the layer above
  const auto whole = MakeWindow(Size), layered = MakeWindow(Size);
  whole->AddRenderer(one.Renderer);
  layered->AddRenderer(two.Renderer);
  const auto near = stereotest::MakeBall({ 20, -300, 20 }, 15, { 1, 0, 0 });
  one.Renderer->AddActor(near); // nearer than all others, so that layers hide nothing else
  vtkNew<vtkRenderer> above;
  vtkCamera* camera = two.Renderer->GetActiveCamera();
  above->SetActiveCamera(camera);
  above->SetLayer(1);
  above->AddActor(stereotest::MakeBall({ 20, -300, 20 }, 15, { 1, 0, 0 }));
  layered->SetNumberOfLayers(2);
  layered->AddRenderer(above);
  for (const StereoLayout layout : { StereoLayout::SideBySide, StereoLayout::Right })
  {
    one.Windows->AddWindow(whole, { { layout } });
    two.Windows->AddWindow(layered, { { layout } });
    ASSERT_TRUE(one.Windows->Render());
    ASSERT_TRUE(two.Windows->Render());
    EXPECT_EQ(Picture(layered), Picture(whole));
    EXPECT_EQ(above->GetActiveCamera(), camera);
  }
}
} // namespace
