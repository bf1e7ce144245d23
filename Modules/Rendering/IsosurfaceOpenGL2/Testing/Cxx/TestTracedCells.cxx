// The traced renderer: the same surface, colours and cells as the rasteriser.
#include "GyroidScene.h"

#include "vtkLight.h"
#include "vtkPlane.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#if HASP_WITH_EMBREE

namespace
{

using hasp::testing::GyroidScene;
using hasp::testing::PixelsX;
using hasp::testing::PixelsY;

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

} // namespace

#endif
