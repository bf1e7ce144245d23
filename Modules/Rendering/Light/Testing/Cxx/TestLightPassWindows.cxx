// Windows of all kinds: several samples a pixel, parts of a window, parallel views, picks, lost
// contexts.
#include "LightTestScene.h"

#include "vtkHardwareSelector.h"
#include "vtkSelection.h"

#include <gtest/gtest.h>

namespace
{

using hasp::testing::Difference;
using hasp::testing::LightTestScene;

struct BallScene : LightTestScene
{
  explicit BallScene(int width = 120, int height = 90) : LightTestScene(width, height)
  {
    this->AddCellBall(20, { 0, 0, 0 }, 0.8);
    this->AddFloor(60, -20, 0.6);
    this->AddLamp({ -50, -50, 100 });
    this->Look({ 0, -130, 60 });
    this->Pass->SetModeToLamps();
  }
};

TEST(LightPassWindows, SeveralSamplesAPixelAreLitAsOne)
{
  BallScene one, several;
  several.Window->SetMultiSamples(4);
  EXPECT_LT(Difference(one.Draw(), several.Draw()), 12.0); // edges are smooth there
  EXPECT_EQ(one.Grey(one.Draw(), { 0, -20, 0 }), several.Grey(several.Draw(), { 0, -20, 0 }));
}

TEST(LightPassWindows, APartOfTheWindowIsLitAsTheWhole)
{
  BallScene whole, part(240, 180);
  part.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  const auto all = whole.Draw();
  const auto quarter = part.Draw();
  double most = 0.0;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x)
      most = std::max(most, std::abs(double(all->GetTypedComponent(y * 120 + x, 1)) -
                                     quarter->GetTypedComponent((y + 90) * 240 + x + 120, 1)));
  EXPECT_LE(most, 1.0);
}

TEST(LightPassWindows, ParallelViewsAreLit)
{
  BallScene scene;
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(40);
  scene.Look({ 0, -130, 60 });
  const int lamps = scene.Grey(scene.Draw(), { 0, 0, 20 });
  scene.Renderer->SetPass(nullptr);
  EXPECT_NEAR(lamps, scene.Grey(scene.Draw(), { 0, 0, 20 }), 4);
  scene.Renderer->SetPass(scene.Pass);
  scene.Pass->SetModeToTraced();
  EXPECT_GT(scene.Grey(scene.Draw(), { 0, 0, 20 }), 100);
}

TEST(LightPassWindows, PicksFindWhatIsSeen)
{
  BallScene scene;
  scene.Pass->SetModeToTraced();
  scene.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const glm::ivec2 at = scene.PixelOf({ 0, -20, 0 });
  selector->SetArea(at.x, at.y, at.x, at.y);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1U);
  const auto lit = scene.Draw();
  EXPECT_EQ(Difference(lit, scene.Draw()) < 2.0, true) << "and the picture is as before";
}

TEST(LightPassWindows, ANewContextIsLitAgain)
{
  BallScene scene;
  const auto before = scene.Draw();
  scene.Window->Finalize();
  EXPECT_EQ(Difference(before, scene.Draw()), 0.0);
}

TEST(LightPassWindows, AnEmptySceneAndATinyWindowAreNoFaults)
{
  LightTestScene empty;
  empty.Look({ 0, -10, 0 });
  for (int mode = vtkHaspLightPass::Lamps; mode <= vtkHaspLightPass::PathTraced; ++mode)
  {
    empty.Pass->SetMode(mode);
    empty.Draw();
  }
  BallScene tiny(1, 1);
  tiny.Pass->SetModeToTraced();
  tiny.Draw();
}

} // namespace
