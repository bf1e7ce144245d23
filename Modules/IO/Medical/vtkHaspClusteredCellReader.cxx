#include "vtkHaspClusteredCellReader.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFileNames.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"

#include <exception>

vtkStandardNewMacro(vtkHaspClusteredCellReader);

vtkHaspClusteredCellReader::vtkHaspClusteredCellReader()
  : MemoryLimit(hasp::CellReadSettings().memoryLimitBytes)
{
  this->SetNumberOfInputPorts(0);
}

vtkHaspClusteredCellReader::~vtkHaspClusteredCellReader()
{
  this->SetFileName(nullptr);
}

int vtkHaspClusteredCellReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkHaspClusteredCells* output = vtkHaspClusteredCells::GetData(outputs);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No FileName is set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 0;
  }
  try
  {
    output->SetCells(hasp::LoadCells(this->FileName, { this->MemoryLimit }, progress));
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    return 0;
  }
}

void vtkHaspClusteredCellReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
