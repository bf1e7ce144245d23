#include "VolumeIsosurface.h"

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace hasp
{

vtkSmartPointer<vtkVolume> MakeVolumeIsosurface(
  vtkImageData* image, double isovalue, double stepVoxels)
{
  const double* spacing = image->GetSpacing();
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetBlendModeToIsoSurface();
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetUseJittering(false);
  mapper->SetSampleDistance(
    static_cast<float>(stepVoxels * *std::min_element(spacing, spacing + 3)));
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  const double* range = image->GetScalarRange();
  color->AddRGBPoint(range[0], 1, 1, 1);
  color->AddRGBPoint(range[1], 1, 1, 1);
  opacity->AddPoint(range[0], 1);
  opacity->AddPoint(range[1], 1);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->ShadeOn();
  property->SetInterpolationTypeToLinear();
  property->GetIsoSurfaceValues()->SetValue(0, isovalue);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return volume.Get();
}

} // namespace hasp
