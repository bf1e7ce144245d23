// The traced renderer: nothing of it is there while it is not used, and when it is.
#include "GyroidScene.h"
#include "HaspGL.h"

#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace
{

using hasp::testing::FindResource;
using hasp::testing::GyroidScene;
using hasp::testing::PixelsX;
using hasp::testing::PixelsY;

class TracedCellLives : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

#if HASP_WITH_EMBREE

TEST_F(TracedCellLives, AreNotThereUntilAskedForAndGoneAfterwards)
{
  GyroidScene scene;
  vtkHaspClusteredCellMapper* mapper = scene.Mapper;
  const auto bytes = [&](const char* name) { return FindResource(mapper, name).bytes; };
  scene.Draw();
  EXPECT_EQ(mapper->GetRendererChoice(), "rasterised: as asked for");
  for (const char* name : { "ray tracing tree", "traced picture", "shader: traced cells" })
  {
    EXPECT_EQ(bytes(name), 0U) << name;
    EXPECT_EQ(FindResource(mapper, name).milliseconds, 0.0) << name;
  }
  EXPECT_GT(bytes("active cells, GPU"), 0U);

  mapper->SetRendererToTrace();
  scene.Draw();
  scene.Draw(); // what the rasteriser used lately goes now
  EXPECT_EQ(mapper->GetRendererChoice(), "traced: as asked for");
  EXPECT_GT(bytes("ray tracing tree"), 0U);
  EXPECT_GT(bytes("traced picture"), 0U);
  EXPECT_EQ(bytes("active cells, GPU"), 0U);
  EXPECT_EQ(bytes("occlusion culling"), 0U);

  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Draw();
  EXPECT_EQ(mapper->GetRendererChoice(), "rasterised: translucent surfaces always are");
  scene.Actor->GetProperty()->SetOpacity(1.0);

  mapper->SetBlendNormals(true);
  scene.Draw();
  EXPECT_EQ(mapper->GetRendererChoice(),
    "rasterised: labels, scalar colours and blended normals always are");
  EXPECT_EQ(bytes("ray tracing tree"), 0U);
  mapper->SetBlendNormals(false);

  mapper->SetRendererToRasterize();
  scene.Draw();
  EXPECT_EQ(bytes("ray tracing tree"), 0U);
  EXPECT_EQ(bytes("traced picture"), 0U);
  EXPECT_GT(bytes("active cells, GPU"), 0U);

  mapper->SetRendererToTrace();
  scene.Draw();
  scene.Window->Finalize();
  EXPECT_EQ(bytes("active cells, GPU"), 0U);
}

TEST_F(TracedCellLives, FollowIsovalueAndInput)
{
  GyroidScene scene;
  scene.Mapper->SetRendererToTrace();
  const auto depth = [&]
  {
    scene.Draw();
    const auto point = scene.Point(PixelsX / 2, PixelsY / 2);
    return point ? glm::length(*point) : -1.0;
  };
  const auto image = [](double radius)
  {
    const hasp::GridGeometry g{ { 40, 40, 40 }, glm::dvec3(-19.5), { 1, 1, 1 }, glm::dmat3(1) };
    return hasp::MakeImage(
      g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, radius), g, 100, 0));
  };
  scene.Mapper->SetInputData(image(15));
  EXPECT_NEAR(depth(), 15, 0.1);
  scene.Mapper->SetIsoValue(400);
  EXPECT_NEAR(depth(), 11, 0.1);
  scene.Mapper->SetIsoValue(1e6); // no surface
  EXPECT_EQ(depth(), -1.0);
  EXPECT_EQ(FindResource(scene.Mapper, "ray tracing tree").bytes, 0U);
  EXPECT_EQ(FindResource(scene.Mapper, "traced picture").bytes, 0U);
  scene.Mapper->SetIsoValue(0);
  scene.Mapper->SetInputData(image(12));
  EXPECT_NEAR(depth(), 12, 0.1);
}

TEST_F(TracedCellLives, LiveInTwoWindowsAndLeaveNothingBehind)
{
  GyroidScene first;
  first.Mapper->SetRendererToTrace();
  auto second = std::make_unique<GyroidScene>();
  second->Mapper = first.Mapper;
  second->Actor->SetMapper(first.Mapper);
  for (int n = 0; n < 2; ++n)
  {
    first.Draw();
    second->Draw();
    for (const GyroidScene* scene : { &first, second.get() })
      EXPECT_TRUE(scene->Point(PixelsX / 2, PixelsY / 2).has_value());
  }
  const double tree = FindResource(first.Mapper, "ray tracing tree").milliseconds;
  second.reset();
  first.Draw();
  EXPECT_TRUE(first.Point(PixelsX / 2, PixelsY / 2).has_value());
  EXPECT_EQ(FindResource(first.Mapper, "ray tracing tree").milliseconds, tree)
    << "it was made anew";
  first.Window->MakeCurrent();
  const auto textures = []
  {
    int count = 0;
    for (GLuint name = 1; name < 1000; ++name)
      count += glIsTexture(name);
    return count;
  };
  const int with = textures();
  first.Actor->SetMapper(nullptr);
  first.Mapper = nullptr;
  EXPECT_EQ(textures(), with - 1);
}

TEST_F(TracedCellLives, AreChosenByMeasurementWhereOpenGLIsSoftware)
{
  GyroidScene scene;
  scene.Draw();
  scene.Mapper->SetRendererToAutomatic();
  const std::string driver = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (driver.find("llvmpipe") == std::string::npos)
    GTEST_SKIP() << "OpenGL by " << driver;
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetRendererChoice().rfind("traced: OpenGL is software, ", 0), 0U);
  for (int n = 0; n < 6; ++n)
    scene.Draw();
  const std::string choice = scene.Mapper->GetRendererChoice();
  EXPECT_NE(choice.find("ed: traced in "), std::string::npos) << choice;
  EXPECT_NE(choice.find(" ms, rasterised in "), std::string::npos) << choice;
  const bool traced = choice.rfind("traced", 0) == 0;
  EXPECT_EQ(FindResource(scene.Mapper, "ray tracing tree").bytes > 0, traced);
  EXPECT_EQ(FindResource(scene.Mapper, "active cells, GPU").bytes > 0, !traced);
}

TEST_F(TracedCellLives, AreMeasuredByOpaqueFramesAlone)
{
  GyroidScene scene;
  scene.Mapper->SetRendererToAutomatic();
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetRendererChoice(), "rasterised: translucent surfaces always are");
  scene.Actor->GetProperty()->SetOpacity(1.0);
  const auto ids = scene.CellIds();
  EXPECT_GT(*std::max_element(ids.begin(), ids.end()), 0);
  const std::string driver = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (driver.find("llvmpipe") == std::string::npos)
    GTEST_SKIP() << "OpenGL by " << driver;
  EXPECT_EQ(
    scene.Mapper->GetRendererChoice(), "traced: OpenGL is software, so rays are tried first");
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetRendererChoice().rfind("traced: OpenGL is software, ", 0), 0U);
}

#else

TEST_F(TracedCellLives, AreRefusedByName)
{
  GyroidScene scene;
  scene.Mapper->SetGlobalWarningDisplay(false);
  scene.Mapper->SetRendererToTrace();
  scene.Mapper->SetGlobalWarningDisplay(true);
  EXPECT_EQ(scene.Mapper->GetRenderer(), vtkHaspClusteredCellMapper::Rasterize);
  scene.Mapper->SetRendererToAutomatic();
  scene.Draw();
  EXPECT_EQ(scene.Mapper->GetRendererChoice().rfind("rasterised: ", 0), 0U);
  EXPECT_TRUE(scene.Point(PixelsX / 2, PixelsY / 2).has_value());
}

#endif

} // namespace
