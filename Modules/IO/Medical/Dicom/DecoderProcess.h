#pragma once
#include "Dicom/DicomSeries.h"
#include "Sandbox/ChildProcess.h"

#include <string>
#include <vector>

namespace hasp
{

/// The child process that parses DICOM: started with a list of files, read from as it answers, and
/// ended with this object whatever happens. See Sandbox/Confinement.h for what it may do, and
/// ChildProcess for what is thrown. One thread at a time.
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
  DecoderProcess(const DecoderProcess&) = delete;
  DecoderProcess& operator=(const DecoderProcess&) = delete;

  /// The next file's record (scan: the next frame's, while moreFrames is not 0), its fields within
  /// the ranges DicomWire.h names. pixelBytes is 0 or rows * columns * 2. Calls progress at least
  /// twice a second while it waits.
  SliceRecord NextRecord(const ProgressFunction& progress);

  /// The pixels that follow a record. `into` has room for record.pixelBytes.
  void ReadPixels(const SliceRecord& record, void* into, const ProgressFunction& progress);

  /// After the last record: the child must have ended well, and sent nothing more.
  void Finish(const ProgressFunction& progress);

private:
  ChildProcess::Beat BeatOf(const ProgressFunction& progress) const;
  void Check(const SliceRecord& record) const;
  ChildSettings SettingsOf(const VolumeReadSettings& settings) const;
  std::string AtFile() const;
  double WorkSeconds() const; ///< of the awaited answer, on top of the silence it may keep

  const Mode Doing;
  const std::vector<DicomSlice> Files;
  const std::uint64_t Memory;   ///< bytes the child may take on top of its own
  std::size_t Next = 0;         ///< the file whose answer is awaited
  std::uint32_t Frame = 0;      ///< the frame of it, while scanning
  std::uint32_t MoreFrames = 0; ///< as its latest record promised
  ChildProcess Process;
};

} // namespace hasp
