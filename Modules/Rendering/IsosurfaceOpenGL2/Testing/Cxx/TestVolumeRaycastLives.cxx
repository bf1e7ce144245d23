// What a raycast holds comes once, stays as long as it is drawn, and goes; OpenGL is left as it
// was.
#include "HaspGL.h"
#include "RaycastTestScene.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"

#include <array>
#include <memory>
#include <utility>

namespace
{

using hasp::testing::Find;
using hasp::testing::Names;
using hasp::testing::RaycastModes;
using hasp::testing::RaycastScene;

struct BallScene : RaycastScene
{
  BallScene()
  {
    const hasp::GridGeometry g{ { 40, 36, 44 }, { -19.5, -17.5, -21.5 }, { 1, 1, 1 },
      glm::dmat3(1) };
    this->Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 14), g);
    this->Look({ 0, -60, 0 }, { 0, 0, 0 }, 10, 120);
  }
  double Front() // y of the surface in the middle
  {
    this->Draw();
    const auto point = this->Point(PixelsX / 2, PixelsY / 2);
    return point ? point->y : 1e9;
  }
};

class RaycastLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(RaycastLives, AnotherIsovalueUploadsNothing)
{
  BallScene scene;
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    scene.Raycaster->SetIsoValue(0);
    scene.Draw();
    const auto samples = Find(scene.Raycaster, "raycast samples, GPU");
    const auto blocks = Find(scene.Raycaster, "raycast min-max blocks, GPU");
    EXPECT_EQ(samples.bytes, 2U * 40 * 36 * 44);
    EXPECT_EQ(blocks.bytes, mode == vtkHaspRayCachingMapper::Raycast ? 0U : 8U * 5 * 5 * 6);
    for (int n = 0; n < 5; ++n)
    {
      scene.Raycaster->SetIsoValue(100 * n); // the ball has 100 a mm
      EXPECT_NEAR(scene.Front(), -(14 - n), 0.05);
      EXPECT_EQ(Find(scene.Raycaster, "raycast samples, GPU").milliseconds, samples.milliseconds);
      EXPECT_EQ(
        Find(scene.Raycaster, "raycast min-max blocks, GPU").milliseconds, blocks.milliseconds);
    }
    for (const double beyond : { 1e6, -1e6 })
    {
      scene.Raycaster->SetIsoValue(beyond);
      EXPECT_FALSE(scene.Shows());
    }
  }
  EXPECT_TRUE(scene.Errors.empty());
}

TEST_F(RaycastLives, AnEditUploadsItsBoxAlone)
{
  for (const int mode : RaycastModes)
  {
    BallScene scene, other;
    scene.Raycaster->SetMode(mode);
    other.Actor->SetMapper(scene.Raycaster); // a second window
    EXPECT_NEAR(scene.Front(), -14, 0.05);
    EXPECT_NEAR(other.Front(), -14, 0.05);
    vtkImageData* image = scene.Raycaster->GetImage();
    for (int z = 10; z < 34; ++z)
      for (int y = 0; y < 10; ++y)
        for (int x = 8; x < 32; ++x)
          image->SetScalarComponentFromDouble(x, y, z, 0, -500); // 8 mm of the ball's front
    const auto samples = Find(scene.Raycaster, "raycast samples, GPU");
    const int extent[6] = { 8, 31, 0, 9, 10, 33 };
    image->Modified();
    scene.Raycaster->MarkModified(extent);
    const double front = scene.Front();
    EXPECT_GT(front, -8.5);
    EXPECT_LT(front, -7.5);
    EXPECT_EQ(other.Front(), front);
    EXPECT_EQ(Find(scene.Raycaster, "raycast samples, GPU").bytes, samples.bytes);
    // The whole volume anew shows the same.
    image->Modified();
    EXPECT_EQ(scene.Front(), front);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST_F(RaycastLives, IsNotThereUntilAskedForAndGoneAfterwards)
{
  BallScene scene;
  const char* const names[] = { "raycast samples, GPU", "raycast min-max blocks, GPU",
    "shader: raycast" };
  const auto expectNothing = [&]
  {
    for (const char* name : names)
    {
      EXPECT_EQ(Find(scene.Raycaster, name).bytes, 0U) << name;
      EXPECT_EQ(Find(scene.Raycaster, name).milliseconds, 0.0) << name;
    }
  };
  scene.Raycaster->SetModeToCache();
  scene.Draw();
  expectNothing();
  EXPECT_GT(Find(scene.Raycaster, "ray cache").bytes, 0U);

  scene.Raycaster->SetModeToRaycastSkipping();
  EXPECT_TRUE(scene.Shows());
  EXPECT_EQ(scene.Raycaster->GetModeChoice(), "raycast with skipping: asked for");
  EXPECT_FALSE(scene.Raycaster->IsRefining());
  EXPECT_EQ(Find(scene.Raycaster, "ray cache").bytes, 0U);
  EXPECT_EQ(Find(scene.Raycaster, "cached cells, host").bytes, 0U);
  EXPECT_GT(Find(scene.Raycaster, "raycast min-max blocks, GPU").bytes, 0U);
  scene.Raycaster->SetModeToRaycast();
  EXPECT_TRUE(scene.Shows());
  EXPECT_EQ(scene.Raycaster->GetModeChoice(), "raycast: asked for");
  EXPECT_GT(Find(scene.Raycaster, "raycast samples, GPU").bytes, 0U);
  EXPECT_EQ(Find(scene.Raycaster, "raycast min-max blocks, GPU").bytes, 0U);

  scene.Raycaster->SetModeToAutomatic();
  EXPECT_TRUE(scene.Shows());
  expectNothing();
  scene.Raycaster->SetModeToRaycast();
  EXPECT_TRUE(scene.Shows());
  scene.Window->Finalize();
  expectNothing();
}

TEST_F(RaycastLives, ComesAndGoesTwentyTimes)
{
  BallScene scene;
  scene.Actor->VisibilityOff();
  scene.Draw();
  scene.Actor->VisibilityOn();
  const auto before = Names(scene.Window);
  for (int n = 0; n < 20; ++n)
  {
    scene.Raycaster->SetMode(RaycastModes[n % 2]);
    ASSERT_TRUE(scene.Shows()) << n;
    EXPECT_GT(Names(scene.Window), before);
    scene.Raycaster->ReleaseGraphicsResources(scene.Window);
    EXPECT_EQ(Names(scene.Window), before) << n;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << n;
  }
  EXPECT_TRUE(scene.Errors.empty());
}

TEST_F(RaycastLives, EachWindowHoldsItsOwn)
{
  BallScene first;
  auto second = std::make_unique<BallScene>();
  second->Actor->SetMapper(first.Raycaster);
  for (int n = 0; n < 2; ++n)
  {
    EXPECT_TRUE(first.Shows());
    EXPECT_TRUE(second->Shows());
  }
  const std::size_t both = Find(first.Raycaster, "raycast samples, GPU").bytes;
  second->Actor->SetMapper(nullptr); // now nothing tells the mapper that the window goes
  second.reset();
  EXPECT_TRUE(first.Shows());
  EXPECT_EQ(Find(first.Raycaster, "raycast samples, GPU").bytes, both / 2);
}

TEST_F(RaycastLives, OpenGLIsLeftAsItWasFound)
{
  const GLenum switches[] = { GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST };
  const GLenum values[] = { GL_ACTIVE_TEXTURE, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
    GL_DRAW_FRAMEBUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES };
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  window->GetRenderFramebuffer()->Bind();
  const auto state = [&]
  {
    std::vector<GLint> all;
    for (const GLenum name : switches)
      all.push_back(glIsEnabled(name));
    for (const GLenum name : values)
      glGetIntegerv(name, &all.emplace_back());
    vtkOpenGLState::ScopedglActiveTexture unit(window->GetState());
    for (int n = 0; n < 16; ++n)
    {
      window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + n);
      glGetIntegerv(GL_TEXTURE_BINDING_3D, &all.emplace_back());
    }
    return all;
  };
  const auto before = state();
  for (const int mode : RaycastModes)
    for (const bool upload : { true, false })
    {
      if (upload)
        scene.Raycaster->GetImage()->Modified();
      scene.Raycaster->SetMode(mode);
      scene.Raycaster->Render(scene.Renderer, scene.Actor);
      EXPECT_EQ(state(), before) << mode << " " << upload;
    }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(RaycastLives, WhatIsNotDrawnIsSaidOnce)
{
  BallScene scene;
  scene.Actor->GetProperty()->SetOpacity(0.5);
  for (int n = 0; n < 3; ++n)
    EXPECT_FALSE(scene.Shows());
  ASSERT_EQ(scene.Errors.size(), 1U);
  EXPECT_NE(
    scene.Errors[0].find("vtkHaspClusteredCellMapper draws translucent ones"), std::string::npos);
  EXPECT_EQ(scene.Raycaster->GetModeChoice(), "nothing drawn");
  scene.Actor->GetProperty()->SetOpacity(1.0);
  EXPECT_TRUE(scene.Shows());
  scene.Actor->GetProperty()->SetOpacity(0.5);
  EXPECT_FALSE(scene.Shows());
  EXPECT_EQ(scene.Errors.size(), 2U) << "it was right in between";
  scene.Actor->GetProperty()->SetOpacity(1.0);
  scene.Raycaster->SetIsoValue(std::nan(""));
  EXPECT_FALSE(scene.Shows());
  EXPECT_EQ(scene.Errors.size(), 3U);
}

TEST_F(RaycastLives, WindowsOfAnySize)
{
  BallScene scene;
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    for (const auto& [width, height] : { std::pair{ 1, 1 }, { 3, 1 }, { 0, 0 }, { 1024, 16 } })
    {
      scene.Window->SetSize(width, height);
      scene.Window->Render();
    }
    scene.Window->SetSize(BallScene::PixelsX, BallScene::PixelsY);
    EXPECT_TRUE(scene.Shows());
  }
  EXPECT_TRUE(scene.Errors.empty());
}

TEST_F(RaycastLives, SlicesHaveNoSurface)
{
  BallScene scene;
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(20, 20, 1);
  slice->AllocateScalars(VTK_SHORT, 1);
  scene.Raycaster->SetInputData(slice);
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    EXPECT_FALSE(scene.Shows());
  }
  EXPECT_TRUE(scene.Errors.empty());
}

} // namespace
