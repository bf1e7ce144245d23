#include "StereoTestScene.h"

#include "vtkOpenGLRenderWindow.h"
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using hasp::StereoLayout;
using hasp::StereoResolution;
using stereotest::BallsScene;
using stereotest::Bytes;
using stereotest::MakeWindow;
using stereotest::Picture;

const glm::ivec2 Size{ 120, 80 };

TEST(StereoWindows, SayWhatIsWrongOnce)
{
  BallsScene scene;
  EXPECT_FALSE(scene.Windows->Render()) << "there is no window";
  EXPECT_EQ(scene.Errors, 0);
  const auto window = MakeWindow(Size);
  EXPECT_FALSE(scene.Windows->AddWindow(nullptr, hasp::StereoWindow{}));
  EXPECT_FALSE(scene.Windows->AddWindow(window, "quad"));
  EXPECT_FALSE(scene.Windows->AddWindow(window, "dual-window"));
  EXPECT_FALSE(scene.Windows->AddDualWindow(window, window, {}));
  EXPECT_FALSE(scene.Windows->AddDualWindow(window, nullptr, {}));
  hasp::StereoWindow broken;
  broken.screen.emplace().widthMm = 0.0;
  EXPECT_FALSE(scene.Windows->AddWindow(window, broken));
  EXPECT_EQ(scene.Errors, 6);
  EXPECT_EQ(scene.Windows->GetNumberOfWindows(), 0);

  hasp::StereoWindow good;
  good.screen.emplace();
  ASSERT_TRUE(scene.Windows->AddWindow(window, good));
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes before = Picture(window);
  scene.Windows->SetHead({ { 0, 0, -5 } });
  for (int frame = 0; frame < 3; ++frame)
    EXPECT_FALSE(scene.Windows->Render());
  double eye[3], through[3];
  for (int move = 0; move < 3; ++move)
    EXPECT_FALSE(scene.Windows->GetRay(window, move, 10, eye, through));
  EXPECT_EQ(scene.Errors, 7) << "once, not once a frame or a mouse's move";
  EXPECT_EQ(Picture(window), before) << "the view stays";
  scene.Windows->SetHead({ { 0, 0, NAN } });
  EXPECT_FALSE(scene.Windows->Render());
  EXPECT_EQ(scene.Errors, 8);
  scene.Windows->SetHead({});
  EXPECT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(window), before);
  scene.Windows->SetRenderer(nullptr);
  EXPECT_FALSE(scene.Windows->Render());
}

TEST(StereoWindows, WithoutQuadBuffersSayWhatToDo)
{
  BallsScene scene;
  const auto window = MakeWindow(Size);
  ASSERT_TRUE(scene.Windows->AddWindow(window, "quad-buffer"));
  EXPECT_FALSE(scene.Windows->Render()); // StereoCapableWindowOn was not called
  EXPECT_EQ(scene.Errors, 1);
}

TEST(StereoWindows, ShowTheSameSceneInEach)
{
  BallsScene scene;
  std::vector<vtkSmartPointer<vtkRenderWindow>> windows;
  std::vector<Bytes> alone;
  const StereoLayout layouts[] = { StereoLayout::SideBySide, StereoLayout::Interlaced,
    StereoLayout::Left };
  for (const StereoLayout layout : layouts) // one after the other, the scene's renderer in it
  {
    windows.push_back(MakeWindow({ Size.x + 10 * int(layout), Size.y }));
    windows.back()->AddRenderer(scene.Renderer);
    scene.Windows->AddWindow(windows.back(), { { layout } });
    EXPECT_TRUE(scene.Windows->Render());
    alone.push_back(Picture(windows.back()));
    scene.Windows->RemoveWindow(windows.back());
    windows.back()->RemoveRenderer(scene.Renderer);
  }
  for (const int home : { -1, 0, 2 }) // all at once; the scene's renderer in one or none of them
  {
    if (home >= 0)
      windows[home]->AddRenderer(scene.Renderer);
    for (std::size_t n = 0; n < windows.size(); ++n)
      EXPECT_TRUE(scene.Windows->AddWindow(windows[n], { { layouts[n] } }));
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(scene.Windows->Render());
      for (std::size_t n = 0; n < windows.size(); ++n)
        EXPECT_EQ(Picture(windows[n]), alone[n]) << home << " " << n << " " << frame;
    }
    for (const auto& window : windows)
      scene.Windows->RemoveWindow(window);
    if (home >= 0)
      windows[home]->RemoveRenderer(scene.Renderer);
    for (const auto& window : windows)
      EXPECT_FALSE(window->HasRenderer(scene.Renderer));
  }
  EXPECT_EQ(scene.Errors, 0);
}

TEST(StereoWindows, ADualWindowIsOneEyeEach)
{
  BallsScene scene;
  const auto one = MakeWindow(Size), left = MakeWindow(Size), right = MakeWindow(Size);
  ASSERT_TRUE(scene.Windows->AddDualWindow(left, right, {}));
  ASSERT_TRUE(scene.Windows->AddWindow(one, "left"));
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes leftEye = Picture(one);
  EXPECT_EQ(Picture(left), leftEye);
  ASSERT_TRUE(scene.Windows->AddWindow(one, "right"));
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(right), Picture(one));
  EXPECT_NE(Picture(right), leftEye);
  hasp::StereoWindow swapped;
  swapped.output.swapEyes = true;
  ASSERT_TRUE(scene.Windows->AddDualWindow(left, right, swapped));
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(right), leftEye);
  EXPECT_EQ(scene.Windows->GetNumberOfWindows(), 3);
}

TEST(StereoWindows, QuadBuffersHoldBothEyes)
{
  BallsScene scene;
  const auto window = MakeWindow(Size), one = MakeWindow(Size);
  window->StereoCapableWindowOn();
  ASSERT_TRUE(scene.Windows->AddWindow(window, "quad-buffer"));
  ASSERT_TRUE(scene.Windows->AddWindow(one, "left"));
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(window, false), Picture(one));
  ASSERT_TRUE(scene.Windows->AddWindow(one, "right"));
  ASSERT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(window, true), Picture(one));
  EXPECT_NE(Picture(window, true), Picture(window, false));
  EXPECT_FALSE(window->GetStereoRender());
}

TEST(StereoWindows, GiveBackWhatTheyBorrow)
{
  BallsScene scene;
  const auto window = MakeWindow(Size);
  window->AddRenderer(scene.Renderer);
  scene.Renderer->SetViewport(0.25, 0.1, 0.75, 0.9);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  window->SetStereoTypeToInterlaced();
  window->SetStereoRender(true);
  const vtkMTimeType before = camera->GetMTime();
  for (const StereoLayout layout : { StereoLayout::SideBySide, StereoLayout::Mono,
         StereoLayout::Checkerboard, StereoLayout::Anaglyph })
  {
    scene.Windows->AddWindow(window, { { layout, StereoResolution::Half } });
    EXPECT_TRUE(scene.Windows->Render());
    EXPECT_EQ(scene.Renderer->GetActiveCamera(), camera);
    EXPECT_EQ(camera->GetMTime(), before);
    EXPECT_TRUE(window->GetStereoRender());
    EXPECT_EQ(window->GetStereoType(), VTK_STEREO_INTERLACED);
    EXPECT_TRUE(window->GetSwapBuffers());
    const double* viewport = scene.Renderer->GetViewport();
    EXPECT_EQ(glm::dvec4(viewport[0], viewport[1], viewport[2], viewport[3]),
      glm::dvec4(0.25, 0.1, 0.75, 0.9));
  }
}

TEST(StereoWindows, ComposeWithinTheScenesViewport)
{
  BallsScene whole, part;
  const auto one = MakeWindow({ 60, 64 }), two = MakeWindow({ 120, 80 });
  one->AddRenderer(whole.Renderer);
  two->AddRenderer(part.Renderer);
  part.Renderer->SetViewport(0.25, 0.1, 0.75, 0.9);
  vtkNew<vtkRenderer> beside; // is not touched
  beside->SetViewport(0.75, 0.0, 1.0, 1.0);
  beside->SetBackground(1, 0, 0);
  two->AddRenderer(beside);
  vtkNew<vtkRenderer> overlay; // nothing in it; squeezed along
  overlay->SetLayer(1);
  overlay->SetViewport(0.25, 0.1, 0.75, 0.9);
  two->SetNumberOfLayers(2);
  two->AddRenderer(overlay);
  for (const StereoLayout layout : { StereoLayout::SideBySide, StereoLayout::Interlaced })
  {
    whole.Windows->AddWindow(one, { { layout, StereoResolution::Half } });
    part.Windows->AddWindow(two, { { layout, StereoResolution::Half } });
    ASSERT_TRUE(whole.Windows->Render());
    ASSERT_TRUE(part.Windows->Render());
    const Bytes expected = Picture(one), got = Picture(two);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 3 * 60; ++x)
        ASSERT_EQ(got[3 * ((y + 8) * 120 + 30) + x], expected[3 * y * 60 + x]) << x << " " << y;
    EXPECT_EQ(got[3 * (40 * 120 + 110)], 255);
    EXPECT_EQ(got[3 * (40 * 120 + 110) + 1], 0);
  }
}

TEST(StereoWindows, FollowTheWindowsSize)
{
  BallsScene scene;
  const auto window = MakeWindow(Size);
  window->AddRenderer(scene.Renderer);
  scene.Windows->AddWindow(window, { { StereoLayout::Checkerboard, StereoResolution::Half } });
  ASSERT_TRUE(scene.Windows->Render());
  const Bytes before = Picture(window);
  for (const glm::ivec2 size : { glm::ivec2(1, 1), glm::ivec2(301, 7), glm::ivec2(2, 2), Size })
  {
    window->SetSize(size.x, size.y);
    EXPECT_TRUE(scene.Windows->Render());
  }
  EXPECT_EQ(Picture(window), before);
  window->Finalize(); // its context, and all that was in it, is gone
  EXPECT_TRUE(scene.Windows->Render());
  EXPECT_EQ(Picture(window), before);
  EXPECT_EQ(scene.Errors, 0);
}

TEST(StereoWindows, MayBeDeletedInAnyOrder)
{
  for (int order = 0; order < 4; ++order)
  {
    auto scene = std::make_unique<BallsScene>();
    auto first = MakeWindow(Size), second = MakeWindow(Size);
    first->AddRenderer(scene->Renderer);
    scene->Windows->AddWindow(first, "interlaced");
    scene->Windows->AddWindow(second, "side-by-side");
    ASSERT_TRUE(scene->Windows->Render());
    if (order == 0)
      scene.reset();
    else if (order == 1)
      first = nullptr;
    else if (order == 2)
      second = nullptr;
    else
      first = second = nullptr;
    if (scene)
    {
      EXPECT_EQ(scene->Windows->GetNumberOfWindows(), order == 3 ? 0 : 1);
      EXPECT_EQ(scene->Windows->Render(), order != 3);
      EXPECT_EQ(scene->Errors, 0);
    }
  }
}

TEST(StereoWindows, LeaveNothingBehindAndNoErrorInOpenGL)
{
  const auto window = MakeWindow({ 30, 20 });
  BallsScene scene;
  window->AddRenderer(scene.Renderer);
  const auto alive = [&]
  {
    vtkOpenGLRenderWindow::SafeDownCast(window)->MakeCurrent();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glm::uvec2 count(0); // textures, framebuffers; drivers number them from 1 on
    for (GLuint name = 1; name < 10000; ++name)
      count += glm::uvec2(glIsTexture(name), glIsFramebuffer(name));
    return count;
  };
  glm::uvec2 early{};
  for (int round = 0; round < 100; ++round)
  {
    vtkNew<vtkHaspStereoWindows> windows;
    windows->SetRenderer(scene.Renderer);
    hasp::StereoWindow settings{ { StereoLayout::Anaglyph } };
    settings.lens = hasp::LensModel{ { 0.1, 0.0, 0.0 } };
    windows->AddWindow(window, settings);
    ASSERT_TRUE(windows->Render());
    windows->RemoveWindow(window);
    if (round == 2)
      early = alive();
  }
  EXPECT_EQ(alive(), early);
}

} // namespace
