#include "ImageOutput.h"

#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <stdexcept>

namespace hasp
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

GridGeometry PipelineGeometry(vtkInformation* image)
{
  if (!image->Has(Pipeline::WHOLE_EXTENT()))
    throw std::invalid_argument("there is no image: what gives the input has failed");
  vtkNew<vtkImageData> told;
  told->CopyInformationFromPipeline(image);
  told->SetExtent(image->Get(Pipeline::WHOLE_EXTENT()));
  return ImageGeometry(told);
}

void SayImage(vtkInformation* output, const GridGeometry& geometry)
{
  const glm::ivec3 last = geometry.dims - 1;
  output->Set(Pipeline::WHOLE_EXTENT(), 0, last.x, 0, last.y, 0, last.z);
  output->Set(vtkDataObject::ORIGIN(), &geometry.origin.x, 3);
  output->Set(vtkDataObject::SPACING(), &geometry.spacing.x, 3);
  const glm::dmat3 rows = glm::transpose(geometry.direction);
  output->Set(vtkDataObject::DIRECTION(), &rows[0].x, 9);
  vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_FLOAT, 1);
}

void AskForAll(vtkInformation* input)
{
  if (input->Has(Pipeline::WHOLE_EXTENT()))
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
}

void GiveImage(vtkImageData* output, const GridGeometry& geometry,
  const std::vector<float>& samples, const char* name)
{
  output->ShallowCopy(MakeImage(geometry, samples));
  output->GetPointData()->GetScalars()->SetName(name);
}

} // namespace hasp
