// Light falls on an isosurface as on VTK's own mesh of it, whatever the lights and the actor's
// matrix.
#include "CellTestScene.h"

#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

namespace
{

using hasp::testing::CellTestScene;

class CellLighting : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  /// Draws a torus with our mapper and with a mesh. The mean difference, in grey levels, over the
  /// pixels that show both; silhouettes, where one has a pixel more, must be few.
  /// `meshOnly`: what is to change before the mesh is drawn.
  static double Difference(
    const std::function<void(CellTestScene&)>& change,
    const std::function<void(CellTestScene&)>& meshOnly = [](CellTestScene&) {})
  {
    const hasp::GridGeometry g = hasp::testing::ObliqueGrid(60, { 1, 0.9, 1.1 });
    static const auto image =
      hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(
                           hasp::AnalyticTorus({ 0, 0, 0 }, { 0, 0.6, 0.8 }, 18, 7), g, 100, 0));
    CellTestScene scene(150, 150);
    scene.Mapper->SetInputData(image);
    scene.Actor->GetProperty()->SetColor(1, 0.5, 0.2);
    scene.Renderer->SetBackground(0, 0, 1);
    scene.Look({ 60, -80, 40 }, { 0, 0, 0 }, 30, 200);
    change(scene);
    const auto ours = Pixels(scene);

    scene.ShowMesh();
    meshOnly(scene);
    const auto theirs = Pixels(scene);

    double sum = 0.0;
    int both = 0, one = 0;
    const auto blue = [](vtkUnsignedCharArray* rgb, vtkIdType n)
    { return rgb->GetValue(3 * n) == 0 && rgb->GetValue(3 * n + 2) == 255; };
    for (vtkIdType n = 0; n < 150 * 150; ++n)
    {
      const bool a = blue(ours, n), b = blue(theirs, n);
      one += a != b;
      if (a || b)
        continue;
      ++both;
      for (int c = 0; c < 3; ++c)
        sum += std::abs(ours->GetValue(3 * n + c) - theirs->GetValue(3 * n + c));
    }
    EXPECT_GT(both, 500);
    EXPECT_LT(one, both / 20);
    return sum / (3.0 * both);
  }

private:
  static vtkSmartPointer<vtkUnsignedCharArray> Pixels(CellTestScene& scene)
  {
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    scene.Window->Render();
    scene.Window->GetPixelData(0, 0, 149, 149, 0, pixels);
    return pixels;
  }
};

/// The mesh's normals are interpolated and the surfaces a tenth of a voxel apart: about one grey
/// level. A light in a wrong place is worth ten and more.
constexpr double Tolerance = 2.0;

vtkLight* AddLight(CellTestScene& scene, const glm::dvec3& from, const glm::dvec3& to, double cone)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(to.x, to.y, to.z);
  light->SetPositional(cone > 0);
  light->SetConeAngle(cone);
  light->SetColor(0.9, 1, 0.8);
  scene.Renderer->AddLight(light);
  return light;
}

TEST_F(CellLighting, Headlight)
{
  EXPECT_LT(Difference([](CellTestScene&) {}), Tolerance);
}

TEST_F(CellLighting, AllLightsOffOrNoneAtAll)
{
  const auto off = [](CellTestScene& s) {
    AddLight(s, { 60, -80, 40 }, { 0, 0, 0 }, 0)->SwitchOff();
  }; // VTK makes another
  EXPECT_LT(Difference(off), Tolerance);
  EXPECT_LT(
    Difference([](CellTestScene& s) { s.Renderer->AutomaticLightCreationOff(); }), Tolerance);
}

TEST_F(CellLighting, UnlitWithAmbientAndDiffuse)
{
  EXPECT_LT(Difference(
              [](CellTestScene& s)
              {
                s.Actor->GetProperty()->LightingOff();
                s.Actor->GetProperty()->SetAmbient(0.2);
                s.Actor->GetProperty()->SetDiffuse(0.5);
              }),
    Tolerance);
}

TEST_F(CellLighting, ManyLightsPositionalAndSpot)
{
  EXPECT_LT(Difference(
              [](CellTestScene& s)
              {
                for (int n = 0; n < 12; ++n)
                  AddLight(s, { 50 * std::cos(n), -60, 50 * std::sin(n) }, { 0, 0, 0 },
                    n % 3 == 0   ? 0.0
                    : n % 3 == 1 ? 25.0
                                 : 100.0)
                    ->SetIntensity(0.15);
                s.Actor->GetProperty()->SetSpecular(0.4);
                s.Actor->GetProperty()->SetSpecularPower(12);
              }),
    Tolerance);
}

TEST_F(CellLighting, ALightAtItsOwnFocalPoint)
{
  EXPECT_LT(Difference(
              [](CellTestScene& s)
              {
                AddLight(s, { 60, -80, 40 }, { 0, 0, 0 }, 0)->SetIntensity(0.5);
                AddLight(s, { 30, -80, 60 }, { 30, -80, 60 }, 100)->SetIntensity(0.5);
              }),
    Tolerance);
}

TEST_F(CellLighting, MirroredAndStretchedActors)
{
  const auto stretch = [](double x)
  {
    return [x](CellTestScene& s)
    {
      s.Actor->SetScale(x, 1.1, 0.7);
      s.Actor->RotateX(25);
    };
  };
  EXPECT_LT(Difference(stretch(1.2)), Tolerance);
  // The torus is its own mirror image. VTK lights the inside of a mirrored mesh: no truth.
  EXPECT_LT(Difference(stretch(-1.2), [](CellTestScene& s) { s.Actor->SetScale(1.2, 1.1, 0.7); }),
    Tolerance);
}

} // namespace
