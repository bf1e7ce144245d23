#pragma once
#include "Files/FileError.h"
#include "vtkHaspVolumeFile.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

/// One function per format; OpenVolume picks. Internal to IOMedical.
namespace hasp
{

OpenedVolume OpenDicomFolder(
  const std::filesystem::path& folder, const VolumeReadSettings& settings, const ProgressFunction&);
OpenedVolume OpenInvesalius(const std::filesystem::path& file, const VolumeReadSettings& settings);
OpenedVolume OpenMetaImage(const std::filesystem::path& file, const VolumeReadSettings& settings);
OpenedVolume OpenNrrd(const std::filesystem::path& file, const VolumeReadSettings& settings);
OpenedVolume OpenSegmentation(
  const std::filesystem::path& file, const VolumeReadSettings& settings);
OpenedVolume OpenNifti(const std::filesystem::path& file, const VolumeReadSettings& settings);
OpenedVolume OpenXMLImage(const std::filesystem::path& file, const VolumeReadSettings& settings);

/// Text of a file that may be shown: what is not printable ASCII becomes "?".
std::string SafeText(const std::string& text);

/// The modality if it is one of the few that these formats' passports name ("CT", "MR", ...), else
/// empty: other text of a file goes nowhere.
std::string KnownModality(std::string_view text);

/// What is wrong with x*y*z samples, if a size is below 1 or above INT_MAX or their bytes are above
/// the limit; else empty.
std::string TooManySamples(std::int64_t x, std::int64_t y, std::int64_t z,
  std::size_t bytesPerSample, std::size_t limitBytes);

/// Bytes of x*y*z samples. Throws ImportError (TooLarge) where TooManySamples says something. Call
/// before taking memory.
std::size_t CheckSampleBytes(const std::filesystem::path& file, std::int64_t x, std::int64_t y,
  std::int64_t z, std::size_t bytesPerSample, std::size_t limitBytes);

/// An image of this geometry with room for samples of a VTK type; they are not set.
vtkSmartPointer<vtkImageData> NewImage(const GridGeometry& geometry, int vtkType);

/// "int16" for VTK_SHORT and so on; empty for a type that no kernel reads.
std::string SampleTypeName(int vtkType);

} // namespace hasp
