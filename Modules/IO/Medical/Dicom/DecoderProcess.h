#pragma once
#include "Dicom/DicomWire.h"
#include "Sandbox/ChildProcess.h"
#include "vtkHaspVolumeFile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// The child process that parses DICOM: started with a list of files, read from as it answers, and
/// ended with this object whatever happens.
///
/// Every failure throws std::runtime_error that says what the child did (crashed, fell silent, ran
/// out of memory, sent what is no answer), at which file, and what to do. One thread at a time.
class DecoderProcess
{
public:
  enum class Mode
  {
    Scan,
    Decode
  };
  DecoderProcess(
    Mode mode, const std::vector<std::filesystem::path>& files, const VolumeReadSettings& settings);
  DecoderProcess(const DecoderProcess&) = delete;
  DecoderProcess& operator=(const DecoderProcess&) = delete;

  /// The next file's record, its fields within the ranges DicomWire.h names. pixelBytes is 0 or
  /// rows * columns * 2. Calls progress at least twice a second while it waits.
  SliceRecord NextRecord(const ProgressFunction& progress);

  /// The pixels that follow a record. `into` has room for record.pixelBytes.
  void ReadPixels(const SliceRecord& record, void* into, const ProgressFunction& progress);

  /// After the last record: the child must have ended well, and sent nothing more.
  void Finish(const ProgressFunction& progress);

private:
  ChildProcess::Beat BeatOf(const ProgressFunction& progress) const;
  void Check(const SliceRecord& record) const;
  std::string AtFile() const;

  Mode Doing;
  const std::vector<std::filesystem::path> Files;
  std::size_t Next = 0; ///< the file whose answer is awaited
  ChildProcess Process;
};

} // namespace hasp
