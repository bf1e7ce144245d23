#include "vtkHaspSegmentationReader.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspLabelTable.h"
#include "vtkHaspVolumeView.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>

vtkStandardNewMacro(vtkHaspSegmentationReader);

struct vtkHaspSegmentationReader::Internals
{
  hasp::OpenedVolume opened;
  hasp::Passport passport;
};

namespace
{

/// Of the scan, as its source announces it; none without a scan.
std::optional<hasp::GridGeometry> ScanGrid(vtkInformation* scan)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!scan)
    return {};
  vtkNew<vtkImageData> frame; // ImageGeometry knows how extents move origins
  if (scan->Has(Pipeline::WHOLE_EXTENT()))
    frame->SetExtent(scan->Get(Pipeline::WHOLE_EXTENT()));
  if (scan->Has(vtkDataObject::ORIGIN()))
    frame->SetOrigin(scan->Get(vtkDataObject::ORIGIN()));
  if (scan->Has(vtkDataObject::SPACING()))
    frame->SetSpacing(scan->Get(vtkDataObject::SPACING()));
  if (scan->Has(vtkDataObject::DIRECTION()))
    frame->SetDirectionMatrix(scan->Get(vtkDataObject::DIRECTION()));
  return hasp::ImageGeometry(frame);
}

void Announce(const hasp::GridGeometry& g, vtkInformation* output)
{
  const int extent[6] = { 0, g.dims.x - 1, 0, g.dims.y - 1, 0, g.dims.z - 1 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), &g.origin.x, 3);
  output->Set(vtkDataObject::SPACING(), &g.spacing.x, 3);
  double direction[9]; // by rows
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      direction[3 * row + column] = g.direction[column][row];
  output->Set(vtkDataObject::DIRECTION(), direction, 9);
  vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_UNSIGNED_SHORT, 1);
}

} // namespace

vtkHaspSegmentationReader::vtkHaspSegmentationReader() : Inside(std::make_unique<Internals>()) {}

vtkHaspSegmentationReader::~vtkHaspSegmentationReader()
{
  this->SetFileName(nullptr);
}

const hasp::Passport& vtkHaspSegmentationReader::GetPassport() const
{
  return this->Inside->passport;
}

int vtkHaspSegmentationReader::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkHaspSegmentationReader::Fail(const char* text)
{
  vtkErrorMacro(<< text);
  this->SetErrorCode(vtkErrorCode::UserError);
  this->GetOutput()->Initialize(); // nothing of an earlier file may stay
  return 0;
}

int vtkHaspSegmentationReader::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Internals& inside = *this->Inside;
  inside.opened = {};
  inside.passport = {};
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    hasp::VolumeReadSettings settings;
    settings.layer = this->Layer;
    inside.opened = hasp::OpenVolume(this->FileName ? this->FileName : "", settings);
    inside.passport = inside.opened.passport;
    const auto scan = ScanGrid(inputs[0]->GetInformationObject(0));
    Announce(scan.value_or(inside.passport.geometry), outputs->GetInformationObject(0));
  }
  catch (const std::exception& error)
  {
    if (const auto* refused = dynamic_cast<const hasp::ImportError*>(&error))
      inside.passport = *refused->passport;
    inside.opened = {};
    return this->Fail(error.what());
  }
  return 1;
}

int vtkHaspSegmentationReader::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // The scan's extent is its own, whatever is asked of the labels.
  if (vtkInformation* scan = inputs[0]->GetInformationObject(0))
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    scan->Set(Pipeline::UPDATE_EXTENT(), scan->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

int vtkHaspSegmentationReader::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  Internals& inside = *this->Inside;
  if (!inside.opened.load) // refused, which was said when its header was read
  {
    output->Initialize();
    return 0;
  }
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  try
  {
    const hasp::LoadedLabels labels =
      hasp::LoadLabels(inside.opened, ScanGrid(inputs[0]->GetInformationObject(0)), progress);
    inside.passport = labels.passport;
    output->ShallowCopy(labels.image);
    hasp::SetLabelTable(output, labels.table);
  }
  catch (const std::exception& error)
  {
    return this->Fail(error.what());
  }
  return 1;
}

void vtkHaspSegmentationReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const hasp::Passport& p = this->GetPassport();
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n"
     << indent << "Layer: " << this->Layer << "\n"
     << indent << "Format: " << p.format << "\n"
     << indent << "Segments: " << p.segments << "\n";
}
