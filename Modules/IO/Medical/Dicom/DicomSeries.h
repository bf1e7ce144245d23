#pragma once
#include "Dicom/DicomWire.h"
#include "vtkHaspVolumeFile.h"

#include <filesystem>
#include <vector>

namespace hasp
{

/// One file of a folder, or a frame of it, and what the decoder says of it.
struct DicomSlice
{
  std::filesystem::path file;
  int number = 0; ///< in the folder, from 1, in the order of the paths
  std::uint64_t fileBytes = 0;
  SliceRecord record{};
};

/// The slices of one series in order along their normal, and the volume they make.
struct DicomStack
{
  std::vector<DicomSlice> slices;
  Passport passport;
};

/// Chooses the series and holds its headers against each other. `folder` only names the error.
/// Throws std::runtime_error with what is wrong, at which slices, and what to do. No file is read.
DicomStack StackSeries(const std::filesystem::path& folder, std::vector<DicomSlice> files,
  const VolumeReadSettings& settings);

/// "file 7 (instance 7)", or its name where names are shown: how errors speak of a slice.
std::string SliceName(const DicomSlice& slice);

} // namespace hasp
