// Ray caching below OpenGL 4.3: it draws what it can by rays on the CPU, and active cells stand in
// for raycasts on the GPU.
#include "OlderOpenGLScene.h"

namespace
{

using hasp::testing::Find;
using hasp::testing::OlderOpenGL;
using hasp::testing::OlderScene;
using hasp::testing::RaycastModes;

#if HASP_WITH_EMBREE

TEST_F(OlderOpenGL, RayCachingDrawsAsAskedFor)
{
  OlderScene& scene = *this->Scene;
  for (const int mode : { vtkHaspRayCachingMapper::Automatic, vtkHaspRayCachingMapper::Cache })
  {
    scene.ShowRaycaster(mode);
    scene.Raycaster->SetRaysPerTile(64);
    for (int frame = 0, quiet = 0; frame < 100 && quiet < 8; ++frame)
    {
      scene.Window->Render();
      quiet = scene.Raycaster->IsRefining() ? 0 : quiet + 1;
    }
    scene.Draw();
    this->ExpectTruth(mode == vtkHaspRayCachingMapper::Cache ? 5 : 0); // corners of blocks
  }
  EXPECT_EQ(
    scene.Raycaster->GetModeChoice(), "cache: asked for; traced: " + this->Lack("rasterising"));
  this->ExpectNothingSaid();
}

TEST_F(OlderOpenGL, CellsStandInForARaycast)
{
  OlderScene& scene = *this->Scene;
  for (int n = 0; n < 2; ++n)
    for (const int mode : RaycastModes)
    {
      scene.ShowRaycaster(mode);
      for (int frame = 0; frame < 3; ++frame)
        scene.Draw();
      this->ExpectTruth();
      EXPECT_EQ(scene.Raycaster->GetModeChoice(), "all active cells: " + this->Lack("raycasting"));
      EXPECT_EQ(
        Find(scene.Raycaster, "ray tracing tree").reason, "traced: " + this->Lack("rasterising"));
      EXPECT_EQ(Find(scene.Raycaster, "raycast samples, GPU").bytes, 0U);
      EXPECT_FALSE(scene.Raycaster->IsRefining());
    }
  ASSERT_EQ(scene.Warnings.size(), 1U) << "once, while raycasts are asked for";
  EXPECT_NE(scene.Warnings[0].find(
              "Active cells stand in, traced by rays on the CPU: " + this->Lack("raycasting")),
    std::string::npos)
    << scene.Warnings[0];
  EXPECT_TRUE(scene.Errors.empty());

  scene.ShowRaycaster(vtkHaspRayCachingMapper::Automatic);
  scene.Draw();
  scene.ShowRaycaster(vtkHaspRayCachingMapper::Raycast);
  scene.Draw();
  EXPECT_EQ(scene.Warnings.size(), 2U) << "it was asked for anew";
}

TEST_F(OlderOpenGL, WhatStandsInFollowsIsovalueAndEdits)
{
  OlderScene& scene = *this->Scene;
  scene.ShowRaycaster(vtkHaspRayCachingMapper::Raycast);
  for (const double isovalue : { 20.0, -35.0 })
  {
    scene.Raycaster->SetIsoValue(isovalue);
    scene.Draw();
    this->ExpectTruth();
  }
  vtkImageData* image = scene.Raycaster->GetImage();
  const int box[6] = { 10, 40, 10, 40, 10, 50 };
  for (int z = box[4]; z <= box[5]; ++z)
    for (int y = box[2]; y <= box[3]; ++y)
      for (int x = box[0]; x <= box[1]; ++x)
        image->SetScalarComponentFromDouble(x, y, z, 0, -500);
  scene.Raycaster->MarkModified(box);
  scene.Draw();
  this->ExpectTruth();
  EXPECT_TRUE(scene.Errors.empty());
}

TEST_F(OlderOpenGL, NothingStandsInWhereRasterisingIsAskedFor)
{
  OlderScene& scene = *this->Scene;
  scene.Raycaster->SetRenderer(vtkHaspClusteredCellMapper::Rasterize);
  for (const int mode : { vtkHaspRayCachingMapper::Raycast, vtkHaspRayCachingMapper::Cache,
         vtkHaspRayCachingMapper::Automatic })
  {
    scene.ShowRaycaster(mode);
    scene.Errors.clear();
    EXPECT_EQ(scene.Pixels(), 0) << mode;
    ASSERT_GE(scene.Errors.size(), 1U) << mode;
    EXPECT_NE(scene.Errors[0].find(this->Lack("rasterising") + "; the renderer automatic"),
      std::string::npos)
      << scene.Errors[0];
  }
  EXPECT_TRUE(scene.Warnings.empty());
}

/// What cells cannot draw here is not drawn by what stands in for them, either.
TEST_F(OlderOpenGL, WhatStandsInRefusesWhatItCannotDraw)
{
  OlderScene& scene = *this->Scene;
  scene.Actor->GetProperty()->SetOpacity(0.5);
  for (const int mode : { vtkHaspRayCachingMapper::Automatic, vtkHaspRayCachingMapper::Cache,
         vtkHaspRayCachingMapper::Raycast })
  {
    scene.ShowRaycaster(mode);
    scene.Errors.clear();
    for (int n = 0; n < 3; ++n)
      EXPECT_EQ(scene.Pixels(), 0) << mode;
    ASSERT_GE(scene.Errors.size(), 1U) << mode;
    EXPECT_NE(
      scene.Errors[0].find("translucent surfaces are drawn in no other way"), std::string::npos)
      << scene.Errors[0];
  }
}

#else

TEST_F(OlderOpenGL, WithoutEmbreeNothingStandsIn)
{
  OlderScene& scene = *this->Scene;
  for (const int mode : RaycastModes)
  {
    scene.ShowRaycaster(mode);
    EXPECT_EQ(scene.Pixels(), 0);
  }
  EXPECT_TRUE(scene.Warnings.empty()) << "of what stands in, for nothing does";
  ASSERT_EQ(scene.Errors.size(), 1U);
  EXPECT_NE(scene.Errors[0].find("need a build with Embree"), std::string::npos);
}

#endif

} // namespace
