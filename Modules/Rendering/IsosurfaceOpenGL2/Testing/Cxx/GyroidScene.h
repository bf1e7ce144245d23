#pragma once
// A gyroid in a small window.
#include "CellTestScene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"

#include <gtest/gtest.h>

#include <vector>

namespace hasp::testing
{

inline constexpr int PixelsX = 150, PixelsY = 120;

inline vtkSmartPointer<vtkImageData> Gyroid()
{
  const GridGeometry g = ObliqueGrid(50, { 1, 0.9, 1.3 });
  return MakeImage(g, SampleAnalytic<std::int16_t>(AnalyticGyroid(20), g, 100, 0));
}

struct GyroidScene : CellTestScene
{
  GyroidScene() : CellTestScene(PixelsX, PixelsY)
  {
    this->Mapper->SetInputData(Gyroid());
    this->Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 200);
  }

  /// Cell ids of all pixels, -1 where nothing is.
  std::vector<vtkIdType> CellIds()
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, PixelsX - 1, PixelsY - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    EXPECT_TRUE(selector->CaptureBuffers());
    std::vector<vtkIdType> ids;
    for (unsigned y = 0; y < PixelsY; ++y)
      for (unsigned x = 0; x < PixelsX; ++x)
      {
        const unsigned pixel[2] = { x, y };
        const auto picked = selector->GetPixelInformation(pixel);
        ids.push_back(picked.Valid ? picked.AttributeID : -1);
      }
    return ids;
  }
};

} // namespace hasp::testing
