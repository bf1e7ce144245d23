#pragma once
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

/// Somebody else's reader: its output image is taken at its word, turned by the matrix it offers
/// beside, if it offers one.
struct ImportRival
{
  std::string name; ///< with its version
  std::function<vtkSmartPointer<vtkImageData>(const std::string& path)> read;
};

/// A format that this build writes and reads.
struct ImportFormat
{
  std::string id;     ///< "nrrd"
  std::string ending; ///< ".nrrd"; empty: a folder of DICOM slices
  std::vector<ImportRival> rivals;
};

std::vector<ImportFormat> ImportFormats();

/// Our own reader, as `ImportRival::read`.
vtkSmartPointer<vtkImageData> ReadOurs(const std::string& path);

/// Writes the volume in that format; `name` gets the format's ending. Gives the path.
std::string WriteImport(vtkImageData* image, const ImportFormat& format, const std::string& name);

/// True if the reader says by an error that it does not trust the folder. It runs in a process of
/// its own, for some readers crash on some folders; a crash counts as an error said.
bool Notices(const ImportRival& reader, const std::string& folder);

} // namespace hasp
