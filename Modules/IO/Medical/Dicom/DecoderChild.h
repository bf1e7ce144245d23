#pragma once
#include "Dicom/DicomSeries.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// A started hasp-dicom-decode. Whoever has it closes `output`, ends the process and waits for it.
struct DecoderChild
{
  int process = -1;
  int output = -1; ///< our end of its standard output
};

/// Starts `program` as DicomWire.h says, with `mode` "scan" or "decode". It inherits nothing but
/// its list of files, the pipe and the environment. Throws std::runtime_error if the system
/// refuses.
DecoderChild StartDecoder(const std::filesystem::path& program, const std::string& mode,
  const std::vector<DicomSlice>& files, std::uint64_t memoryBytes, long processorSeconds);

} // namespace hasp
