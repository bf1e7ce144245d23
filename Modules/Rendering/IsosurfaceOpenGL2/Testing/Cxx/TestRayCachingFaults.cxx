// What once went wrong in the ray caching mapper: stale surfaces, frames without end, passes drawn
// twice.
#include "CacheProgress.h"
#include "DrawingChoice.h"
#include "RaycastTestScene.h"
#include "vtkHaspPickedCell.h"

#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"

namespace
{

using hasp::testing::Find;
using hasp::testing::ObliqueGrid;
using hasp::testing::RaycastScene;
using Ball = hasp::testing::RaycastBall;
using Mapper = vtkHaspRayCachingMapper;

class RayCachingFaults : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// An undo, or a filter that ran again: the mark says less than has happened.
TEST_F(RayCachingFaults, MarkedSamplesThatHaveMovedAreReadAnew)
{
  for (const int mode : { Mapper::Cache, Mapper::Automatic })
  {
    Ball ball(mode);
    for (int frame = 0; frame < 5; ++frame)
      ball.Draw();
    vtkImageData* image = ball.Raycaster->GetImage();
    vtkNew<vtkShortArray> copy;
    copy->DeepCopy(image->GetPointData()->GetScalars());
    image->GetPointData()->SetScalars(copy);
    const int box[6] = { 0, 1, 0, 1, 0, 1 };
    ball.Raycaster->MarkModified(box);
    EXPECT_TRUE(ball.Shows());
    const double* origin = image->GetOrigin();
    image->SetOrigin(origin[0] + 500, origin[1], origin[2]);
    ball.Raycaster->MarkModified(box);
    EXPECT_FALSE(ball.Shows());
  }
}

/// A pick may be the first to hear that all is another volume.
TEST_F(RayCachingFaults, AMarkAfterAPickHidesNoChange)
{
  Ball ball(Mapper::Automatic);
  ball.Draw();
  ASSERT_TRUE(ball.Shows());
  vtkImageData* image = ball.Raycaster->GetImage();
  std::fill_n(static_cast<std::int16_t*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
    std::int16_t(-500));
  image->Modified();
  vtkNew<vtkHaspPickedCell> picked;
  const double from[3] = { 60, -80, 40 }, to[3] = { -60, 80, -40 };
  EXPECT_FALSE(ball.Raycaster->PickFirstCell(from, to, picked));
  const int box[6] = { 0, 1, 0, 1, 0, 1 };
  ball.Raycaster->MarkModified(box);
  EXPECT_EQ(ball.SurfacePixels(), 0);
}

TEST_F(RayCachingFaults, RefiningComesToAnEnd)
{
  {
    Ball ball(Mapper::Cache);
    EXPECT_LT(ball.FramesToRest(), 100);
    ball.Raycaster->SetIsoValue(1e39); // beyond all samples: no error, and nothing
    EXPECT_EQ(ball.SurfacePixels(), 0);
    EXPECT_LT(ball.FramesToRest(), 10);
    EXPECT_TRUE(ball.Errors.empty()) << ball.Errors.front();
  }
  {
    Ball ball(Mapper::Automatic);
    EXPECT_LT(ball.FramesToRest(), 100);
  }
  Ball ball(Mapper::Cache);
  ball.Window->Render();
  ASSERT_TRUE(ball.Raycaster->IsRefining());
  ball.Raycaster->SetIsoValue(std::nan(""));
  ball.Window->Render();
  EXPECT_FALSE(ball.Raycaster->IsRefining());
  EXPECT_EQ(ball.Errors.size(), 1U);
  EXPECT_EQ(Find(ball.Raycaster, "ray cache").bytes, 0U);
  ball.Raycaster->SetIsoValue(0.0);
  ball.Window->Render();
  ASSERT_TRUE(ball.Raycaster->IsRefining());
  ball.Raycaster->SetInputData(nullptr);
  EXPECT_FALSE(ball.Raycaster->IsRefining());
}

/// One that looks away, and was drawn last, does not speak for the other.
TEST_F(RayCachingFaults, AnyViewerMayBeRefining)
{
  Ball ball(Mapper::Cache);
  vtkNew<vtkRenderer> away;
  away->AddActor(ball.Actor);
  ball.Window->AddRenderer(away);
  away->GetActiveCamera()->SetPosition(0, -500, 0);
  away->GetActiveCamera()->SetFocalPoint(0, -1000, 0);
  away->GetActiveCamera()->SetViewUp(0, 0, 1);
  ball.Renderer->SetViewport(0, 0, 0.5, 1);
  away->SetViewport(0.5, 0, 1, 1);
  for (int frame = 0; frame < 6; ++frame) // the other has rested after four
    ball.Window->Render();
  EXPECT_TRUE(ball.Raycaster->IsRefining());
  ball.FramesToRest();
  // One that is not drawn any more does not hold the others up.
  ball.Raycaster->SetIsoValue(100);
  ball.Window->Render();
  ASSERT_TRUE(ball.Raycaster->IsRefining());
  ball.Window->RemoveRenderer(ball.Renderer);
  EXPECT_LT(ball.FramesToRest(), 10);
}

/// VTK does not draw what is out of sight, so that nobody would say that it rests.
TEST_F(RayCachingFaults, WhatIsOutOfSightDoesNotRefine)
{
  for (const bool stereo : { false, true })
  {
    Ball ball(Mapper::Cache);
    ball.Window->SetStereoRender(stereo);
    ball.Window->Render();
    ASSERT_TRUE(ball.Raycaster->IsRefining());
    ball.Look({ 0, -500, 0 }, { 0, -1000, 0 }, 1, 100);
    EXPECT_LT(ball.FramesToRest(), 10);
    ball.Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 200);
    EXPECT_GT(ball.FramesToRest(), 4);
  }
}

TEST_F(RayCachingFaults, TranslucentSurfacesAreDrawnOnce)
{
  Ball ball(Mapper::Automatic);
  ball.Actor->GetProperty()->SetOpacity(0.5);
  const auto first = ball.Colors();
  for (int frame = 0; frame < 8; ++frame)
    EXPECT_EQ(ball.Colors(), first) << frame;
}

/// Where the cache has won, all cells are let go; a surface that turns translucent takes them in
/// each frame, and must not extract them in each.
TEST_F(RayCachingFaults, TranslucentSurfacesKeepTheirCells)
{
  Ball ball(Mapper::Automatic);
  ball.Raycaster->SetRenderer(vtkHaspClusteredCellMapper::Rasterize);
  ball.Window->SetSize(8, 8); // few rays and bricks, against very many cells
  ball.Show<std::int16_t>(hasp::AnalyticGyroid(8), ObliqueGrid(40, { 1, 1, 1 }));
  const auto bytes = [&] { return Find(ball.Raycaster, "active cells, host").bytes; };
  for (int frame = 0; frame < 200 && (frame < 20 || bytes() > 0); ++frame)
  {
    if (frame < 20 && frame % 2 == 1) // what a change costs is measured, too
      ball.Raycaster->SetIsoValue(frame % 4);
    ball.Window->Render();
  }
  ASSERT_EQ(bytes(), 0U) << "the cache has won: " << ball.Raycaster->GetModeChoice();
  ball.Actor->GetProperty()->SetOpacity(0.5);
  ball.Window->Render();
  EXPECT_GT(bytes(), 0U);
}

/// VTK's windows have several samples a pixel by default: cells must leave no seams between them.
TEST_F(RayCachingFaults, RasterisedCellsHaveNoSeamsInMultisampledWindows)
{
  for (const int mode : { Mapper::Automatic, Mapper::Cache })
  {
    std::vector<std::vector<unsigned char>> pictures;
    for (const int samples : { 0, 4 })
    {
      Ball ball(mode);
      ball.Show<std::int16_t>( // of cells as large as pixels
        hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(100, { 0.4, 0.4, 0.4 }));
      ball.Window->SetMultiSamples(samples);
      ball.Raycaster->SetRenderer(vtkHaspClusteredCellMapper::Rasterize);
      ball.FramesToRest();
      pictures.push_back(ball.Colors());
    }
    std::size_t different = 0;
    for (std::size_t n = 0; n < pictures[0].size(); ++n)
      different += std::abs(int(pictures[0][n]) - int(pictures[1][n])) > 10;
    EXPECT_LE(different, pictures[0].size() / 200) << "a few found later in the cache";
  }
}

TEST_F(RayCachingFaults, ALightWithoutDirectionCastsNoShadow)
{
  Ball ball(Mapper::Automatic);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(1, 2, 3);
  light->SetFocalPoint(1, 2, 3);
  ball.Renderer->RemoveAllLights();
  ball.Renderer->AddLight(light);
  ball.Raycaster->ShadowsOn();
  EXPECT_TRUE(ball.Shows());
  EXPECT_LE(ball.Errors.size(), 1U); // a build without Embree says that light takes rays
}

/// The first root above a flat region of samples just below the isovalue.
TEST_F(RayCachingFaults, MasksHaveASurfaceAtEveryIsovalue)
{
  RaycastScene scene;
  const hasp::GridGeometry grid{ { 40, 40, 40 }, { -20, -20, -20 }, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::uint8_t> mask(grid.Size(), 0);
  for (int k = 10; k < 30; ++k)
    for (int j = 10; j < 30; ++j)
      std::fill_n(mask.begin() + (k * 40 + j) * 40 + 10, 20, std::uint8_t(1));
  scene.Raycaster->SetInputData(hasp::MakeImage(grid, mask));
  scene.Raycaster->SetStepSize(0.25); // longer ones pass corners
  for (const double isovalue : { 0.02, 0.5, 0.98, 1.0 })
    for (const int mode : { Mapper::Raycast, Mapper::RaycastSkipping })
    {
      scene.Raycaster->SetIsoValue(isovalue);
      scene.Raycaster->SetMode(mode);
      scene.Draw();
      const auto judged = scene.Judge(scene.Truth());
      EXPECT_GT(judged.surface, 1000);
      EXPECT_LE(judged.missed, judged.surface / 100) << isovalue;
      EXPECT_EQ(judged.invented, 0) << isovalue;
    }
}

/// Nobody but the mapper itself hears the ones inside it.
TEST_F(RayCachingFaults, WhatAMapperInsideSaysIsSaidByTheOuterOne)
{
  Ball ball(Mapper::Automatic); // its first frame is all active cells, of a mapper inside
  ball.Raycaster->SetIsoValue(std::nan(""));
  ball.Draw();
  ASSERT_EQ(ball.Errors.size(), 1U);
  EXPECT_NE(ball.Errors[0].find("RayCachingMapper"), std::string::npos) << ball.Errors[0];
  EXPECT_EQ(ball.Errors[0].find("ClusteredCellMapper"), std::string::npos) << ball.Errors[0];
  EXPECT_NE(ball.Errors[0].find("isovalue"), std::string::npos) << ball.Errors[0];
}

/// What a small window measured is no verdict on a large one.
TEST(DrawingChoice, IsTakenAnewForAnotherScene)
{
  const auto decided = []
  {
    DrawingChoice choice;
    choice.Begin(1000, 5000);
    for (int n = 0; n < 2; ++n)
    {
      choice.WholeTook(false, 20);
      choice.CacheTook(false, 10);
    }
    return choice;
  };
  for (const auto& [pixels, cells, same] : { std::tuple(1000, 5000, true), { 2000, 5000, true },
         { 2001, 5000, false }, { 499, 5000, false }, { 1000, 0, true }, { 1000, 10001, false } })
  {
    DrawingChoice choice = decided();
    choice.Begin(pixels, cells);
    EXPECT_EQ(choice.Next(false, true).cache, same) << pixels << " " << cells;
  }
}

TEST(CacheProgress, IsFilledOnceRaysFindLittle)
{
  CacheProgress progress;
  hasp::RayCache::Frame frame;
  frame.hits = 1000;
  const auto sampled = [&](int known, int added)
  {
    frame.known = known;
    frame.added = added;
    progress.Sampled(frame, 8, 1.0);
  };
  progress.ShowsCache(true);
  for (int n = 0; n < 4; ++n)
  {
    EXPECT_FALSE(progress.Filled());
    sampled(995, 3);
  }
  EXPECT_TRUE(progress.Filled());
  EXPECT_TRUE(progress.Refining()) << "there is more";
  sampled(994, 3);
  EXPECT_FALSE(progress.Filled());
  for (int n = 0; n < 4; ++n)
  {
    EXPECT_TRUE(progress.Refining());
    sampled(1000, 0);
  }
  EXPECT_FALSE(progress.Refining());
  EXPECT_TRUE(progress.Filled());
  progress.Unfill();
  EXPECT_FALSE(progress.Filled());
  frame.hits = 0;
  for (int n = 0; n < 9; ++n)
    sampled(0, 0);
  EXPECT_FALSE(progress.Filled()) << "rays that meet nothing say nothing";
}

/// A frame has a part that no ray less makes shorter: one ray must not stay one.
TEST(CacheProgress, ABudgetIsUsed)
{
  CacheProgress progress;
  EXPECT_EQ(progress.RaysFor(0.0, 8), 8);
  EXPECT_EQ(progress.RaysFor(10.0, 8), 8) << "nothing is known yet";
  int rays = 1;
  for (int frame = 0; frame < 50; ++frame)
  {
    progress.Sampled({}, rays, 5.0 + 0.1 * rays);
    progress.Drawn(1.0);
    rays = progress.RaysFor(10.0, 8);
  }
  EXPECT_NEAR(rays, 40, 1);
}

} // namespace
