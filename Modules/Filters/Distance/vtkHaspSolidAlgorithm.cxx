#include "vtkHaspSolidAlgorithm.h"
#include "vtkHaspSolid.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

vtkHaspSolid* vtkHaspSolidAlgorithm::GetOutput()
{
  return vtkHaspSolid::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkHaspSolidAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkHaspSolid");
  return 1;
}

int vtkHaspSolidAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // VTK makes its own data objects by their name; this one it does not know.
  if (!vtkHaspSolid::GetData(outputs))
  {
    const vtkNew<vtkHaspSolid> made;
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}
