#include "LabelImage.h"

#include "Segmentation/LabelMap.h"
#include "vtkHaspVolumeView.h"

#include "Grid/LabelGrid.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace hasp
{

vtkSmartPointer<vtkImageData> MakeLabelImage(vtkImageData* scan, vtkImageData* given)
{
  vtkNew<vtkUnsignedShortArray> labels;
  labels->SetName("Labels");
  labels->SetNumberOfValues(scan->GetNumberOfPoints());
  Label* values = labels->GetPointer(0);
  if (given)
  {
    CheckLabelGrid("labels", ImageGeometry(scan), ImageGeometry(given));
    const auto copy = [&]<typename T>(const GridView<const T>& from)
    {
      if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, Label>)
        std::copy_n(from.data, from.geometry.Size(), values);
      else
        throw std::invalid_argument("labels: must be unsigned char or unsigned short");
    };
    std::visit(copy, ViewImage(given));
  }
  else
    std::fill_n(values, scan->GetNumberOfPoints(), Label(0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(scan);
  image->GetPointData()->SetScalars(labels);
  return image;
}

bool HaveSameSamples(vtkImageData* a, vtkImageData* b)
{
  return std::visit(
    [](const auto& first, const auto& second)
    {
      return std::equal(first.data, first.data + first.geometry.Size(), second.data,
        [](float one, float other) { return one == other; }); // holds all of their types
    },
    ViewImage(a), ViewImage(b));
}

} // namespace hasp
