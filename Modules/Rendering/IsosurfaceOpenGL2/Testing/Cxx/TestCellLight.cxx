// Ambient occlusion and shadows of the traced renderer: right, off where they are off, and said
// where they cannot be drawn.
#include "CellTestScene.h"
#include "ErrorCounter.h"
#include "Isosurface/CellTracer.h"
#include "Isosurface/ClusteredCells.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkLight.h"
#include "vtkPointData.h"
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
using hasp::testing::ErrorCounter;
constexpr int PixelsX = 131, PixelsY = 97; // odd: rows of two bytes a pixel are no whole words

class CellLight : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// White and matt in the light of one lamp, so that a pixel's grey is what light reaches it.
template <typename Mapper>
void Paint(CellTestScene& scene, Mapper* mapper)
{
  scene.Actor->SetMapper(mapper);
  scene.Actor->GetProperty()->SetColor(1, 1, 1);
  scene.Look({ 60, -80, 50 }, { 0, 0, 0 }, 20, 250);
}

vtkSmartPointer<vtkImageData> Gyroid()
{
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(44, { 1, 0.9, 1.3 });
  return hasp::MakeImage(
    g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), g, 100, 0));
}

struct LightScene : CellTestScene
{
  vtkNew<vtkLight> Lamp;

  LightScene() : CellTestScene(PixelsX, PixelsY)
  {
    this->Mapper->SetInputData(Gyroid());
    this->Mapper->SetRendererToTrace();
    Paint(*this, this->Mapper.Get());
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetPosition(70, -60, 90);
    this->Lamp->SetFocalPoint(0, 0, 0);
    this->Renderer->AddLight(this->Lamp);
  }

  std::vector<unsigned char> Colors(int frames = 1)
  {
    for (int frame = 0; frame < frames; ++frame)
      this->Draw();
    vtkNew<vtkUnsignedCharArray> rgb;
    this->Window->GetPixelData(0, 0, PixelsX - 1, PixelsY - 1, 0, rgb);
    return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
  }

  hasp::ResourceUse Find(const std::string& name)
  {
    hasp::ResourceList list;
    this->Mapper->ListResources(list);
    for (const auto& use : list)
      if (use.resource == name)
        return use;
    ADD_FAILURE() << "no resource " << name;
    return {};
  }

  /// body(pixel, hit) where something is seen.
  template <typename Body>
  void EachHit(const hasp::CellTracer& tracer, const Body& body)
  {
    const hasp::GridGeometry& g = tracer.Cells().geometry;
    for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
    {
      const auto [from, way] = this->Ray(pixel % PixelsX, pixel / PixelsX);
      const glm::dvec3 origin = g.WorldToIndex(from);
      if (const auto hit = tracer.Trace({ origin, g.WorldToIndex(from + way) - origin }))
        body(pixel, *hit);
    }
  }
  std::shared_ptr<hasp::CellTracer> MakeTracer()
  {
    return std::make_shared<hasp::CellTracer>(
      std::make_shared<hasp::ClusteredCells>(this->Mapper->GetCells()));
  }
};

#if HASP_WITH_EMBREE

TEST_F(CellLight, OffIsThePictureOfBeforeAndCostsNothing)
{
  LightScene scene;
  const auto before = scene.Colors();
  EXPECT_EQ(scene.Find("light cache").bytes, 0);
  EXPECT_EQ(scene.Find("light of pixels").bytes, 0);
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->ShadowsOn();
  EXPECT_NE(scene.Colors(), before);
  EXPECT_GT(scene.Find("light cache").bytes, 1'000'000);
  EXPECT_GT(scene.Find("light of pixels").bytes, 1000);
  scene.Mapper->AmbientOcclusionOff();
  scene.Colors();
  EXPECT_EQ(scene.Find("light cache").bytes, 0) << "shadows keep nothing";
  EXPECT_GT(scene.Find("light of pixels").bytes, 1000);
  scene.Mapper->ShadowsOff();
  EXPECT_EQ(scene.Colors(), before);
  EXPECT_EQ(scene.Find("light of pixels").bytes, 0);
}

TEST_F(CellLight, AmbientOcclusionMultipliesTheColours)
{
  LightScene scene;
  const auto plain = scene.Colors();
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetAmbientOcclusionDistance(6);
  const auto lit = scene.Colors(32);
  const auto tracer = scene.MakeTracer();
  double sum = 0, count = 0;
  scene.EachHit(*tracer,
    [&](int pixel, const hasp::CellHit& hit)
    {
      if (plain[3 * pixel] < 100 || pixel % 3)
        return;
      const double open = double(lit[3 * pixel]) / plain[3 * pixel];
      sum += std::pow(open - tracer->AmbientOcclusion(hit, { 256, 6.0 }, 1), 2);
      ++count;
    });
  EXPECT_GT(count, 200);
  // A gyroid in some 70 pixels: a pixel is 1.1 mm, so that the light is blurred over a tenth of its
  // period. Without light it would be some 0.3.
  EXPECT_LT(std::sqrt(sum / count), 0.06);
}

TEST_F(CellLight, ShadowsAreThoseOfTheFirstLightThatIsOn)
{
  LightScene scene;
  for (const bool positional : { false, true })
  {
    vtkNew<vtkLight> off; // the one before it does not count
    off->SwitchOff();
    scene.Renderer->RemoveAllLights();
    scene.Renderer->AddLight(off);
    scene.Renderer->AddLight(scene.Lamp);
    scene.Lamp->SetPositional(positional);
    scene.Lamp->SetConeAngle(90);
    scene.Mapper->ShadowsOff();
    const auto plain = scene.Colors();
    scene.Mapper->ShadowsOn();
    const auto lit = scene.Colors();
    const auto tracer = scene.MakeTracer();
    const hasp::GridGeometry& g = tracer->Cells().geometry;
    int shaded = 0, bright = 0, wrong = 0;
    scene.EachHit(*tracer,
      [&](int pixel, const hasp::CellHit& hit)
      {
        if (plain[3 * pixel] < 10)
          return;
        const glm::dvec3 lamp(70, -60, 90);
        const glm::dvec3 way = positional ? lamp - g.IndexToWorld(hit.Position()) : lamp;
        const bool shade =
          tracer->Light(hit,
            { way, 0.0, 1,
              positional ? glm::length(way) : std::numeric_limits<double>::infinity() }) == 0.0F;
        ++(shade ? shaded : bright);
        wrong += lit[3 * pixel] != (shade ? 0 : plain[3 * pixel]);
      });
    EXPECT_GT(shaded, 100) << positional;
    EXPECT_GT(bright, 300) << positional;
    // At a silhouette, or at a shadow's edge, the ray's last digit decides.
    EXPECT_LE(wrong, (shaded + bright) / 200) << positional;
  }
}

TEST_F(CellLight, TakesTracedRaysUnlessThatIsRefused)
{
  LightScene scene;
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetRendererToAutomatic();
  const auto lit = scene.Colors();
  EXPECT_EQ(scene.Mapper->GetRendererChoice(), "traced: ambient occlusion and shadows take rays");
  scene.Mapper->SetRendererToRasterize();
  vtkNew<ErrorCounter> errors;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  const auto without = scene.Colors(3);
  EXPECT_EQ(errors->Count, 1) << "said once";
  EXPECT_EQ(scene.Find("light cache").bytes, 0);
  scene.Mapper->AmbientOcclusionOff();
  EXPECT_EQ(scene.Colors(), without);
  EXPECT_EQ(errors->Count, 1);
  scene.Mapper->SetRendererToTrace();
  scene.Mapper->AmbientOcclusionOn();
  EXPECT_NE(scene.Colors(), without);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Colors(2);
  EXPECT_EQ(errors->Count, 2);
  for (const double bad : { 0.0, -1.0, double(NAN) })
    scene.Mapper->SetAmbientOcclusionDistance(bad);
  EXPECT_EQ(errors->Count, 5);
  EXPECT_EQ(scene.Mapper->GetAmbientOcclusionDistance(), 25.0);
}

TEST_F(CellLight, FollowsEditsAndIsovalues)
{
  // A pillar grows out of a floor that was open.
  const hasp::GridGeometry g{ { 60, 60, 30 }, { -29.5, -29.5, -15 }, { 1, 1, 1 }, glm::dmat3(1) };
  std::vector<std::int16_t> samples(g.Size());
  for (int k = 0; k < 30; ++k)
    for (int n = 0; n < 3600; ++n)
      samples[k * 3600 + n] = static_cast<std::int16_t>(100 * (10 - k) + 30);
  LightScene scene;
  const auto image = hasp::MakeImage(g, samples);
  scene.Mapper->SetInputData(image);
  scene.Mapper->SetIsoValue(0);
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->SetAmbientOcclusionDistance(6);
  scene.Mapper->ShadowsOn();
  const auto open = scene.Colors(8);
  auto* values = static_cast<std::int16_t*>(image->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (int k = 10; k < 24; ++k)
    for (int j = 25; j < 35; ++j)
      for (int i = 25; i < 35; ++i)
        values[k * 3600 + j * 60 + i] = 100;
  const int box[6] = { 25, 34, 25, 34, 10, 23 };
  scene.Mapper->MarkModified(box);
  const auto edited = scene.Colors(8);
  EXPECT_NE(edited, open);
  LightScene other;
  image->Modified();
  other.Mapper->SetInputData(image);
  other.Mapper->SetIsoValue(0);
  other.Mapper->AmbientOcclusionOn();
  other.Mapper->SetAmbientOcclusionDistance(6);
  other.Mapper->ShadowsOn();
  const auto fresh = other.Colors(8);
  double sum = 0;
  for (std::size_t n = 0; n < fresh.size(); ++n)
    sum += std::pow((fresh[n] - edited[n]) / 255.0, 2);
  EXPECT_LT(std::sqrt(sum / double(fresh.size())), 0.02) << "two pictures' noise";
}

TEST_F(CellLight, OfTheRayCachingMapperIsThatOfAllActiveCells)
{
  LightScene scene;
  scene.Mapper->AmbientOcclusionOn();
  scene.Mapper->ShadowsOn();
  const auto expected = scene.Colors(3);
  vtkNew<vtkHaspRayCachingMapper> caching;
  const auto image = Gyroid();
  caching->SetInputData(image);
  caching->SetIsoValue(0);
  caching->AmbientOcclusionOn();
  caching->ShadowsOn();
  Paint(scene, caching.GetPointer());
  EXPECT_EQ(scene.Colors(3), expected);
  EXPECT_EQ(caching->GetModeChoice().find("all active cells: "), 0) << caching->GetModeChoice();
  // Edits reach it. Without ambient occlusion, so that there is no noise.
  caching->AmbientOcclusionOff();
  scene.Colors();
  auto* values = static_cast<std::int16_t*>(image->GetPointData()->GetScalars()->GetVoidPointer(0));
  const int* dims = image->GetDimensions();
  for (int k = 10; k < 34; ++k)
    for (int j = 10; j < 30; ++j)
      std::fill_n(values + (k * dims[1] + j) * dims[0] + 10, 24, std::int16_t(-100));
  const int box[6] = { 10, 33, 10, 29, 10, 33 };
  caching->MarkModified(box);
  const auto edited = scene.Colors();
  scene.Mapper->SetInputData(image);
  image->Modified();
  scene.Mapper->AmbientOcclusionOff();
  Paint(scene, scene.Mapper.Get());
  EXPECT_EQ(edited, scene.Colors());
  Paint(scene, caching.GetPointer());

  caching->SetModeToCache();
  vtkNew<ErrorCounter> errors;
  caching->AddObserver(vtkCommand::ErrorEvent, errors);
  scene.Colors(3);
  EXPECT_EQ(errors->Count, 1);
}

#endif

} // namespace
