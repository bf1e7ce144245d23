// A translucent isosurface blends as VTK's own mesh of the same surface does, layer by layer.
#include "CellTestScene.h"

#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

using hasp::testing::CellTestScene;

vtkSmartPointer<vtkUnsignedCharArray> Pixels(CellTestScene& scene)
{
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  scene.Window->Render();
  scene.Window->GetPixelData(0, 0, 199, 199, 0, pixels);
  return pixels;
}

/// Mean difference of the two pictures, in grey levels, over the pixels that show either surface.
double Difference(bool depthPeeling)
{
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(60, { 1, 0.9, 1.1 });
  const auto image =
    hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(
                         hasp::AnalyticTorus({ 0, 0, 0 }, { 0, 0.6, 0.8 }, 18, 7), g, 100, 0));
  CellTestScene scene(200, 200);
  scene.Mapper->SetInputData(image);
  scene.Actor->GetProperty()->SetColor(1, 0.5, 0.2);
  scene.Actor->GetProperty()->SetOpacity(0.4);
  scene.Look({ 60, -80, 40 }, { 0, 0, 0 }, 30, 200);
  scene.Renderer->SetUseDepthPeeling(depthPeeling);
  scene.Renderer->SetMaximumNumberOfPeels(20);
  scene.Renderer->SetOcclusionRatio(0.0);
  const auto ours = Pixels(scene);

  scene.ShowMesh();
  const auto theirs = Pixels(scene);

  double sum = 0.0;
  int shown = 0;
  for (vtkIdType n = 0; n < ours->GetNumberOfValues(); ++n)
    if (ours->GetValue(n) != 0 || theirs->GetValue(n) != 0)
    {
      sum += std::abs(ours->GetValue(n) - theirs->GetValue(n));
      ++shown;
    }
  EXPECT_GT(shown, 20000);
  return sum / shown;
}

class CellTranslucency : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

// Normals of the mesh are averaged per point and ours are the polynomial's: some grey levels apart.
// One layer too few or too many of the four is 40% of the light behind it: some 30 grey levels.
TEST_F(CellTranslucency, OrderIndependent)
{
  EXPECT_LT(Difference(false), 6.0);
}

TEST_F(CellTranslucency, DepthPeeling)
{
  EXPECT_LT(Difference(true), 6.0);
}

} // namespace
