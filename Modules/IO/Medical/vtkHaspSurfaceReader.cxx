#include "vtkHaspSurfaceReader.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspSurfaceFile.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

vtkStandardNewMacro(vtkHaspSurfaceReader);

struct vtkHaspSurfaceReader::Internals
{
  hasp::SurfaceReadSettings settings;
  hasp::SurfacePassport passport;
};

vtkHaspSurfaceReader::vtkHaspSurfaceReader() : Inside(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkHaspSurfaceReader::~vtkHaspSurfaceReader()
{
  this->SetFileName(nullptr);
}

void vtkHaspSurfaceReader::SetSettings(const hasp::SurfaceReadSettings& settings)
{
  this->Inside->settings = settings;
  this->Modified();
}

const hasp::SurfaceReadSettings& vtkHaspSurfaceReader::GetSettings() const
{
  return this->Inside->settings;
}

const hasp::SurfacePassport& vtkHaspSurfaceReader::GetPassport() const
{
  return this->Inside->passport;
}

int vtkHaspSurfaceReader::GetNumberOfWarnings() const
{
  return static_cast<int>(this->Inside->passport.warnings.size());
}

std::string vtkHaspSurfaceReader::GetWarning(int n) const
{
  return n >= 0 && n < this->GetNumberOfWarnings() ? this->Inside->passport.warnings[n] : "";
}

int vtkHaspSurfaceReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Inside->passport = {};
  this->SetErrorCode(vtkErrorCode::NoError);
  const auto progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !this->AbortExecute;
  };
  try
  {
    const hasp::LoadedSurface loaded =
      hasp::LoadSurface(this->FileName ? this->FileName : "", this->Inside->settings, progress);
    this->Inside->passport = loaded.passport;
    output->ShallowCopy(loaded.surface);
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

void vtkHaspSurfaceReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const hasp::SurfacePassport& p = this->GetPassport();
  os << indent << "FileName: " << (this->FileName ? hasp::FileLabel(this->FileName) : "(none)")
     << "\n"
     << indent << "Format: " << p.format << "\n"
     << indent << "Points: " << p.points << ", " << p.coordinateType << "\n"
     << indent << "Triangles: " << p.triangles << "\n"
     << indent << "Warnings: " << p.warnings.size() << "\n";
}
