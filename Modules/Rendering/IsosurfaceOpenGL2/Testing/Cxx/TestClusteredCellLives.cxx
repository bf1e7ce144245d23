// Mappers and windows come and go in every order, and what they made goes with them.
#include "AttributeTestScene.h"
#include "BallScene.h"
#include "HaspGL.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <utility>

namespace
{

using hasp::testing::BallScene;

hasp::ResourceUse GPUCells(vtkHaspClusteredCellMapper* mapper)
{
  return hasp::testing::FindResource(mapper, "active cells, GPU");
}

int BuffersOf(vtkRenderWindow* window)
{
  window->MakeCurrent();
  int count = 0;
  for (GLuint name = 1; name < 1000; ++name)
    count += glIsBuffer(name);
  return count;
}

class CellLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellLives, AMapperMovesBetweenWindows)
{
  BallScene first, second;
  ASSERT_TRUE(first.Shows());
  second.Mapper = first.Mapper;
  second.Actor->SetMapper(first.Mapper); // and still in the first one
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(second.Shows()) << n;
    EXPECT_TRUE(first.Shows()) << n;
  }
}

TEST_F(CellLives, TwoWindowsOfOneMapperUploadOnceEach)
{
  BallScene first;
  auto second = std::make_unique<BallScene>();
  second->Mapper = first.Mapper;
  second->Actor->SetMapper(first.Mapper);
  ASSERT_TRUE(first.Shows());
  const auto once = GPUCells(first.Mapper);
  ASSERT_TRUE(second->Shows());
  const auto both = GPUCells(first.Mapper);
  EXPECT_EQ(both.bytes, 2 * once.bytes);
  EXPECT_GT(both.milliseconds, once.milliseconds);
  for (int n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(first.Shows());
    EXPECT_TRUE(second->Shows());
    EXPECT_EQ(GPUCells(first.Mapper).milliseconds, both.milliseconds) << "something was uploaded";
  }
  first.Mapper->SetIsoValue(100); // a smaller ball, in both
  EXPECT_TRUE(first.Shows());
  EXPECT_TRUE(second->Shows());
  const auto smaller = GPUCells(first.Mapper);
  EXPECT_NE(smaller.milliseconds, both.milliseconds);
  EXPECT_LT(smaller.bytes, both.bytes);
  second.reset();
  EXPECT_EQ(GPUCells(first.Mapper).bytes, smaller.bytes / 2);
  EXPECT_TRUE(first.Shows());
}

TEST_F(CellLives, AMapperOutlivesAWindowThatForgotIt)
{
  auto first = std::make_unique<BallScene>();
  ASSERT_TRUE(first->Shows());
  const auto mapper = first->Mapper;
  first->Actor->SetMapper(nullptr); // now nothing tells the mapper that the window goes
  BallScene second;
  first.reset();
  second.Mapper = mapper;
  second.Actor->SetMapper(mapper);
  EXPECT_TRUE(second.Shows());
}

TEST_F(CellLives, AWindowThatIsClosedAndOpenedAgainForgetsNothing)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  const auto mapper = scene.Mapper;
  scene.Actor->SetMapper(nullptr);
  scene.Window->Finalize();
  scene.Draw();
  scene.Actor->SetMapper(mapper);
  EXPECT_TRUE(scene.Shows());
}

TEST_F(CellLives, ADeletedMapperFreesItsBuffers)
{
  BallScene scene;
  scene.Actor->VisibilityOff();
  scene.Draw();
  const int before = BuffersOf(scene.Window);
  scene.Actor->VisibilityOn();
  ASSERT_TRUE(scene.Shows());
  EXPECT_GT(BuffersOf(scene.Window), before);
  scene.Actor->SetMapper(nullptr);
  scene.Mapper = nullptr;
  EXPECT_EQ(BuffersOf(scene.Window), before);
}

TEST_F(CellLives, EverythingIsFreedWhoeverGoesFirst)
{
  const auto names = [](vtkRenderWindow* window)
  {
    window->MakeCurrent();
    std::array<int, 4> count{};
    for (GLuint name = 1; name < 1000; ++name)
    {
      count[0] += glIsBuffer(name);
      count[1] += glIsTexture(name);
      count[2] += glIsFramebuffer(name);
      count[3] += glIsVertexArray(name);
    }
    return count;
  };
  const auto draw = [](hasp::testing::AttributeScene& scene)
  {
    scene.Mapper->SetRenderer(
      HASP_WITH_EMBREE ? vtkHaspClusteredCellMapper::Trace : vtkHaspClusteredCellMapper::Rasterize);
    const int traced = scene.Covered();
    scene.Mapper->SetLabelArrayName("label");
    scene.Mapper->SetLabelColor(1, 1, 0, 0);
    scene.Mapper->SetScalarVisibility(true);
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectColorArray("height");
    scene.Mapper->SetBlendNormals(true);
    EXPECT_NEAR(scene.Covered(), traced, 2);
  };
  auto dying = std::make_unique<hasp::testing::AttributeScene>();
  auto mapper = dying->Mapper;
  draw(*dying);
  dying->Actor->SetMapper(nullptr); // now nothing tells the mapper that the window goes
  hasp::testing::AttributeScene scene;
  scene.Actor->VisibilityOff();
  scene.Draw();
  const auto before = names(scene.Window);
  dying.reset();
  scene.Actor->VisibilityOn();
  scene.Mapper = mapper;
  scene.Actor->SetMapper(mapper);
  draw(scene);
  EXPECT_GT(names(scene.Window), before);
  scene.Actor->SetMapper(nullptr);
  scene.Mapper = nullptr;
  mapper = nullptr;
  EXPECT_EQ(names(scene.Window), before);
}

TEST_F(CellLives, DeletingAMapperLeavesTheOtherWindowsContextCurrent)
{
  BallScene first, second;
  ASSERT_TRUE(first.Shows());
  ASSERT_TRUE(second.Shows());
  first.Actor->SetMapper(nullptr);
  first.Mapper = nullptr;
  EXPECT_TRUE(second.Window->IsCurrent());
}

TEST_F(CellLives, WindowsOfNoSizeDrawNothing)
{
  BallScene scene;
  ASSERT_TRUE(scene.Shows());
  for (const auto& [width, height] : { std::pair{ 1, 1 }, { 3, 1 }, { 0, 0 } })
  {
    scene.Window->SetSize(width, height);
    scene.Window->Render();
  }
  scene.Window->SetSize(60, 60);
  EXPECT_TRUE(scene.Shows());
}

} // namespace
