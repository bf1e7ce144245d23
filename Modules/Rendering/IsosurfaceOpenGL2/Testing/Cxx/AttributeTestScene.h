#pragma once
// A ball of two labels, split at x = 0, with two more arrays to colour by.
#include "CellTestScene.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <array>

namespace hasp::testing
{

/// 41^3 samples, 1 mm; 100 times the signed distance to a ball of radius 15 around the origin,
/// positive inside. Point arrays: "label" is 1 for x < 0 and 2 for x >= 0, "height" is z in mm,
/// "rgb".
inline vtkSmartPointer<vtkImageData> TwoHalves()
{
  GridGeometry g{ { 41, 41, 41 }, glm::dvec3(-20), { 1, 1, 1 }, glm::dmat3(1) };
  auto image =
    MakeImage(g, SampleAnalytic<std::int16_t>(AnalyticSphere({ 0, 0, 0 }, 15), g, 100, 0));
  vtkNew<vtkUnsignedShortArray> label;
  vtkNew<vtkFloatArray> height;
  vtkNew<vtkUnsignedCharArray> rgb;
  label->SetName("label");
  height->SetName("height");
  rgb->SetName("rgb");
  rgb->SetNumberOfComponents(3);
  for (int k = 0; k < 41; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i)
      {
        label->InsertNextValue(i < 20 ? 1 : 2);
        height->InsertNextValue(static_cast<float>(k - 20));
        const double color[3] = { 6.0 * i, 6.0 * j, 6.0 * k };
        rgb->InsertNextTuple(color);
      }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(label),
         static_cast<vtkDataArray*>(height), static_cast<vtkDataArray*>(rgb) })
    image->GetPointData()->AddArray(array);
  return image;
}

struct AttributeScene : CellTestScene
{
  AttributeScene() : CellTestScene(120, 100)
  {
    this->Mapper->SetInputData(TwoHalves());
    this->Look({ 0, -100, 0 }, { 0, 0, 0 }, 40, 200);
    this->Renderer->SetBackground(0, 0, 0);
    this->Actor->GetProperty()->LightingOff(); // colours come out as they are
    this->Actor->GetProperty()->SetAmbient(0);
  }

  /// Draws, then the colour of the pixel that shows a world point.
  std::array<int, 3> ColorAt(const glm::dvec3& world)
  {
    this->Draw();
    this->Renderer->SetWorldPoint(world.x, world.y, world.z, 1);
    this->Renderer->WorldToDisplay();
    const double* at = this->Renderer->GetDisplayPoint();
    vtkNew<vtkUnsignedCharArray> pixel;
    const int x = static_cast<int>(at[0]), y = static_cast<int>(at[1]);
    this->Window->GetPixelData(x, y, x, y, 1, pixel);
    return { pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2) };
  }

  /// How many pixels show a surface.
  int Covered()
  {
    this->Draw();
    int count = 0;
    for (int y = 0; y < 100; ++y)
      for (int x = 0; x < 120; ++x)
        count += this->Point(x, y).has_value();
    return count;
  }
};

inline std::size_t BytesOf(const CellTestScene& scene, const std::string& resource)
{
  return FindResource(scene.Mapper, resource).bytes;
}

} // namespace hasp::testing
