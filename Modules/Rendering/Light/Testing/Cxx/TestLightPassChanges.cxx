// What changes is seen, what takes no part is left alone, and what is wrong is said.
#include "LightTestScene.h"

#include "vtkCommand.h"
#include "vtkLineSource.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <fstream>

namespace
{

using hasp::testing::Difference;
using hasp::testing::LightTestScene;

struct ErrorCounter : vtkCommand
{
  static ErrorCounter* New() { return new ErrorCounter; }
  int Count = 0;
  std::string Text;
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    ++this->Count;
    this->Text = static_cast<const char*>(text);
  }
};

TEST(LightPassChanges, AMovedBodyTakesItsShadowAlong)
{
  for (const int mode :
    { vtkHaspLightPass::Lamps, vtkHaspLightPass::AmbientOcclusion, vtkHaspLightPass::Traced })
  {
    LightTestScene moved, there;
    const auto ball = moved.AddCellBall(10, { -15, 0, 10 }, 0.8);
    there.AddCellBall(10, { 15, 0, 10 }, 0.8);
    for (LightTestScene* scene : { &moved, &there })
    {
      scene->AddFloor(50, 0, 0.8);
      scene->AddLamp({ 0, -50, 100 });
      scene->Look({ 0, -120, 80 });
      scene->Pass->SetMode(mode);
    }
    moved.Draw(8);
    ball->SetPosition(15, 0, 10);
    const double soon = Difference(moved.Draw(1), there.Draw(8));
    const double later = Difference(moved.Draw(16), there.Draw(16));
    EXPECT_LT(later, mode == vtkHaspLightPass::Lamps ? 0.1 : 3.0) << mode; // noise of 30 samples
    EXPECT_LT(soon, 12.0) << mode;
  }
}

TEST(LightPassChanges, AnotherIsovalueIsAnotherSurface)
{
  LightTestScene scene;
  const auto ball = scene.AddCellBall(20, { 0, 0, 0 });
  scene.AddLamp({ 0, -100, 0 });
  scene.Look({ 0, -100, 1 });
  scene.Pass->SetModeToLamps();
  EXPECT_GE(scene.Grey(scene.Draw(), { 15, 0, 0 }), 100);
  vtkHaspClusteredCellMapper::SafeDownCast(ball->GetMapper())->SetIsoValue(10.0); // radius 10
  EXPECT_LE(scene.Grey(scene.Draw(), { 15, 0, 0 }), 60) << "background";
  EXPECT_GE(scene.Grey(scene.Draw(), { 5, 0, 0 }), 100);
}

TEST(LightPassChanges, WhatTakesNoPartStaysAsDrawn)
{
  LightTestScene scene;
  scene.AddCellBall(10, { 0, 0, 0 });
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-30, -20, 0);
  line->SetPoint2(30, -20, 0);
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputConnection(line->GetOutputPort());
  const auto mark = scene.Add(lines, { 0, 0, 0 });
  mark->GetProperty()->SetColor(0, 1, 0);
  mark->GetProperty()->LightingOff();
  mark->GetProperty()->SetLineWidth(3);
  const auto wires = scene.AddMeshBall(8, { 20, 0, 0 });
  wires->GetProperty()->SetRepresentationToWireframe();
  scene.AddLamp({ 0, -100, 0 });
  scene.Look({ 0, -100, 1 });
  for (const int mode :
    { vtkHaspLightPass::Lamps, vtkHaspLightPass::Traced, vtkHaspLightPass::PathTraced })
  {
    scene.Pass->SetMode(mode);
    scene.Pass->SetSamplesPerPixel(2);
    scene.Pass->WaitForSamplesOn();
    const auto pixels = scene.Draw();
    for (const double x : { -25.0, -5.0, 0.0, 25.0 }) // also before the ball
      EXPECT_EQ(scene.Grey(pixels, { x, -20, 0 }), 255) << mode << " " << x;
    const std::string reason = scene.Resource("light, trees").reason;
    EXPECT_EQ(reason, "1 bodies; 2 opaque actors left as drawn");
  }
}

TEST(LightPassChanges, TranslucentSurfacesAreDrawnOverTheLight)
{
  for (const bool peels : { false, true })
  {
    LightTestScene scene;
    scene.AddCellBall(10, { 0, 0, 0 });
    const auto skin = scene.AddCellBall(20, { 0, 0, 0 });
    skin->GetProperty()->SetColor(1, 0, 0);
    skin->GetProperty()->SetOpacity(0.5);
    skin->GetProperty()->LightingOff();
    scene.AddLamp({ 0, -100, 0 });
    scene.Look({ 0, -100, 1 });
    scene.Renderer->SetUseDepthPeeling(peels);
    scene.Pass->SetModeToLamps();
    const auto pixels = scene.Draw();
    const glm::ivec2 at = scene.PixelOf({ 0, -10, 0 });
    const vtkIdType n = at.y * scene.Width + at.x;
    // White bone straight before the lamp behind one half-clear red layer.
    EXPECT_NEAR(pixels->GetTypedComponent(n, 0), 255, 3) << peels;
    EXPECT_NEAR(pixels->GetTypedComponent(n, 1), 128, 4) << peels;
    const auto alone = scene.Resource("light, trees").reason;
    EXPECT_EQ(alone, "1 bodies; 0 opaque actors left as drawn") << "the skin is no body";
  }
}

TEST(LightPassChanges, PathsGoOnFromFrameToFrameAndBeginAnewWhenTheViewMoves)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.Look({ 0, -130, 60 });
  scene.Pass->SetModeToPathTraced();
  scene.Pass->SetSamplesPerPixel(40);
  scene.Draw();
  int frames = 1;
  for (; scene.Pass->IsRefining() && frames < 100'000; ++frames)
    scene.Window->Render();
  EXPECT_EQ(scene.Pass->GetSamples(), 40);
  scene.Draw();
  EXPECT_EQ(scene.Pass->GetSamples(), 40);
  for (int n = 1; n <= 20; ++n) // a view that moves all the time never waits for its paths
  {
    scene.Look({ n, -130, 60 });
    scene.Draw();
    EXPECT_LT(scene.Pass->GetSamples(), 40);
  }
}

TEST(LightPassChanges, PathsBeginAnewAfterOtherModesOfTheSameView)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.Look({ 0, -130, 60 });
  for (int n = 0; n < 3; ++n) // all settings as they are at first
  {
    scene.Pass->SetModeToTraced();
    scene.Draw();
    EXPECT_EQ(scene.Pass->GetSamples(), 0);
    scene.Pass->SetModeToPathTraced();
    scene.Pass->WaitForSamplesOn();
    scene.Draw();
    EXPECT_EQ(scene.Pass->GetSamples(), 256);
    EXPECT_FALSE(scene.Pass->IsRefining());
  }
}

TEST(LightPassChanges, ABodyOutOfSightCastsItsShadow)
{
  LightTestScene scene;
  scene.AddFloor(40, 0);
  scene.AddCellBall(10, { 0, 0, 200 }); // far above the view
  scene.AddLamp({ 0, 0, 1000 });
  scene.Look({ 0, -90, 60 });
  scene.Pass->SetModeToLamps();
  const auto pixels = scene.Draw();
  EXPECT_LE(scene.Grey(pixels, { 0, 0, 0 }), 2);
  EXPECT_GE(scene.Grey(pixels, { 15, 0, 0 }), 240);
}

TEST(LightPassChanges, AnotherWishIsAnotherPicture)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.Look({ 0, -130, 60 });
  scene.Draw(64);
  EXPECT_FALSE(scene.Pass->IsRefining());
  scene.Pass->SetBounces(1);
  scene.Draw();
  EXPECT_TRUE(scene.Pass->IsRefining());
}

TEST(LightPassChanges, WhatIsWrongIsSaidOnceAndThePictureIsAsDrawn)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 });
  scene.AddLamp({ 0, -100, 0 });
  scene.Look({ 0, -100, 1 });
  vtkNew<ErrorCounter> errors;
  scene.Pass->AddObserver(vtkCommand::ErrorEvent, errors);
  scene.Pass->SetModeToTraced();
  scene.Pass->SetEnvironmentFileName("/no/such/folder/sky.hdr");
  const auto wrong = scene.Draw(3);
  EXPECT_EQ(errors->Count, 1);
  EXPECT_FALSE(scene.Pass->IsRefining());
  EXPECT_EQ(scene.Pass->GetSamples(), 0);
  EXPECT_NE(errors->Text.find("sky.hdr"), std::string::npos) << errors->Text;
  EXPECT_EQ(errors->Text.find("/no/such"), std::string::npos) << errors->Text;
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(Difference(wrong, scene.Draw()), 0.0);
  scene.Renderer->SetPass(scene.Pass);
  scene.Pass->SetEnvironmentFileName("");
  scene.Draw();
  EXPECT_EQ(errors->Count, 1);
  scene.Pass->SetAmbientOcclusionDistance(-1.0);
  EXPECT_EQ(errors->Count, 2);
  EXPECT_EQ(scene.Pass->GetAmbientOcclusionDistance(), 25.0);
}

} // namespace
