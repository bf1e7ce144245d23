#pragma once
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace hasp
{

/// What --volume names, as reports may show it: by what it is, never by its file.
struct ReportVolume
{
  vtkSmartPointer<vtkImageData> image;
  std::string name;        ///< "cranium": the demo's CT, whatever its file is called; else "volume"
  std::string data;        ///< "real CT, 512x512x93, 226" or "given volume, ..."
  double isovalue = 226.0; ///< bone in HU
};

/// The demo's CT is known by its hash, so not in builds without OpenSSL. Throws Failure: BadInput,
/// also for a volume without a surface at 226.
ReportVolume ReadReportVolume(const std::string& path);

/// Before what takes minutes: throws Failure if there is a file that is no volume. Reads its
/// header.
void RequireReportVolume(const std::string& path);

} // namespace hasp
