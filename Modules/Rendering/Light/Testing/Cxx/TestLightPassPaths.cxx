// Pictures by paths: their edges, their exposure, marks, and giving them up.
#include "LightTestScene.h"

#include "vtkCommand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace
{

using hasp::testing::LightTestScene;

struct Call : vtkCommand
{
  static Call* New() { return new Call; }
  std::function<void()> What;
  int Count = 0;
  void Execute(vtkObject*, unsigned long, void*) override
  {
    ++this->Count;
    if (this->What)
      this->What();
  }
};

glm::ivec3 ColorAt(vtkUnsignedCharArray* pixels, vtkIdType n)
{
  return { pixels->GetTypedComponent(n, 0), pixels->GetTypedComponent(n, 1),
    pixels->GetTypedComponent(n, 2) };
}

TEST(LightPassPaths, SmoothEdgesShowTheBackgroundAndNotWhatWasDrawn)
{
  for (const int samples : { 0, 4 })
    for (const bool kept : { false, true })
    {
      const bool gradient = kept == (samples == 0); // which VTK draws; else it clears, with alpha 0
      LightTestScene scene;
      scene.Window->SetMultiSamples(samples);
      scene.Renderer->SetBackground(0, 0, 0.5);
      scene.Renderer->SetBackground2(0, 0, 1.0);
      scene.Renderer->SetGradientBackground(gradient);
      scene.AddCellBall(20, { -15, 0, 0 });
      scene.AddMeshBall(20, { 15, 0, 10 });
      scene.AddLamp({ 0, -100, 0 })->SetColor(0, 1, 0); // what mappers draw is green
      scene.Look({ 0, -130, 1 });
      scene.Pass->SetModeToPathTraced();
      scene.Pass->SetSamplesPerPixel(16);
      scene.Pass->WaitForSamplesOn();
      scene.Pass->SetTemporalAccumulation(kept);
      scene.Pass->SetExposure(1e-30); // and what paths see is black
      const auto pixels = scene.Draw();
      int edges = 0, left = 0;
      for (vtkIdType n = 0; n < pixels->GetNumberOfTuples(); ++n)
      {
        const glm::ivec3 color = ColorAt(pixels, n);
        ASSERT_LE(color.g, samples > 0 ? 64 : 0) << n; // one of four samples, that no path met
        edges += color.b > 0 && color.b < 126;
        left += color.g > 0;
      }
      EXPECT_GT(edges, 100);
      EXPECT_LE(left, edges / 5);
      EXPECT_EQ(ColorAt(pixels, 0).b, 128) << "background";
      EXPECT_EQ(scene.Grey(pixels, { -15, -20, 0 }), 0);
    }
}

TEST(LightPassPaths, WhatTakesNoPartComesAndGoesWhenPathsAreDone)
{
  for (const bool kept : { false, true })
  {
    LightTestScene scene;
    scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
    const auto mark = scene.AddMeshBall(5, { 0, -40, 20 });
    mark->GetProperty()->SetColor(0, 1, 0);
    mark->GetProperty()->LightingOff();
    mark->VisibilityOff();
    scene.Look({ 0, -130, 60 });
    scene.Pass->SetModeToPathTraced();
    scene.Pass->SetSamplesPerPixel(8);
    scene.Pass->WaitForSamplesOn();
    scene.Pass->SetTemporalAccumulation(kept);
    const auto without = scene.Draw(8);
    mark->VisibilityOn();
    const auto with = scene.Draw();
    const glm::ivec2 at = scene.PixelOf({ 0, -40, 20 });
    const vtkIdType n = at.y * scene.Width + at.x;
    EXPECT_EQ(ColorAt(with, n), glm::ivec3(0, 255, 0)) << kept;
    mark->VisibilityOff();
    const auto again = scene.Draw();
    EXPECT_NEAR(ColorAt(again, n).r, ColorAt(without, n).r, kept ? 8 : 0) << "lit, not as drawn";
    EXPECT_NEAR(ColorAt(again, n).b, ColorAt(without, n).b, kept ? 8 : 0);
    EXPECT_NE(ColorAt(without, n), glm::ivec3(0, 255, 0));
  }
}

TEST(LightPassPaths, ExposureMultipliesRadiance)
{
  const auto linear = [](int byte) // IEC 61966-2-1
  {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.Look({ 0, -130, 60 });
  for (const int mode : { vtkHaspLightPass::Traced, vtkHaspLightPass::PathTraced })
  {
    scene.Pass->SetMode(mode);
    scene.Pass->SetSamplesPerPixel(64);
    scene.Pass->WaitForSamplesOn();
    const auto light = [&](double exposure)
    {
      scene.Pass->SetExposure(exposure);
      return linear(scene.Grey(scene.Draw(32), { 0, -20, 0 }));
    };
    const double least = light(0.02);
    ASSERT_GT(least, 0.005);
    // 8 bits of sRGB: a share of 0.05 at this grey; at rest the picture is not another.
    EXPECT_NEAR(light(0.04) / least, 2.0, 0.1) << mode;
  }
}

TEST(LightPassPaths, AmbientColoursAreMarksThatLightNothing)
{
  LightTestScene scene;
  const auto mark = scene.AddCellBall(10, { 0, 0, 0 });
  mark->GetProperty()->SetAmbient(1.0);
  mark->GetProperty()->SetDiffuse(0.0);
  mark->GetProperty()->SetAmbientColor(0.2, 0.6, 0.4);
  scene.AddFloor(40, -12, 0.5);
  scene.Look({ 0, -90, 60 });
  for (const int mode : { vtkHaspLightPass::Lamps, vtkHaspLightPass::AmbientOcclusion,
         vtkHaspLightPass::Traced, vtkHaspLightPass::PathTraced })
  {
    scene.Pass->SetMode(mode);
    scene.Pass->SetSamplesPerPixel(8);
    scene.Pass->WaitForSamplesOn();
    const auto pixels = scene.Draw(4);
    const glm::ivec2 at = scene.PixelOf({ 0, -6, 8 });
    const glm::ivec3 color = ColorAt(pixels, at.y * scene.Width + at.x);
    EXPECT_NEAR(color.r, 51, 1) << mode;
    EXPECT_NEAR(color.g, 153, 1) << mode;
    EXPECT_NEAR(color.b, 102, 1) << mode;
    const glm::ivec2 below = scene.PixelOf({ 0, -12, -12 });
    const glm::ivec3 floor = ColorAt(pixels, below.y * scene.Width + below.x);
    EXPECT_LE(floor.g, std::max(floor.r, floor.b) + 12) << "not greened, but for the sky's blue";
  }
}

TEST(LightPassPaths, WaitingIsGivenUpWhenTheWindowIsAskedTo)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.Look({ 0, -130, 60 });
  scene.Pass->SetModeToPathTraced();
  scene.Pass->SetSamplesPerPixel(1 << 16);
  scene.Pass->WaitForSamplesOn();
  vtkNew<Call> told, asked;
  scene.Pass->AddObserver(vtkCommand::ProgressEvent, told);
  asked->What = [&] { scene.Window->SetAbortRender(told->Count >= 3); };
  const unsigned long observer = scene.Window->AddObserver(vtkCommand::AbortCheckEvent, asked);
  scene.Draw();
  EXPECT_GE(scene.Pass->GetSamples(), 3);
  EXPECT_LT(scene.Pass->GetSamples(), 1 << 16);
  EXPECT_TRUE(scene.Pass->IsRefining());
  scene.Window->RemoveObserver(observer);
  scene.Window->SetAbortRender(0);
  scene.Pass->SetSamplesPerPixel(8);
  scene.Draw();
  EXPECT_EQ(scene.Pass->GetSamples(), 8);
  EXPECT_FALSE(scene.Pass->IsRefining());
}

TEST(LightPassPaths, ASecondRendererIsRefusedAndDrawnAsEver)
{
  LightTestScene scene;
  const auto ball = scene.AddCellBall(20, { 0, 0, 0 });
  scene.AddLamp({ 0, -100, 0 });
  scene.Look({ 0, -130, 60 });
  scene.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0, 1, 1);
  other->AddActor(ball);
  other->SetPass(scene.Pass);
  other->SetActiveCamera(scene.Renderer->GetActiveCamera());
  scene.Window->AddRenderer(other);
  vtkNew<Call> errors;
  scene.Pass->AddObserver(vtkCommand::ErrorEvent, errors);
  scene.Draw(8);
  EXPECT_EQ(errors->Count, 1);
  LightTestScene alone;
  alone.AddCellBall(20, { 0, 0, 0 });
  alone.AddLamp({ 0, -100, 0 });
  alone.Look({ 0, -130, 60 });
  alone.Renderer->SetViewport(0, 0, 0.5, 1);
  const auto ours = scene.Draw(), theirs = alone.Draw(9);
  for (int y = 0; y < scene.Height; ++y)
    for (int x = 0; x < scene.Width / 2; ++x)
      ASSERT_EQ(ColorAt(ours, y * scene.Width + x), ColorAt(theirs, y * scene.Width + x));
  scene.Renderer->SetPass(nullptr); // then the pass is free
  scene.Draw();
  EXPECT_EQ(errors->Count, 1);
  EXPECT_EQ(scene.Resource("light, trees").reason, "1 bodies; 0 opaque actors left as drawn");
}

} // namespace
