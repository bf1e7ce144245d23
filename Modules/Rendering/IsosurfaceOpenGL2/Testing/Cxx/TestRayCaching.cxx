// What the ray cache shows once it is complete, what it follows, and hard cases.
#include "RaycastTestScene.h"
#include "vtkHaspPickedCell.h"

#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"

#include <glm/common.hpp>

#include <cstdlib>
#include <random>

namespace
{

using hasp::testing::Find;
using hasp::testing::Judgement;
using hasp::testing::ObliqueGrid;
using hasp::testing::RaycastScene;

struct CacheScene : RaycastScene
{
  CacheScene() { this->Raycaster->SetModeToCache(); }

  /// Frames until nothing new is found for a while.
  int Converge(int most = 400)
  {
    int frame = 0;
    for (int quiet = 0; quiet < 16 && frame < most; ++frame)
    {
      this->Window->Render();
      quiet = this->Raycaster->IsRefining() ? 0 : quiet + 1;
    }
    this->Draw();
    return frame;
  }
  Judgement JudgeConverged()
  {
    EXPECT_LT(this->Converge(), 400);
    EXPECT_TRUE(this->Errors.empty()) << this->Errors.front();
    return this->Judge(this->Truth());
  }
  /// How many clusters, or rays, a resource's reason begins with.
  int Count(const std::string& resource)
  {
    return std::atoi(Find(this->Raycaster, resource).reason.c_str());
  }
};

class RayCaching : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// The exact root, to what the depth buffer keeps: 1e-3 voxel.
void ExpectExact(const Judgement& judged, int leastSurface)
{
  EXPECT_GE(judged.surface, leastSurface);
  EXPECT_LE(judged.missed, 1 + judged.surface / 1000); // a block of which a pixel's corner shows
  EXPECT_EQ(judged.invented, 0);
  EXPECT_LT(judged.error, 2e-3);
}

/// What draws the cells is there for both.
const std::vector<std::pair<int, std::string>> Renderers = {
  { vtkHaspClusteredCellMapper::Rasterize, "rasterised: as asked for" },
#if HASP_WITH_EMBREE
  { vtkHaspClusteredCellMapper::Trace, "traced: as asked for" },
#endif
};

TEST_F(RayCaching, ShowsTheExactSurface)
{
  for (const auto& [renderer, text] : Renderers)
    for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(0.6, 0.9, 1.7) })
    {
      SCOPED_TRACE(text);
      CacheScene scene;
      scene.Raycaster->SetRenderer(renderer);
      scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(40, spacing));
      ExpectExact(scene.JudgeConverged(), 3000);
      EXPECT_EQ(scene.Raycaster->GetModeChoice(), "cache: asked for; " + text);
      EXPECT_GT(Find(scene.Raycaster, "drawing of cached cells").bytes, 0U);
    }
}

/// A cache that is traced holds no more than one that is rasterised: what no ray has met yet is a
/// hole in both.
TEST_F(RayCaching, TracesNothingButTheCache)
{
  std::vector<std::vector<unsigned char>> pictures;
  for (const auto& [renderer, text] : Renderers)
  {
    CacheScene scene;
    scene.Raycaster->SetRenderer(renderer);
    scene.Raycaster->SetRaysPerTile(1);
    scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(50, { 1, 1, 1 }));
    pictures.push_back(scene.Colors());
    EXPECT_TRUE(scene.Raycaster->IsRefining());
  }
  std::size_t different = 0;
  for (std::size_t n = 0; n < pictures.front().size(); ++n)
    different += pictures.front()[n] != pictures.back()[n];
  EXPECT_LE(different, pictures.front().size() / 1000); // edges of what was found
}

TEST_F(RayCaching, DrawsEverySampleType)
{
  const auto show = [](const auto& samples, double offset)
  {
    using T = std::decay_t<decltype(samples)>;
    CacheScene scene;
    scene.Show<T>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(40, { 1, 1, 1 }), 5, offset);
    ExpectExact(scene.JudgeConverged(), 1000);
  };
  show(std::int16_t{}, 0);
  show(std::uint16_t{}, 1000);
  show(std::uint8_t{}, 128);
  show(0.0F, 0);
}

/// The same cells by the same shader: but for holes, the same picture.
TEST_F(RayCaching, LooksLikeClusteredCells)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(50, { 1, 1, 1 }));
  scene.Actor->GetProperty()->SetSpecular(0.4);
  scene.Converge();
  const auto cached = scene.Colors();
  scene.Mapper->SetInputData(scene.Raycaster->GetImage());
  scene.Mapper->SetOcclusionCulling(false);
  scene.Actor->SetMapper(scene.Mapper);
  const auto cells = scene.Colors();
  std::size_t different = 0;
  for (std::size_t n = 0; n < cells.size(); ++n)
    different += cells[n] != cached[n];
  EXPECT_LE(different, cells.size() / 1000);
}

TEST_F(RayCaching, FollowsTheIsovalue)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(50, { 1, 1, 1 }));
  scene.Converge();
  for (const double isovalue : { 200.0, -300.0, 20.0 })
  {
    scene.Raycaster->SetIsoValue(isovalue);
    scene.Draw(); // what the old clusters hold of it is right at once
    EXPECT_EQ(scene.Judge(scene.Truth()).invented, 0);
    ExpectExact(scene.JudgeConverged(), 500);
  }
  scene.Raycaster->SetIsoValue(1e6);
  EXPECT_FALSE(scene.Shows());
  EXPECT_EQ(scene.Count("ray cache"), 0);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST_F(RayCaching, FollowsAnEdit)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(50, { 1, 1, 1 }));
  scene.Converge();
  vtkImageData* image = scene.Raycaster->GetImage();
  const int box[6] = { 15, 35, 0, 22, 15, 40 };
  for (int k = box[4]; k <= box[5]; ++k)
    for (int j = box[2]; j <= box[3]; ++j)
      for (int i = box[0]; i <= box[1]; ++i)
        *static_cast<std::int16_t*>(image->GetScalarPointer(i, j, k)) = -500;
  image->Modified();
  scene.Raycaster->MarkModified(box);
  scene.Draw();
  EXPECT_EQ(scene.Judge(scene.Truth()).invented, 0);
  ExpectExact(scene.JudgeConverged(), 500);
}

TEST_F(RayCaching, PicksTheExactPoint)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(40, { 0.6, 0.9, 1.7 }));
  scene.Draw();
  const auto truth = scene.Truth();
  vtkNew<vtkHaspPickedCell> picked;
  int met = 0;
  for (int pixel = 0; pixel < int(truth.size()); pixel += 7)
  {
    const auto [origin, direction] =
      scene.Ray(pixel % RaycastScene::PixelsX, pixel / RaycastScene::PixelsX);
    const glm::dvec3 to = origin + 300.0 * direction;
    const bool hit = scene.Raycaster->PickFirstCell(&origin.x, &to.x, picked);
    ASSERT_EQ(hit, truth[pixel].has_value());
    if (!hit)
      continue;
    ++met;
    const glm::dvec3 position = glm::make_vec3(picked->GetPosition());
    EXPECT_LT(glm::length(position - truth[pixel]->position), 1e-4);
    EXPECT_LT(glm::length(position - (origin + picked->GetT() * (to - origin))), 1e-4);
    EXPECT_EQ(picked->GetValue(), 0.0);
  }
  EXPECT_GT(met, 500);
}

TEST_F(RayCaching, HonoursClippingPlanes)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(50, { 1, 1, 1 }));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, -5, 0);
  plane->SetNormal(0, 1, 0.1);
  scene.Raycaster->AddClippingPlane(plane);
  scene.Converge();
  const auto truth = scene.Truth(
    [](const glm::dvec3& origin, const glm::dvec3& direction)
    {
      const glm::dvec3 normal(0, 1, 0.1);
      const double at = glm::dot(normal, origin - glm::dvec3(0, -5, 0));
      return std::max(0.0, -at / glm::dot(normal, direction));
    });
  ExpectExact(scene.Judge(truth), 500);
}

TEST_F(RayCaching, StaysExactWhereTheEyeIs)
{
  const auto shape = hasp::AnalyticGyroid(20);
  for (const auto& [eye, at, nearest, farthest] :
    { std::tuple{ glm::dvec3(3, 2, 1), glm::dvec3(0, 20, 0), 0.01, 60.0 },       // inside
      std::tuple{ glm::dvec3(0, -10, 0), glm::dvec3(0, 20, 1), 0.1, 60.0 },      // on the surface
      std::tuple{ glm::dvec3(0, -30, 0), glm::dvec3(0, 0, 1), 25.0, 100.0 },     // near plane cuts
      std::tuple{ glm::dvec3(0, -1e4, 0), glm::dvec3(0), 1e4 - 40, 1e4 + 40 } }) // far away
  {
    CacheScene scene;
    scene.Show<std::int16_t>(shape, ObliqueGrid(40, { 1, 1, 1 }));
    scene.Look(eye, at, nearest, farthest);
    if (eye.y < -1000)
      scene.Renderer->GetActiveCamera()->SetViewAngle(0.25);
    const Judgement judged = scene.JudgeConverged();
    EXPECT_GT(judged.surface, 1000) << eye.y;
    EXPECT_LE(judged.missed + judged.invented, 2 + judged.surface / 500) << eye.y;
  }
}

TEST_F(RayCaching, TakesVolumesThatAreHard)
{
  CacheScene scene;
  const auto complete = [&](int mostMissed)
  {
    const Judgement judged = scene.JudgeConverged();
    EXPECT_GT(judged.surface, 200);
    EXPECT_LE(judged.missed, mostMissed);
  };
  // A plate of one voxel.
  const hasp::GridGeometry plate{ { 50, 3, 50 }, { -25, -1, -25 }, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(plate.Size(), -100);
  for (int k = 1; k < 49; ++k)
    for (int i = 1; i < 49; ++i)
      samples[std::size_t(k * 3 + 1) * 50 + i] = 100;
  scene.Raycaster->SetInputData(hasp::MakeImage(plate, samples));
  complete(5);
  // Spacing of 100 to 1.
  const hasp::GridGeometry flat{ { 60, 60, 5 }, { -15, -15, -100 }, { 0.5, 0.5, 50 },
    glm::dmat3(1) };
  scene.Raycaster->SetInputData(hasp::MakeImage(
    flat, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 12), flat, 100, 0)));
  complete(5);
  // Noise: every cell is active.
  const hasp::GridGeometry cube{ { 32, 32, 32 }, { -16, -16, -16 }, { 1, 1, 1 }, glm::dmat3(1) };
  samples.resize(cube.Size());
  std::mt19937 random(2);
  for (std::int16_t& sample : samples)
    sample = static_cast<std::int16_t>(int(random() % 2001) - 1000);
  scene.Raycaster->SetInputData(hasp::MakeImage(cube, samples));
  complete(10);
}

TEST_F(RayCaching, TakesWindowsOfAnySize)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(40, { 1, 1, 1 }));
  for (int frame = 0; frame < 30; ++frame)
  {
    scene.Window->SetSize(40 + 7 * frame, 200 - 5 * frame);
    scene.Draw();
  }
  EXPECT_TRUE(scene.Shows(120, 25));
  for (const auto& [width, height] : { std::pair(1, 1), std::pair(4096, 64), std::pair(64, 512) })
  {
    scene.Window->SetSize(width, height);
    for (int frame = 0; frame < 5; ++frame)
      scene.Draw();
    EXPECT_TRUE(scene.Point(width / 2, height / 2).has_value()) << width;
  }
  EXPECT_TRUE(scene.Errors.empty());
}

/// VTK's windows have several samples a pixel unless told otherwise: rays look for holes there,
/// too.
TEST_F(RayCaching, FindsHolesInMultisampledPictures)
{
  std::vector<int> clusters;
  for (const int samples : { 0, 4 })
  {
    CacheScene scene;
    scene.Window->SetMultiSamples(samples);
    scene.Raycaster->SetRaysPerTile(2);
    scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(60, { 1, 1, 1 }));
    for (int frame = 0; frame < 8; ++frame)
      scene.Window->Render();
    clusters.push_back(scene.Count("ray cache"));
    EXPECT_EQ(Find(scene.Raycaster, "depth of the last pictures").bytes, 160U * 120 * 4);
    EXPECT_TRUE(scene.Errors.empty()) << scene.Errors.front();
  }
  EXPECT_NEAR(clusters[1], clusters[0], 0.02 * clusters[0]); // the eye sees through other samples
}

/// The rays of the last frame follow the budget; the picture comes anyway.
TEST_F(RayCaching, KeepsABudget)
{
  constexpr int tiles = 10 * 8; // of 160 x 120 pixels
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(40, { 1, 1, 1 }));
  scene.Raycaster->SetRaysPerTile(3);
  scene.Raycaster->PredictionOff();
  scene.Draw();
  EXPECT_EQ(scene.Count("cached cells, host"), 3 * tiles);
  scene.Raycaster->SetFrameBudget(1e-3); // less than drawing takes
  scene.Draw();
  scene.Draw();
  EXPECT_EQ(scene.Count("cached cells, host"), tiles);
  scene.Raycaster->SetFrameBudget(1e6);
  scene.Draw();
  EXPECT_EQ(scene.Count("cached cells, host"), 256 * tiles);
}

/// One cache for both: the second eye finds little that the first has not.
TEST_F(RayCaching, SharesItsCacheBetweenTheEyes)
{
  int clusters[2];
  for (const int eyes : { 1, 2 })
  {
    CacheScene scene;
    scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(60, { 1, 1, 1 }));
    if (eyes == 2)
    {
      scene.Window->SetStereoTypeToLeft(); // one eye to look at, then the other
      scene.Window->StereoRenderOn();
      scene.Converge();
      scene.Window->SetStereoTypeToRight();
    }
    scene.Converge();
    clusters[eyes - 1] = scene.Count("ray cache");
    EXPECT_TRUE(scene.Errors.empty());
  }
  EXPECT_GT(clusters[0], 50);
  EXPECT_LT(clusters[1], 1.3 * clusters[0]);
}

/// A camera that goes on as it went finds fewer holes where rays went ahead.
TEST_F(RayCaching, PredictsWhereTheCameraGoes)
{
  int missed[2] = { 0, 0 };
  for (const bool prediction : { false, true })
  {
    CacheScene scene;
    scene.Show<std::int16_t>(hasp::AnalyticGyroid(20), ObliqueGrid(70, { 1, 1, 1 }));
    scene.Raycaster->SetRaysPerTile(2);
    scene.Raycaster->SetPrediction(prediction);
    scene.Converge();
    for (int frame = 0; frame < 9; ++frame)
    {
      scene.Renderer->GetActiveCamera()->Azimuth(4);
      scene.Draw();
      if (frame % 4 == 0) // judging takes longer than drawing
        missed[prediction] += scene.Judge(scene.Truth()).missed;
    }
  }
  EXPECT_GT(missed[0], 0);
  EXPECT_LT(missed[1], missed[0]);
}

TEST_F(RayCaching, IsDrawnTranslucent)
{
  CacheScene scene;
  scene.Show<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(40, { 1, 1, 1 }));
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->SetBackground(0, 0, 1);
  int warnings = 0;
  vtkNew<vtkCallbackCommand> hear;
  hear->SetClientData(&warnings);
  hear->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  scene.Raycaster->AddObserver(vtkCommand::WarningEvent, hear);
  const std::size_t middle = 3 * (RaycastScene::PixelsX * (RaycastScene::PixelsY / 2) + 80);
  std::vector<unsigned char> colors;
  for (int frame = 0; frame < 20; ++frame)
    colors = scene.Colors();
  EXPECT_GT(colors[middle], 30);      // of the surface
  EXPECT_GT(colors[middle + 2], 100); // of what is behind it
  EXPECT_TRUE(scene.Errors.empty());
  EXPECT_EQ(warnings, 1) << "that layers may be missing";
}

} // namespace
