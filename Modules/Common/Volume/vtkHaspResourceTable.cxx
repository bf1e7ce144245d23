#include "vtkHaspResourceTable.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

void hasp::FillTable(const ResourceList& resources, vtkTable* table)
{
  vtkNew<vtkStringArray> names, reasons;
  vtkNew<vtkIdTypeArray> bytes;
  vtkNew<vtkDoubleArray> milliseconds;
  names->SetName("resource");
  bytes->SetName("bytes");
  milliseconds->SetName("milliseconds");
  reasons->SetName("reason");
  for (const ResourceUse& use : resources)
  {
    names->InsertNextValue(use.resource);
    bytes->InsertNextValue(static_cast<vtkIdType>(use.bytes));
    milliseconds->InsertNextValue(use.milliseconds);
    reasons->InsertNextValue(use.reason);
  }
  table->Initialize();
  table->AddColumn(names);
  table->AddColumn(bytes);
  table->AddColumn(milliseconds);
  table->AddColumn(reasons);
}
