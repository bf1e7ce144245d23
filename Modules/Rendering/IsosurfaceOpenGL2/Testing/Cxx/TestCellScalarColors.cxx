// Left: another array, interpolated and then mapped in eight steps. Middle: the same, mapped at the
// corners by a smooth table. Right: the density itself, one colour.
#include "PictureScene.h"

#include "vtkLookupTable.h"

int TestCellScalarColors(int argc, char* argv[])
{
  hasp::testing::PictureScene scene;
  const auto g = hasp::testing::CenteredGrid({ 44, 44, 44 });
  const auto image =
    hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(
                         hasp::AnalyticTorus({ 0, 0, 0 }, { 0, 0.8, 0.6 }, 13, 6), g, 100, 0));
  hasp::testing::AddPointArray<vtkFloatArray>(
    image, "distance", [](const glm::dvec3& p) { return glm::length(p - glm::dvec3(8, -10, 9)); });
  for (int n = 0; n < 3; ++n)
  {
    const auto mapper = scene.Add(image, 0, { 41.0 * (n - 1), 0, 0 });
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(n == 0 ? 8 : 256);
    table->SetHueRange(0, 0.7);
    table->Build();
    mapper->ScalarVisibilityOn();
    mapper->SetLookupTable(table);
    if (n == 2)
    {
      mapper->SetScalarRange(-200, 100);
      continue;
    }
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray("distance");
    mapper->SetScalarRange(0, 36);
    mapper->SetInterpolateScalarsBeforeMapping(n == 0);
  }
  scene.Look({ 0, -250, 90 }, { 0, 0, 0 });
  scene.Renderer->GetActiveCamera()->Zoom(1.5);
  scene.Window->Render();
  return hasp::CheckPicture(scene.Window, argc, argv);
}
