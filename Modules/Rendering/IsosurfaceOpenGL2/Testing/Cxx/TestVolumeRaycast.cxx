// Isosurfaces by a ray a pixel on the GPU: what they show is what rays in long double meet.
#include "RaycastTestScene.h"

#include "vtkPlane.h"

#include <iostream>
#include <limits>

namespace
{

using hasp::testing::Find;
using hasp::testing::Judgement;
using hasp::testing::ObliqueGrid;
using hasp::testing::RaycastModes;
using hasp::testing::RaycastScene;

class VolumeRaycast : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  /// In both modes. Rays of floats end within 0.001 voxel. What one step of a voxel misses: the rim
  /// of a silhouette, where a ray is less than a step inside. Where the surface has a radius of 6
  /// voxels that rim is 1/48 voxel wide.
  static void Hold(RaycastScene& scene, const std::string& what, double digits = 0.0,
    const std::function<double(const glm::dvec3&, const glm::dvec3&)>& start = {})
  {
    scene.Draw();
    const auto truth = scene.Truth(start);
    for (const int mode : RaycastModes)
    {
      scene.Raycaster->SetMode(mode);
      scene.Draw();
      const Judgement judged = scene.Judge(truth);
      EXPECT_GT(judged.surface, 3000) << what;
      EXPECT_LE(judged.missed, judged.surface / 300) << what;
      EXPECT_LE(judged.invented, judged.surface / 2000) << what; // tangents that rounding meets
      EXPECT_LE(judged.error, 0.001 + digits) << what;
      EXPECT_EQ(scene.Errors, std::vector<std::string>()) << what;
      std::cout << what << ", mode " << mode << ": " << judged.surface << " pixels, "
                << judged.missed << " missed, " << judged.invented << " invented, error "
                << judged.error << " voxels\n";
    }
  }
};

const hasp::AnalyticVolume Gyroid = hasp::AnalyticGyroid(25);

TEST_F(VolumeRaycast, MeetsTheTrueRootInEverySampleType)
{
  const hasp::GridGeometry g = ObliqueGrid(52, { 1.0, 0.8, 1.3 });
  RaycastScene scene;
  scene.Show<std::int16_t>(Gyroid, g);
  Hold(scene, "int16");
  scene.Show<std::uint16_t>(Gyroid, g, 100, 40000); // above what signed numbers hold
  Hold(scene, "uint16");
  scene.Show<std::uint8_t>(Gyroid, g, 15, 128);
  Hold(scene, "uint8");
  scene.Show<float>(Gyroid, g, 1e-3, 1e-2);
  Hold(scene, "float");
}

TEST_F(VolumeRaycast, OfLongCellsAndOfNoise)
{
  RaycastScene scene;
  hasp::GridGeometry g = ObliqueGrid(40, { 0.5, 0.4, 50 });
  g.dims.z = 9;
  g.origin = -(g.direction * (g.spacing * glm::dvec3(g.dims - 1) * 0.5));
  const glm::dmat3 toIndex = glm::transpose(g.direction);
  scene.Show<std::int16_t>({ "waves along short and long axes",
                             [&](const glm::dvec3& p)
                             {
                               const glm::dvec3 i = toIndex * p / g.spacing;
                               return std::sin(0.5 * i.x) + std::cos(0.4 * i.y) + std::sin(i.z);
                             } },
    g, 1000);
  scene.Look(g.direction * glm::dvec3(40, -30, 60), { 0, 0, 0 }, 5, 400);
  scene.Raycaster->SetStepSize(0.25); // waves of some voxels: their rims are wider
  Hold(scene, "long cells");

  g = ObliqueGrid(30, { 1, 1, 1 });
  unsigned state = 1;
  std::vector<std::int16_t> samples(std::size_t(g.dims.x) * g.dims.y * g.dims.z);
  for (auto& sample : samples)
    sample = static_cast<std::int16_t>((state = state * 1664525U + 1013904223U) >> 16);
  scene.Raycaster->SetInputData(hasp::MakeImage(g, samples));
  scene.Raycaster->SetStepSize(0.05); // every cell has several sheets
  scene.Look({ 30, -40, 20 }, { 0, 0, 0 }, 5, 100);
  Hold(scene, "noise");
}

TEST_F(VolumeRaycast, MissesLessWithShorterSteps)
{
  RaycastScene scene;
  scene.Show<std::int16_t>(Gyroid, ObliqueGrid(52, { 1.0, 0.8, 1.3 }));
  scene.Look({ 0, 0, 0 }, { 1, 0.3, 0.2 }, 0.5, 100);
  scene.Draw();
  const auto truth = scene.Truth();
  int missed[2];
  for (const int fine : { 0, 1 })
  {
    scene.Raycaster->SetStepSize(fine ? 0.05 : 2.0);
    scene.Draw();
    missed[fine] = scene.Judge(truth).missed;
  }
  EXPECT_GT(missed[0], 20);
  EXPECT_LE(missed[1], missed[0] / 20); // the rim grows with the square of the step
}

TEST_F(VolumeRaycast, SeesThroughEveryCamera)
{
  RaycastScene scene;
  scene.Show<std::int16_t>(Gyroid, ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetWindowCenter(0.6, -0.3); // an eye far beside the screen's middle
  Hold(scene, "off-axis");
  camera->SetParallelProjection(true);
  camera->SetParallelScale(22);
  Hold(scene, "parallel");
  camera->SetWindowCenter(0, 0);
  camera->SetParallelProjection(false);
  for (const glm::dvec3 eye : { glm::dvec3(0, 0, 0), glm::dvec3(4, 4, -9), glm::dvec3(-7.5, 0, 2) })
  {
    scene.Look(eye, eye + glm::dvec3(1, 0.3, 0.2), 0.5, 100);
    Hold(scene, "inside");
  }
}

TEST_F(VolumeRaycast, SeesAMillionVoxelsFar)
{
  RaycastScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 25), ObliqueGrid(64, { 1, 1, 1 }));
  scene.Look(glm::normalize(glm::dvec3(2, -3, 1)) * 1e6, { 0, 0, 0 }, 1e6 - 60, 1e6 + 60);
  scene.Renderer->GetActiveCamera()->SetViewAngle(0.0038);
  Hold(scene, "far");
}

TEST_F(VolumeRaycast, CutsAtPlanesAndAtTheNearAndFarOne)
{
  RaycastScene scene;
  scene.Show<std::int16_t>(Gyroid, ObliqueGrid(48, { 1.0, 0.8, 1.3 }));
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 1, 0.2)), at(1, 2, 3);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.x, normal.y, normal.z);
  plane->SetOrigin(at.x, at.y, at.z);
  scene.Raycaster->AddClippingPlane(plane);
  Hold(scene, "clipped", 0.0,
    [&](const glm::dvec3& origin, const glm::dvec3& direction) // all rays run along the normal
    { return std::max(0.0, glm::dot(at - origin, normal) / glm::dot(direction, normal)); });
  scene.Raycaster->RemoveAllClippingPlanes();
  scene.Look({ 60, -80, 40 }, { 0, 0, 0 }, 104, 200);
  Hold(scene, "cut by the near plane");
  scene.Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 108); // 0.3 mm before the middle
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    int shown = 0;
    double farthest = 0.0;
    const glm::dvec3 eye(60, -80, 40);
    for (const auto& point : scene.Points())
    {
      shown += point.has_value();
      farthest =
        point ? std::max(farthest, glm::dot(*point - eye, -glm::normalize(eye))) : farthest;
    }
    EXPECT_LE(farthest, 108.001);
    EXPECT_GT(shown, 2000);
  }
}

// A sheet 0.2 voxels thick: a step of one voxel falls into it as often as its chord is long, for
// the first sample lies anywhere. No step of 0.2 voxels misses it.
TEST_F(VolumeRaycast, MissesWhatIsThinnerThanAStep)
{
  RaycastScene scene;
  const hasp::GridGeometry g{ { 40, 40, 40 }, glm::dvec3(-19.5), { 1, 1, 1 }, glm::dmat3(1) };
  const hasp::AnalyticVolume sheet{ "sheet",
    [](const glm::dvec3& p) { return 1.0 - std::abs(p.y - 0.5); } };
  scene.Show<std::int16_t>(sheet, g, 1000);
  scene.Raycaster->SetIsoValue(900);
  scene.Draw();
  const auto truth = scene.Truth();
  for (const int mode : RaycastModes)
  {
    scene.Raycaster->SetMode(mode);
    scene.Raycaster->SetStepSize(1.0);
    scene.Draw();
    const Judgement coarse = scene.Judge(truth);
    const double caught = 1.0 - double(coarse.missed) / coarse.surface;
    EXPECT_GT(coarse.surface, 2000);
    EXPECT_GT(caught, 0.2); // the chord at a right angle
    EXPECT_LT(caught, 0.4); // the same at 60 degrees, more than this camera sees it under
    scene.Raycaster->SetStepSize(0.2);
    scene.Draw();
    const Judgement fine = scene.Judge(truth);
    EXPECT_EQ(fine.missed, 0);
    EXPECT_LT(fine.error, 0.001);
  }
}

TEST_F(VolumeRaycast, LeavesCellsOfWhatAreNoNumbersEmpty)
{
  RaycastScene scene;
  const hasp::GridGeometry g = ObliqueGrid(44, { 1.0, 0.8, 1.3 });
  auto samples = hasp::SampleAnalytic<float>(Gyroid, g, 1, 0);
  for (std::size_t n = 0; n < samples.size(); ++n)
    if (n % 997 == 0) // a step that ends in an empty cell shows no change: each hides some surface
      samples[n] =
        n % 2 ? std::numeric_limits<float>::quiet_NaN() : -std::numeric_limits<float>::infinity();
  scene.Raycaster->SetInputData(hasp::MakeImage(g, samples));
  Hold(scene, "with holes");
}

TEST_F(VolumeRaycast, OfLongAxesIsDrawnInParts)
{
  RaycastScene scene;
  hasp::GridGeometry g{ { 2300, 30, 34 }, {}, { 1, 1, 1 }, glm::dmat3(1) };
  g.origin = { -2047.3, -14.5, -16.5 }; // the first texture ends in the ball's middle
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 13), g, 50);
  scene.Look({ 20, -50, 20 }, { 0, 0, 0 }, 20, 120);
  Hold(scene, "two textures", 0.001); // at 2047 floats have 1.2e-4 left, tenfold where a ray grazes
  EXPECT_EQ(Find(scene.Raycaster, "raycast samples, GPU").reason.substr(0, 2), "2 ");
}

} // namespace
