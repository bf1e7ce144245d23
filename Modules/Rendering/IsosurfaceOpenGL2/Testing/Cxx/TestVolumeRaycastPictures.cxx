// Isosurfaces by a ray a pixel on the GPU, against other ways to draw and pick them.
#include "RaycastTestScene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

namespace
{

using hasp::testing::ObliqueGrid;
using hasp::testing::RaycastModes;
using hasp::testing::RaycastScene;

class RaycastPictures : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

const hasp::AnalyticVolume Gyroid = hasp::AnalyticGyroid(25);

TEST_F(RaycastPictures, FollowsTurnedStretchedAndMirroredActors)
{
  RaycastScene scene;
  const auto sphere = hasp::AnalyticSphere({ 1, 2, 3 }, 14);
  scene.Show<float>(sphere, ObliqueGrid(44, { 1.0, 0.8, 1.3 }));
  vtkNew<vtkTransform> turn;
  turn->Translate(3, -5, 7);
  turn->RotateWXYZ(33, 1, 2, 3);
  turn->Scale(-1.5, 1, 1.2);
  scene.Actor->SetUserTransform(turn);
  const glm::dmat4 back =
    glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(turn->GetMatrix()->GetData()))));
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    int shown = 0;
    double error = 0.0;
    for (const auto& point : scene.Points())
    {
      shown += point.has_value();
      if (point)
        error = std::max(error, std::abs(sphere.value(glm::dvec3(back * glm::dvec4(*point, 1)))));
    }
    EXPECT_GT(shown, 2000);
    EXPECT_LT(error, 0.03); // trilinear interpolation of a sphere: spacing^2 / (8 radius) an axis
  }
}

TEST_F(RaycastPictures, LooksLikeClusteredCellsToEachEyeAndInEachTile)
{
  for (const std::string view : { "mono", "stereo", "tile", "viewport" })
  {
    RaycastScene scene;
    scene.Show<std::int16_t>(Gyroid, ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
    scene.Mapper->SetInputData(scene.Raycaster->GetImage());
    vtkNew<vtkLight> lamp;
    lamp->SetPositional(true);
    lamp->SetPosition(30, -50, 40);
    lamp->SetConeAngle(40);
    lamp->SetAttenuationValues(1, 0.002, 0);
    lamp->SetColor(1, 0.8, 0.4);
    scene.Renderer->AddLight(lamp);
    scene.Actor->GetProperty()->SetAmbient(0.1); // nothing is as black as the background
    scene.Actor->GetProperty()->SetSpecular(0.6);
    scene.Actor->GetProperty()->SetSpecularPower(12);
    if (view == "stereo")
    {
      scene.Window->SetStereoTypeToSplitViewportHorizontal();
      scene.Window->StereoRenderOn();
    }
    if (view == "tile")
    {
      scene.Window->SetTileScale(2);
      scene.Window->SetTileViewport(0.5, 0, 1, 0.5);
    }
    if (view == "viewport")
      scene.Renderer->SetViewport(0.1, 0.25, 0.95, 1);
    const auto colors = [&](vtkMapper* mapper)
    {
      scene.Actor->SetMapper(mapper);
      return scene.Colors();
    };
    const auto cells = colors(scene.Mapper);
    for (const int mode : RaycastModes)
    {
      scene.Raycaster->SetMode(mode);
      const auto rays = colors(scene.Raycaster);
      int shown = 0, differ = 0;
      for (std::size_t n = 0; n < cells.size(); ++n)
      {
        shown += cells[n] > 0;
        differ += std::abs(cells[n] - rays[n]) > 2;
      }
      EXPECT_GT(shown, 6000) << view;
      EXPECT_LE(differ, shown / 200) << view; // rims, and hits between two cells
    }
  }
}

TEST_F(RaycastPictures, SkippingShowsTheSamePicture)
{
  RaycastScene scene;
  scene.Actor->GetProperty()->SetSpecular(0.5);
  for (const double step : { 0.3, 1.0, 4.0 })
    for (const double isovalue : { 0.0, 250.0, -300.0 })
    {
      scene.Show<std::int16_t>(Gyroid, ObliqueGrid(51, { 1.0, 0.8, 1.3 }));
      scene.Raycaster->SetStepSize(step);
      scene.Raycaster->SetIsoValue(isovalue);
      std::vector<unsigned char> colors[2];
      std::vector<std::optional<glm::dvec3>> points[2];
      for (const bool skipping : { false, true })
      {
        scene.Raycaster->SetMode(RaycastModes[skipping]);
        points[skipping] = scene.Points();
        colors[skipping] = scene.Colors();
      }
      EXPECT_EQ(points[0], points[1]) << step << " " << isovalue;
      EXPECT_EQ(colors[0], colors[1]) << step << " " << isovalue;
      EXPECT_NE(std::count(points[0].begin(), points[0].end(), std::nullopt),
        std::ptrdiff_t(points[0].size()));
    }
}

TEST_F(RaycastPictures, GivesTheImagesCellsToSelections)
{
  RaycastScene scene;
  const hasp::GridGeometry g = ObliqueGrid(44, { 1.0, 0.8, 1.3 });
  scene.Show<std::int16_t>(Gyroid, g);
  const hasp::AnyGridView grid = hasp::ViewImage(scene.Raycaster->GetImage());
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    scene.Draw();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.Renderer);
    selector->SetArea(0, 0, RaycastScene::PixelsX - 1, RaycastScene::PixelsY - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    ASSERT_TRUE(selector->CaptureBuffers());
    int picked = 0, other = 0;
    for (unsigned y = 0; y < RaycastScene::PixelsY; ++y)
      for (unsigned x = 0; x < RaycastScene::PixelsX; ++x)
      {
        const unsigned pixel[2] = { x, y };
        const auto found = selector->GetPixelInformation(pixel);
        const auto [origin, direction] = scene.Ray(int(x), int(y));
        const auto truth = hasp::FirstTrilinearHit(grid, 0.0, origin, direction);
        if (!found.Valid || !truth)
          continue;
        const glm::ivec3 cells = g.dims - 1, cell = truth->cell;
        ++picked;
        other += found.AttributeID != cell.x + cells.x * (cell.y + vtkIdType{ cells.y } * cell.z);
        EXPECT_EQ(found.Prop, scene.Actor.GetPointer());
      }
    EXPECT_GT(picked, 3000);
    EXPECT_LE(other, picked / 100); // rims that are missed, and faces between two cells
  }
}

} // namespace
