#include "vtkHaspVolumeReader.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeFile.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>

vtkStandardNewMacro(vtkHaspVolumeReader);

struct vtkHaspVolumeReader::Internals
{
  hasp::VolumeReadSettings settings;
  hasp::OpenedVolume opened;
  hasp::Passport passport;
};

vtkHaspVolumeReader::vtkHaspVolumeReader() : Inside(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHaspVolumeReader::~vtkHaspVolumeReader()
{
  this->SetFileName(nullptr);
}

void vtkHaspVolumeReader::SetSeries(int series)
{
  if (this->Inside->settings.series == series)
    return;
  this->Inside->settings.series = series;
  this->Modified();
}

int vtkHaspVolumeReader::GetSeries() const
{
  return this->Inside->settings.series;
}

void vtkHaspVolumeReader::SetResample(bool resample)
{
  if (this->Inside->settings.resample == resample)
    return;
  this->Inside->settings.resample = resample;
  this->Modified();
}

bool vtkHaspVolumeReader::GetResample() const
{
  return this->Inside->settings.resample;
}

void vtkHaspVolumeReader::SetSettings(const hasp::VolumeReadSettings& settings)
{
  this->Inside->settings = settings;
  this->Modified();
}

const hasp::VolumeReadSettings& vtkHaspVolumeReader::GetSettings() const
{
  return this->Inside->settings;
}

const hasp::Passport& vtkHaspVolumeReader::GetPassport() const
{
  return this->Inside->passport;
}

int vtkHaspVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  Internals& inside = *this->Inside;
  inside.opened = {};
  inside.passport = {};
  this->SetErrorCode(vtkErrorCode::NoError);
  this->AbortExecute = 0; // VTK clears it before RequestData only
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  try
  {
    inside.opened =
      hasp::OpenVolume(this->FileName ? this->FileName : "", inside.settings, progress);
  }
  catch (const std::exception& error)
  {
    if (const auto* refused = dynamic_cast<const hasp::ImportError*>(&error))
      inside.passport = *refused->passport;
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    this->GetOutput()->Initialize(); // nothing of an earlier file may stay
    return 0;
  }
  inside.passport = inside.opened.passport;
  const hasp::GridGeometry& g = inside.passport.geometry;
  vtkInformation* output = outputs->GetInformationObject(0);
  const int extent[6] = { 0, g.dims.x - 1, 0, g.dims.y - 1, 0, g.dims.z - 1 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), &g.origin.x, 3);
  output->Set(vtkDataObject::SPACING(), &g.spacing.x, 3);
  const glm::dmat3& d = g.direction; // column-major; VTK wants rows
  const double direction[9] = { d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1], d[0][2],
    d[1][2], d[2][2] };
  output->Set(vtkDataObject::DIRECTION(), direction, 9);
  return 1;
}

int vtkHaspVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  if (!this->Inside->opened.load) // refused, which was said when its header was read
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
    const hasp::LoadedVolume volume = hasp::LoadVolume(this->Inside->opened, progress);
    this->Inside->passport = volume.passport;
    output->ShallowCopy(volume.image);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::UserError);
    output->Initialize();
    return 0;
  }
  return 1;
}

void vtkHaspVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const hasp::Passport& p = this->GetPassport();
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n"
     << indent << "Series: " << this->GetSeries() << "\n"
     << indent << "Resample: " << (this->GetResample() ? "on" : "off") << "\n"
     << indent << "Format: " << p.format << "\n"
     << indent << "Modality: " << p.modality << (p.hounsfield ? ", HU" : "") << "\n"
     << indent << "Samples: " << p.sampleType << ", " << p.minimum << " to " << p.maximum << "\n";
}
