#include "vtkHaspDistanceColours.h"

#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <stdexcept>
#include <string>

namespace hasp
{

vtkSmartPointer<vtkDiscretizableColorTransferFunction> MakeDistanceColours(
  const DistanceColourSettings& settings)
{
  if (!(settings.rangeMm >= 0.01 && settings.rangeMm <= 1000.0))
    throw std::invalid_argument("distance colours: rangeMm is " + std::to_string(settings.rangeMm) +
                                ", must be in [0.01, 1000]");
  if (settings.steps != 0 &&
      (settings.steps < 3 || settings.steps > 255 || settings.steps % 2 == 0))
    throw std::invalid_argument("distance colours: steps is " + std::to_string(settings.steps) +
                                ", must be 0, or odd in [3, 255], so that one is around 0");
  auto colours = vtkSmartPointer<vtkDiscretizableColorTransferFunction>::New();
  colours->SetColorSpaceToDiverging();
  colours->AddRGBPoint(-settings.rangeMm, 59 / 255.0, 76 / 255.0, 192 / 255.0);
  colours->AddRGBPoint(settings.rangeMm, 180 / 255.0, 4 / 255.0, 38 / 255.0);
  colours->SetNanColor(0.6, 0.5, 0.0);
  colours->SetDiscretize(settings.steps != 0);
  if (settings.steps != 0)
    colours->SetNumberOfValues(settings.steps);
  colours->Build();
  return colours;
}

vtkSmartPointer<vtkScalarBarActor> MakeDistanceScale(vtkDiscretizableColorTransferFunction* colours)
{
  auto scale = vtkSmartPointer<vtkScalarBarActor>::New();
  scale->SetLookupTable(colours);
  scale->SetTitle("mm");
  scale->SetNumberOfLabels(5); // the ends, 0, and between
  scale->SetLabelFormat("%+.2f");
  scale->SetOrientationToVertical();
  scale->SetPosition(0.86, 0.1);
  scale->SetWidth(0.12);
  scale->SetHeight(0.8);
  scale->SetMaximumNumberOfColors(255); // odd: one is around 0
  for (vtkTextProperty* text : { scale->GetLabelTextProperty(), scale->GetTitleTextProperty() })
  {
    text->ItalicOff();
    text->ShadowOff();
    text->SetColor(1.0, 1.0, 1.0);
  }
  return scale;
}

} // namespace hasp
