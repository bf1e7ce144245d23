#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkHaspSurfaceWriter);

vtkHaspSurfaceWriter::~vtkHaspSurfaceWriter()
{
  this->SetFileName(nullptr);
}

int vtkHaspSurfaceWriter::Write()
{
  this->SetErrorCode(
    vtkErrorCode::UserError); // stays where the input fails: WriteData is not reached
  return this->Superclass::Write();
}

void vtkHaspSurfaceWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No FileName is set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    hasp::WriteSurface(vtkPolyData::SafeDownCast(this->GetInput()), this->FileName);
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

int vtkHaspSurfaceWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkHaspSurfaceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n";
}
