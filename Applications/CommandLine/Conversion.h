#pragma once
#include "VolumeInput.h"

#include <cstddef>
#include <string>

namespace hasp
{

struct Session;

/// What `hasp convert` was asked for.
struct ConvertOptions
{
  VolumeChoices volume;
  std::string output;
  std::string modality;    ///< "CT", "MR" or "OT": of DICOM slices, where the input says none
  bool hounsfield = false; ///< the values are HU, though the input does not say so
  bool quantise = false;   ///< DICOM slices may round float samples
};

/// What an output's name asks for: slices have no ending, or a slash at the end.
enum class OutputKind
{
  Volume,
  Segmentation,
  Surface,
  Slices,
  Unknown
};
OutputKind KindOfOutput(const std::string& path);

/// Bytes of a file, or of all files in a folder.
std::size_t BytesOf(const std::string& path);

/// Reads a volume, writes it, reads that back and keeps it if nothing has changed. Prints what was
/// read and written. Throws Failure: WrongUse, BadInput; FailedCheck with what differs.
void ConvertVolume(const ConvertOptions& options, OutputKind kind, Session& session);

/// The same of a surface: every triangle, in order.
void ConvertSurface(const ConvertOptions& options, Session& session);

} // namespace hasp
