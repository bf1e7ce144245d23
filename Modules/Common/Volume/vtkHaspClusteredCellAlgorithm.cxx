#include "vtkHaspClusteredCellAlgorithm.h"
#include "vtkHaspClusteredCells.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

vtkHaspClusteredCellAlgorithm::vtkHaspClusteredCellAlgorithm()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

vtkHaspClusteredCells* vtkHaspClusteredCellAlgorithm::GetOutput()
{
  return this->GetOutput(0);
}

vtkHaspClusteredCells* vtkHaspClusteredCellAlgorithm::GetOutput(int port)
{
  return vtkHaspClusteredCells::SafeDownCast(this->GetOutputDataObject(port));
}

void vtkHaspClusteredCellAlgorithm::SetInputData(vtkDataObject* input)
{
  this->SetInputDataObject(0, input);
}

vtkTypeBool vtkHaspClusteredCellAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
    return this->RequestData(request, inputs, outputs);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
    return this->RequestInformation(request, inputs, outputs);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    // VTK makes its own data objects by their name; this one it does not know.
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
      if (!vtkHaspClusteredCells::GetData(outputs, port))
      {
        const vtkNew<vtkHaspClusteredCells> made;
        outputs->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), made);
      }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkHaspClusteredCellAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

int vtkHaspClusteredCellAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkHaspClusteredCells");
  return 1;
}
