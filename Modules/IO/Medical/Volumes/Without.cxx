#include "Volumes/VolumeFormat.h"
#include "vtkHaspDicomOutput.h"

#include <stdexcept>

// The formats this build was made without: they are named, so that the error says what to do.
namespace hasp
{

#if !HASP_WITH_DCMTK
OpenedVolume OpenDicomFolder(
  const std::filesystem::path& folder, const VolumeReadSettings&, const ProgressFunction&)
{
  ThrowFileError(folder, "this build of Hasp was made without DICOM; configure it with "
                         "HASP_ENABLE_DCMTK=ON");
}
#endif

#if !HASP_WITH_VTKDICOM
DicomOutput WriteDicomSeries(
  vtkImageData*, const std::string&, const DicomOutputSettings&, const ProgressFunction&)
{
  throw std::runtime_error("this build of Hasp was made without DICOM output; configure it with "
                           "HASP_ENABLE_VTKDICOM=ON (Debian: libvtk-dicom-dev)");
}
#endif

#if !HASP_WITH_LIBARCHIVE
OpenedVolume OpenInvesalius(const std::filesystem::path& file, const VolumeReadSettings&)
{
  ThrowFileError(file, "this build of Hasp was made without InVesalius projects; configure it with "
                       "HASP_ENABLE_LIBARCHIVE=ON");
}
#endif

} // namespace hasp
