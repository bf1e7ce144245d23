// Light that cells and polydata share: shadows both ways, darkening both ways, the same light on
// the same shapes.
#include "LightTestScene.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

namespace
{

using hasp::testing::Difference;
using hasp::testing::LightTestScene;

/// A ball of radius 10 over a floor 15 below its middle, and a lamp straight above.
struct TableScene : LightTestScene
{
  vtkSmartPointer<vtkActor> Ball;

  explicit TableScene(bool cells)
  {
    this->Ball = cells ? this->AddCellBall(10, { 0, 0, 0 }) : this->AddMeshBall(10, { 0, 0, 0 });
    this->AddFloor(40, -15);
    this->AddLamp({ 0, 0, 100 });
    this->Look({ 0, -90, 60 });
    this->Pass->SetModeToLamps();
  }
};

TEST(LightPass, ABallOfEitherKindShadowsTheFloor)
{
  for (const bool cells : { true, false })
  {
    TableScene scene(cells);
    const auto lit = scene.Draw();
    EXPECT_LE(scene.Grey(lit, { 0, -9, -15 }), 2) << "within its shadow";
    EXPECT_GE(scene.Grey(lit, { 0, -11.5, -15 }), 250)
      << "beside its shadow, straight below a lamp";
    EXPECT_GE(scene.Grey(lit, { 0, 0, 10 }), 250);
    scene.Pass->ShadowsOff();
    EXPECT_GE(scene.Grey(scene.Draw(), { 0, -9, -15 }), 250);
  }
}

TEST(LightPass, ALightsShadowTakesTheShareItSays)
{
  TableScene scene(true);
  vtkLight* lamp = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  lamp->SetIntensity(0.8);
  for (const float share : { 1.0F, 0.5F, 0.0F })
  {
    lamp->SetShadowAttenuation(share);
    const auto lit = scene.Draw();
    EXPECT_NEAR(scene.Grey(lit, { 0, -9, -15 }), 204 * (1.0F - share), 2) << share;
    EXPECT_NEAR(scene.Grey(lit, { 0, -12, -15 }), 204, 2) << share;
  }
}

TEST(LightPass, PolydataShadowCellsAndCellsPolydata)
{
  for (const bool cellsAbove : { true, false })
  {
    LightTestScene scene;
    cellsAbove ? scene.AddCellBall(5, { 0, 0, 22 }) : scene.AddMeshBall(5, { 0, 0, 22 });
    cellsAbove ? scene.AddMeshBall(10, { 0, 0, 0 }) : scene.AddCellBall(10, { 0, 0, 0 });
    scene.AddLamp({ 0, 0, 100 });
    scene.Look({ 0, -80, 30 }, { 0, 0, 8 });
    scene.Pass->SetModeToLamps();
    const auto pixels = scene.Draw();
    const auto below = [](double x) { return glm::dvec3(x, -3, std::sqrt(91 - x * x)); };
    EXPECT_LE(scene.Grey(pixels, below(0)), 2) << cellsAbove;
    EXPECT_GE(scene.Grey(pixels, below(6)), 150) << cellsAbove;
  }
}

TEST(LightPass, LampsShadeBothKindsAsVTKDoes)
{
  for (const bool cells : { true, false })
  {
    TableScene scene(cells);
    const auto ours = scene.Draw();
    scene.Renderer->SetPass(nullptr);
    const auto vtks = scene.Draw();
    // Where nothing shadows. Matt surfaces, so only rounding is left: of 8 bits, and of normals
    // of triangles.
    for (const glm::dvec3& place : { glm::dvec3(0, 0, 10), glm::dvec3(0, -6, 8),
           glm::dvec3(5, -5, std::sqrt(50.0)), glm::dvec3(20, -20, -15) })
      EXPECT_NEAR(scene.Grey(ours, place), scene.Grey(vtks, place), 4) << place.x << " " << cells;
  }
}

TEST(LightPass, AmbientOcclusionDarkensWhereBodiesMeet)
{
  for (const bool cells : { true, false })
  {
    LightTestScene scene;
    cells ? scene.AddCellBall(10, { 0, 0, 10 }) : scene.AddMeshBall(10, { 0, 0, 10 });
    scene.AddFloor(60, 0);
    scene.AddLamp({ 0, -100, 100 });
    scene.Look({ 0, -90, 60 });
    scene.Pass->SetModeToAmbientOcclusion();
    scene.Pass->ShadowsOff();
    scene.Pass->SetAmbientOcclusionDistance(1e6);
    const auto open = scene.Draw(32);
    // Floor at distance d from where a ball of radius r touches it: the ball takes the share
    // r^2 h / D^3 of the cosine-weighted hemisphere, h its middle's height, D the distance to it.
    scene.Pass->SetModeToLamps();
    const auto lamps = scene.Draw();
    for (const double d : { 14.0, 18.0, 25.0, 35.0 })
    {
      const double D = std::hypot(d, 10.0), share = 1.0 - 100.0 * 10.0 / (D * D * D);
      const glm::dvec3 place(0, -d, 0);
      EXPECT_NEAR(scene.Grey(open, place) / double(scene.Grey(lamps, place)), share, 0.03)
        << d << " " << cells; // 64 samples and more: 0.02, and what lattices blur
    }
    scene.Pass->SetModeToAmbientOcclusion();
    scene.Pass->SetAmbientOcclusionDistance(1.0);
    EXPECT_NEAR(scene.Grey(scene.Draw(4), { 0, -18, 0 }), scene.Grey(lamps, { 0, -18, 0 }), 2);
  }
}

TEST(LightPass, TheSameLightFallsOnCellsAndOnTriangles)
{
  LightTestScene cells, mesh;
  cells.AddCellBall(20, { 0, 0, 0 }, 0.8);
  mesh.AddMeshBall(20, { 0, 0, 0 }, 0.8);
  for (LightTestScene* scene : { &cells, &mesh })
  {
    scene->AddFloor(60, -20, 0.6);
    scene->Look({ 0, -130, 60 });
    scene->Pass->SetModeToPathTraced();
    scene->Pass->SetSamplesPerPixel(64);
    scene->Pass->WaitForSamplesOn();
    scene->Pass->TemporalAccumulationOff();
  }
  // Silhouettes of 1 mm triangles differ by parts of a pixel; noise is about 1%.
  EXPECT_LT(Difference(cells.Draw(), mesh.Draw()), 4.0);
  EXPECT_EQ(cells.Pass->GetSamples(), 64);
}

TEST(LightPass, KeptLightIsThatOfPaths)
{
  LightTestScene scene;
  scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
  scene.AddFloor(60, -20, 0.6);
  scene.Look({ 0, -130, 60 });
  scene.Pass->SetModeToTraced();
  const auto first = scene.Draw();
  const auto kept = scene.Draw(32);
  scene.Pass->SetModeToPathTraced();
  scene.Pass->SetSamplesPerPixel(256);
  scene.Pass->WaitForSamplesOn();
  scene.Pass->TemporalAccumulationOff();
  const auto truth = scene.Draw();
  ASSERT_EQ(scene.Pass->GetSamples(), 256);
  EXPECT_LT(Difference(kept, truth), 6.0); // edges are smooth in one and not in the other
  EXPECT_LT(Difference(kept, truth), Difference(first, truth));
}

TEST(LightPass, AnEnvironmentLightsAsVTKTurnsIt)
{
  // One bright pixel of a map: where VTK's image based lighting has that direction, the ball is
  // lit.
  vtkNew<vtkImageData> map;
  map->SetDimensions(32, 16, 1);
  vtkNew<vtkFloatArray> light;
  light->SetNumberOfComponents(3);
  light->SetNumberOfTuples(32 * 16);
  light->Fill(0.01);
  map->GetPointData()->SetScalars(light);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(map);
  const auto brightest = [&](int column, int row, const glm::dvec3& towards)
  {
    light->Fill(0.01);
    for (int c = 0; c < 3; ++c)
      light->SetComponent(row * 32 + column, c, 300.0);
    light->Modified();
    map->Modified();
    LightTestScene scene;
    scene.AddCellBall(20, { 0, 0, 0 }, 0.8);
    scene.Renderer->SetEnvironmentTexture(texture);
    scene.Renderer->SetEnvironmentUp(0, 0, 1);
    scene.Renderer->SetEnvironmentRight(0, -1, 0);
    scene.Look(100.0 * towards + glm::dvec3(0.1, 0, 0));
    scene.Pass->SetModeToTraced();
    const int towardsIt = scene.Grey(scene.Draw(4), 20.0 * towards);
    scene.Look(-100.0 * towards + glm::dvec3(0.1, 0, 0));
    EXPECT_GT(towardsIt, 3 * scene.Grey(scene.Draw(4), -20.0 * towards) + 20);
  };
  brightest(16, 8, { 0, -1, 0 }); // the centre: EnvironmentRight
  brightest(0, 8, { 0, 1, 0 });   // behind
  brightest(16, 15, { 0, 0, 1 }); // rows of VTK's images go up
  // A quarter to the right of who stands within and looks at the centre: Right x Up = (-1, 0, 0).
  brightest(24, 8, { -1, 0, 0 });
}

TEST(LightPass, ColoursOfPolydataAreTaken)
{
  LightTestScene scene;
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-20, -20, 0);
  source->SetPoint1(20, -20, 0);
  source->SetPoint2(-20, 20, 0);
  source->SetXResolution(2);
  source->Update();
  vtkNew<vtkUnsignedCharArray> colors; // of cells: left red, right green
  colors->SetNumberOfComponents(3);
  colors->InsertNextTuple3(255, 0, 0);
  colors->InsertNextTuple3(0, 255, 0);
  source->GetOutput()->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(source->GetOutput());
  scene.Add(mapper, { 0, 0, 0 });
  scene.AddLamp({ 0, 0, 100 });
  scene.Look({ 0, 0, 90 });
  scene.Pass->SetModeToLamps();
  const auto pixels = scene.Draw();
  const auto color = [&](double x)
  {
    const glm::ivec2 at = scene.PixelOf({ x, 0, 0 });
    const vtkIdType n = at.y * scene.Width + at.x;
    return glm::ivec3(pixels->GetTypedComponent(n, 0), pixels->GetTypedComponent(n, 1),
      pixels->GetTypedComponent(n, 2));
  };
  EXPECT_EQ(color(-10), glm::ivec3(255, 0, 0));
  EXPECT_EQ(color(10), glm::ivec3(0, 255, 0));
}

} // namespace
