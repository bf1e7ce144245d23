#pragma once
#include "Dicom/DicomWire.h"

#include <filesystem>
#include <string>

/// What the decoder itself answers for one file, without the parent's checks.
struct DecoderAnswer
{
  hasp::SliceRecord record{};
  std::string pixels; ///< as bytes
};

/// Runs hasp-dicom-decode in "scan" or "decode" mode, with 64 MiB. `folder` is for the list and the
/// answer. Throws std::runtime_error if there is no whole answer.
DecoderAnswer RunDecoder(const std::string& mode, const std::filesystem::path& file,
  const std::filesystem::path& folder, const std::string& locale = "C");
