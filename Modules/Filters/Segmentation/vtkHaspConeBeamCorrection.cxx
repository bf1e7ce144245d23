#include "vtkHaspConeBeamCorrection.h"

#include "Segmentation/ConeBeam.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkHaspConeBeamCorrection);

int vtkHaspConeBeamCorrection::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_FLOAT, 1);
  return 1;
}

int vtkHaspConeBeamCorrection::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  if (input->Has(Pipeline::WHOLE_EXTENT())) // shading is known of the whole alone
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  return 1;
}

int vtkHaspConeBeamCorrection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      const hasp::AnyGridView view = hasp::ViewImage(input);
      vtkNew<vtkFloatArray> corrected;
      corrected->SetName("Corrected");
      corrected->SetNumberOfValues(input->GetNumberOfPoints());
      const hasp::ConeBeamFindings found = hasp::CorrectConeBeam(view,
        { .fieldMm = this->FieldMm,
          .contrastMm = this->ContrastMm,
          .insideAbove = this->InsideAbove },
        { corrected->GetPointer(0), hasp::GeometryOf(view) }, progress);
      output->CopyStructure(input);
      output->GetPointData()->SetScalars(corrected);
      this->HasAir = found.air.has_value();
      this->AirLevel = found.air.value_or(0.0);
      this->SoftTissueLevel = found.softTissue;
      this->LowestShading = found.lowest;
      this->HighestShading = found.highest;
    });
}

void vtkHaspConeBeamCorrection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldMm: " << this->FieldMm << "\n"
     << indent << "ContrastMm: " << this->ContrastMm << "\n"
     << indent << "InsideAbove: " << this->InsideAbove << "\n"
     << indent << "HasAir: " << this->HasAir << "\n"
     << indent << "AirLevel: " << this->AirLevel << "\n"
     << indent << "SoftTissueLevel: " << this->SoftTissueLevel << "\n"
     << indent << "LowestShading: " << this->LowestShading << "\n"
     << indent << "HighestShading: " << this->HighestShading << "\n";
}
