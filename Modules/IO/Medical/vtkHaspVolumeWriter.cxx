#include "vtkHaspVolumeWriter.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <exception>

vtkStandardNewMacro(vtkHaspVolumeWriter);

vtkHaspVolumeWriter::~vtkHaspVolumeWriter()
{
  this->SetFileName(nullptr);
}

int vtkHaspVolumeWriter::Write()
{
  this->SetErrorCode(
    vtkErrorCode::UserError); // stays where the input fails: WriteData is not reached
  return this->Superclass::Write();
}

void vtkHaspVolumeWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No FileName is set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    hasp::WriteVolume(vtkImageData::SafeDownCast(this->GetInput()), this->FileName);
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

int vtkHaspVolumeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkHaspVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n";
}
