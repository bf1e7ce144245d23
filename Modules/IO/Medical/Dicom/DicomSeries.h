#pragma once
#include "Dicom/DicomWire.h"
#include "vtkHaspVolumeFile.h"

#include "Grid/ResampleStack.h"

#include <filesystem>
#include <optional>
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

/// A further slice at the place of slices[of].
struct DoubledSlice
{
  std::size_t of = 0;
  DicomSlice slice;
};

/// The slices of one series in order along their normal, and the volume they make.
struct DicomStack
{
  std::vector<DicomSlice> slices;
  std::vector<DoubledSlice> doubles; ///< to be left out, if their pixels are the same
  SliceStack layout;
  std::optional<ResamplePlan> plan; ///< none: the slices are the volume as they are
  Passport passport;
};

/// Chooses the series, holds its headers against each other and plans its resampling, if that is
/// asked for and needed. `folder` only names the error. Throws ImportError with all faults. No file
/// is read.
DicomStack StackSeries(const std::filesystem::path& folder, std::vector<DicomSlice> files,
  const VolumeReadSettings& settings);

/// "file 7 (instance 7)", or its name where names are shown: how errors speak of a slice.
std::string SliceName(const DicomSlice& slice);

/// Three numbers of a record.
glm::dvec3 Vector(const double* numbers);

/// "1.25 mm", to a ten thousandth.
std::string Millimetres(double value);

} // namespace hasp
