// The traced renderer: the same surface, colours and cells as the rasteriser, and nothing of it
// there while it is not used.
#include "CellTestScene.h"
#include "HaspGL.h"
#include "Isosurface/ClusteredCells.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

constexpr int PixelsX = 150, PixelsY = 120;

vtkSmartPointer<vtkImageData> Gyroid()
{
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(50, { 1, 0.9, 1.3 });
  return hasp::MakeImage(
    g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), g, 100, 0));
}

hasp::ResourceUse Find(vtkHaspClusteredCellMapper* mapper, const std::string& name)
{
  hasp::ResourceList list;
  mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == name)
      return use;
  ADD_FAILURE() << "no resource " << name;
  return {};
}

struct GyroidScene : CellTestScene
{
  GyroidScene() : CellTestScene(PixelsX, PixelsY)
  {
    this->Mapper->SetInputData(Gyroid());
    this->Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 200);
  }

  /// Cell ids of all pixels, -1 where nothing is.
  std::vector<vtkIdType> CellIds()
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, PixelsX - 1, PixelsY - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    EXPECT_TRUE(selector->CaptureBuffers());
    std::vector<vtkIdType> ids;
    for (unsigned y = 0; y < PixelsY; ++y)
      for (unsigned x = 0; x < PixelsX; ++x)
      {
        const unsigned pixel[2] = { x, y };
        const auto picked = selector->GetPixelInformation(pixel);
        ids.push_back(picked.Valid ? picked.AttributeID : -1);
      }
    return ids;
  }
};

struct Picture
{
  std::vector<std::optional<glm::dvec3>> points;
  std::vector<unsigned char> colors;
  std::vector<vtkIdType> ids;

  Picture(GyroidScene& scene, int renderer)
  {
    scene.Mapper->SetRenderer(renderer);
    scene.Draw();
    for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
      this->points.push_back(scene.Point(pixel % PixelsX, pixel / PixelsX));
    vtkNew<vtkUnsignedCharArray> rgb;
    scene.Window->GetPixelData(0, 0, PixelsX - 1, PixelsY - 1, 0, rgb);
    this->colors.assign(rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
    this->ids = scene.CellIds();
  }
};

/// Both renderers draw the scene alike.
void ExpectAgreement(GyroidScene& scene)
{
  const Picture traced(scene, vtkHaspClusteredCellMapper::Trace);
  const Picture drawn(scene, vtkHaspClusteredCellMapper::Rasterize);
  int surface = 0, elsewhere = 0, otherColor = 0, otherCell = 0;
  double farthest = 0.0;
  for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
  {
    const auto &a = traced.points[pixel], &b = drawn.points[pixel];
    surface += a || b;
    // At a silhouette one may see the sheet behind, by its last digit.
    if (a.has_value() != b.has_value() || (a && glm::length(*a - *b) > 0.5))
    {
      ++elsewhere;
      continue;
    }
    if (!a)
      continue;
    farthest = std::max(farthest, glm::length(*a - *b));
    otherCell += traced.ids[pixel] != drawn.ids[pixel];
    for (int c = 0; c < 3; ++c)
      otherColor += std::abs(traced.colors[3 * pixel + c] - drawn.colors[3 * pixel + c]) > 2;
  }
  EXPECT_GT(surface, PixelsX * PixelsY / 5);
  EXPECT_LE(elsewhere, surface / 1000);
  // 0.001 voxel of 0.9 mm; and 2 units of a 24-bit depth buffer are 0.0002 mm here.
  EXPECT_LE(farthest, 0.0009 + 0.0002);
  // A hit on the face between two cells is either's, with either's gradient.
  EXPECT_LE(otherCell, surface / 500);
  EXPECT_LE(otherColor, 3 * surface / 500);
}

class TracedCells : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

#if HASP_WITH_EMBREE

TEST_F(TracedCells, LookLikeRasterizedOnes)
{
  GyroidScene scene;
  ExpectAgreement(scene);
}

TEST_F(TracedCells, InParallelProjectionToo)
{
  GyroidScene scene;
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(18);       // a part of the volume, and
  scene.Renderer->GetActiveCamera()->SetWindowCenter(0.3, -0.2); // not its middle
  ExpectAgreement(scene);
}

TEST_F(TracedCells, WhicheverFacesTheActorCulls)
{
  GyroidScene scene;
  scene.Actor->GetProperty()->FrontfaceCullingOn();
  ExpectAgreement(scene);
}

TEST_F(TracedCells, AndFromInside)
{
  GyroidScene scene;
  scene.Look({ 3, 2, 4 }, { 20, -9, 3 }, 1, 100);
  ExpectAgreement(scene);
}

TEST_F(TracedCells, AndSmallInACornerOfTheirViewport)
{
  GyroidScene scene;
  scene.Renderer->SetViewport(0.1, 0.25, 0.95, 1);
  scene.Actor->SetScale(0.5, 0.8, 0.6);
  scene.Actor->SetOrientation(20, 50, -30);
  scene.Actor->SetPosition(15, 0, 10);
  const Picture traced(scene, vtkHaspClusteredCellMapper::Trace);
  const Picture drawn(scene, vtkHaspClusteredCellMapper::Rasterize);
  int surface = 0, differ = 0;
  for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
  {
    surface += drawn.points[pixel].has_value();
    differ += std::abs(traced.colors[3 * pixel] - drawn.colors[3 * pixel]) > 2;
  }
  EXPECT_GT(surface, 1000);
  EXPECT_LE(differ, surface / 200);
}

TEST_F(TracedCells, ForEachEyeAndEachTile)
{
  using Colors = std::vector<unsigned char>;
  const auto draw = [](GyroidScene& scene)
  {
    scene.Draw();
    vtkNew<vtkUnsignedCharArray> rgb;
    scene.Window->GetPixelData(0, 0, PixelsX - 1, PixelsY - 1, 0, rgb);
    return Colors(rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  };
  const auto differ = [](const Colors& a, const Colors& b)
  {
    int pixels = 0;
    for (std::size_t n = 0; n < a.size(); n += 3)
      pixels += std::abs(a[n] - b[n]) > 2;
    return pixels;
  };
  constexpr int few = PixelsX * PixelsY / 200; // silhouettes, faces between two cells
  for (const bool tiled : { false, true })
  {
    GyroidScene scene;
    if (tiled)
    {
      scene.Window->SetTileScale(2);
      scene.Window->SetTileViewport(0.5, 0, 1, 0.5);
    }
    else
    {
      scene.Window->SetStereoTypeToSplitViewportHorizontal();
      scene.Window->StereoRenderOn();
    }
    scene.Actor->GetProperty()->SetAmbient(0.1); // nothing is as black as the background
    const Colors drawn = draw(scene);
    EXPECT_GT(differ(drawn, Colors(drawn.size())), 2000);
    EXPECT_EQ(draw(scene), drawn); // by what was seen, be it by the other eye
    scene.Mapper->OcclusionCullingOff();
    EXPECT_EQ(draw(scene), drawn);
    scene.Mapper->SetRendererToTrace();
    EXPECT_LE(differ(draw(scene), drawn), few) << "tiled " << tiled;
    // VTK's mesh covers the same pixels, up to its silhouettes.
    scene.ShowMesh();
    const Colors mesh = draw(scene);
    int elsewhere = 0;
    for (std::size_t n = 0; n < mesh.size(); n += 3)
      elsewhere += (mesh[n] > 0) != (drawn[n] > 0);
    EXPECT_LE(elsewhere, few) << "tiled " << tiled;
  }
}

TEST_F(TracedCells, WithClippingPlanesLightsAndGloss)
{
  GyroidScene scene;
  for (const double side : { -1.0, 1.0 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(-0.3, side, 0.2);
    plane->SetOrigin(0, -12 * side, 0);
    scene.Mapper->AddClippingPlane(plane);
  }
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetPosition(30, -30, 40);
  lamp->SetConeAngle(40);
  lamp->SetAttenuationValues(1, 0.002, 0);
  lamp->SetColor(1, 0.8, 0.4);
  scene.Renderer->AddLight(lamp);
  vtkNew<vtkLight> sun;
  sun->SetPosition(-1, -1, 2);
  scene.Renderer->AddLight(sun);
  scene.Actor->GetProperty()->SetSpecular(0.6);
  scene.Actor->GetProperty()->SetSpecularPower(12);
  scene.Actor->GetProperty()->SetColor(0.9, 0.6, 0.5);
  ExpectAgreement(scene);
}

TEST_F(TracedCells, OfFloatVolumesAndCompactCells)
{
  GyroidScene scene;
  scene.Mapper->SetPrecisionToCompact();
  ExpectAgreement(scene);
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(50, { 1, 0.9, 1.3 });
  scene.Mapper->SetInputData(
    hasp::MakeImage(g, hasp::SampleAnalytic<float>(hasp::AnalyticGyroid(20), g, 1e-3, 5)));
  scene.Mapper->SetIsoValue(5);
  scene.Mapper->SetPrecisionToExact();
  ExpectAgreement(scene);
}

TEST_F(TracedCells, AreNotThereUntilAskedForAndGoneAfterwards)
{
  GyroidScene scene;
  vtkHaspClusteredCellMapper* mapper = scene.Mapper;
  const auto bytes = [&](const char* name) { return Find(mapper, name).bytes; };
  scene.Draw();
  EXPECT_EQ(mapper->GetRendererChoice(), "rasterised: as asked for");
  for (const char* name : { "ray tracing tree", "traced picture", "shader: traced cells" })
  {
    EXPECT_EQ(bytes(name), 0U) << name;
    EXPECT_EQ(Find(mapper, name).milliseconds, 0.0) << name;
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

TEST_F(TracedCells, FollowIsovalueAndInput)
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
  EXPECT_EQ(Find(scene.Mapper, "ray tracing tree").bytes, 0U);
  EXPECT_EQ(Find(scene.Mapper, "traced picture").bytes, 0U);
  scene.Mapper->SetIsoValue(0);
  scene.Mapper->SetInputData(image(12));
  EXPECT_NEAR(depth(), 12, 0.1);
}

TEST_F(TracedCells, LiveInTwoWindowsAndLeaveNothingBehind)
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
  const double tree = Find(first.Mapper, "ray tracing tree").milliseconds;
  second.reset();
  first.Draw();
  EXPECT_TRUE(first.Point(PixelsX / 2, PixelsY / 2).has_value());
  EXPECT_EQ(Find(first.Mapper, "ray tracing tree").milliseconds, tree) << "it was made anew";
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

TEST_F(TracedCells, AreChosenByMeasurementWhereOpenGLIsSoftware)
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
  EXPECT_EQ(Find(scene.Mapper, "ray tracing tree").bytes > 0, traced);
  EXPECT_EQ(Find(scene.Mapper, "active cells, GPU").bytes > 0, !traced);
}

TEST_F(TracedCells, AreMeasuredByOpaqueFramesAlone)
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

TEST_F(TracedCells, AreRefusedByName)
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
