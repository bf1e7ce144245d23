#include "vtkHaspSegmentationWriter.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspLabelTable.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <exception>

vtkStandardNewMacro(vtkHaspSegmentationWriter);

vtkHaspSegmentationWriter::~vtkHaspSegmentationWriter()
{
  this->SetFileName(nullptr);
}

int vtkHaspSegmentationWriter::Write()
{
  this->SetErrorCode(
    vtkErrorCode::UserError); // stays where the input fails: WriteData is not reached
  return this->Superclass::Write();
}

void vtkHaspSegmentationWriter::WriteData()
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
    vtkImageData* labels = vtkImageData::SafeDownCast(this->GetInput());
    hasp::WriteLabels(
      labels, hasp::GetLabelTable(labels), this->FileName, { this->Compress }, progress);
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

int vtkHaspSegmentationWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkHaspSegmentationWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n"
     << indent << "Compress: " << (this->Compress ? "on" : "off") << "\n";
}
