#pragma once
#include "Dicom/DicomSeries.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// The child process that parses DICOM: started with a list of files, read from as it answers, and
/// ended with this object whatever happens. See Decoder/Sandbox.h for what it may do.
///
/// Every failure throws std::runtime_error that says what the child did (crashed, fell silent, ran
/// out of memory, tried what is forbidden, sent what is no answer), at which file, and what to do.
/// One thread at a time.
class DecoderProcess
{
public:
  enum class Mode
  {
    Scan,
    Decode
  };
  /// Of the slices the paths, numbers and sizes are used, and to decode what their records declare:
  /// the child's memory and its time for each slice follow from it (see VolumeReadSettings).
  DecoderProcess(Mode mode, std::vector<DicomSlice> files, const VolumeReadSettings& settings);
  ~DecoderProcess();
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
  using Clock = std::chrono::steady_clock;
  std::size_t ReadSome(void* into, std::size_t size, const ProgressFunction& progress);
  void ReadAll(void* into, std::size_t size, const ProgressFunction& progress);
  void Check(const SliceRecord& record) const;
  [[noreturn]] void ThrowEnded();
  [[noreturn]] void ThrowExited(int code, const std::string& at, const std::string& remedy) const;
  [[noreturn]] void ThrowGarbage(const std::string& what) const;
  std::string AtFile() const;
  double SilenceSeconds() const; ///< how long the awaited answer may take
  int Reap();                    ///< wait status, once the child has closed its output

  Mode Doing;
  const std::vector<DicomSlice> Files;
  const VolumeReadSettings Settings;
  const std::uint64_t Memory; ///< bytes the child may take on top of its own
  Clock::time_point Started;
  std::size_t Next = 0; ///< the file whose answer is awaited
  int Output = -1;      ///< our end of the child's standard output
  int Child = -1;       ///< its process id; -1 once reaped
};

/// Where hasp-dicom-decode is: HASP_DICOM_DECODER, else beside this library. Throws
/// std::runtime_error if it is nowhere.
std::filesystem::path FindDecoder();

} // namespace hasp
