#include "vtkHaspClusteredCellWriter.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFileNames.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <exception>

vtkStandardNewMacro(vtkHaspClusteredCellWriter);

vtkHaspClusteredCellWriter::~vtkHaspClusteredCellWriter()
{
  this->SetFileName(nullptr);
}

int vtkHaspClusteredCellWriter::Write()
{
  this->SetErrorCode(
    vtkErrorCode::UserError); // stays where the input fails: WriteData is not reached
  return this->Superclass::Write();
}

void vtkHaspClusteredCellWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No FileName is set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  try
  {
    hasp::WriteCells(
      *vtkHaspClusteredCells::SafeDownCast(this->GetInput())->GetCells(), this->FileName, progress);
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

int vtkHaspClusteredCellWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkHaspClusteredCells");
  return 1;
}

void vtkHaspClusteredCellWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n";
}
