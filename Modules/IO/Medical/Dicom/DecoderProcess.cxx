#include "Dicom/DecoderProcess.h"
#include "Volumes/VolumeFormat.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hasp
{
namespace
{

std::string ListOf(const std::vector<std::filesystem::path>& files)
{
  std::string list;
  for (const auto& file : files)
    list.append(file.native()).push_back('\0');
  return list;
}

bool Ended(const char* text, std::size_t room)
{
  return std::memchr(text, '\0', room) != nullptr;
}

} // namespace

DecoderProcess::DecoderProcess(
  Mode mode, const std::vector<std::filesystem::path>& files, const VolumeReadSettings& settings)
  : Doing(mode),
    Files(files),
    Process({ "hasp-dicom-decode", mode == Mode::Scan ? "scan" : "decode",
              std::to_string(settings.decoderMemoryBytes),
              std::to_string(static_cast<long>(std::ceil(settings.decoderTotalSeconds)) + 1) },
      ListOf(files),
      { .program = { "hasp-dicom-decode", "HASP_DICOM_DECODER", "the DICOM decoder" },
        .memoryBytes = settings.decoderMemoryBytes,
        .silenceSeconds = settings.decoderSilenceSeconds,
        .totalSeconds = settings.decoderTotalSeconds,
        .remedy = "Take that file out of the folder or export the series again",
        .memoryRemedy = "raise decoderMemoryBytes",
        .endings = { { 5, "DCMTK's dictionary of DICOM attributes is not installed (Debian: "
                          "libdcmtk17); without it DICOM cannot be read" } },
        .at = [this] { return this->AtFile(); } })
{
}

std::string DecoderProcess::AtFile() const
{
  return this->Next < this->Files.size()
           ? " at " + (FileNamesShown() ? FileLabel(this->Files[this->Next])
                                        : "file " + std::to_string(this->Next + 1))
           : std::string();
}

ChildProcess::Beat DecoderProcess::BeatOf(const ProgressFunction& progress) const
{
  return [this, &progress]
  {
    ReportProgress(
      progress, double(this->Next) / double(std::max<std::size_t>(1, this->Files.size())));
  };
}

void DecoderProcess::Check(const SliceRecord& r) const
{
  if (r.magic != SliceRecord::Magic || r.reserved != 0)
    this->Process.ThrowGarbage("magic number");
  if (r.index != this->Next)
    this->Process.ThrowGarbage("out of order");
  if (r.status > static_cast<std::uint32_t>(SliceStatus::Last) || (r.flags & ~AllFlags) != 0)
    this->Process.ThrowGarbage("status");
  if (r.rows > 65535 || r.columns > 65535)
    this->Process.ThrowGarbage("size");
  if (!Ended(r.modality, sizeof(r.modality)) || !Ended(r.photometric, sizeof(r.photometric)) ||
      !Ended(r.transferSyntax, sizeof(r.transferSyntax)) || !Ended(r.series, sizeof(r.series)) ||
      !Ended(r.frame, sizeof(r.frame)))
    this->Process.ThrowGarbage("text");
  const bool pixels =
    this->Doing == Mode::Decode && r.status == static_cast<std::uint32_t>(SliceStatus::Image);
  if (r.pixelBytes != (pixels ? std::uint64_t(r.rows) * r.columns * 2 : 0))
    this->Process.ThrowGarbage("number of pixels");
}

SliceRecord DecoderProcess::NextRecord(const ProgressFunction& progress)
{
  SliceRecord record{};
  this->Process.Read(&record, sizeof(record), this->BeatOf(progress));
  this->Check(record);
  if (record.pixelBytes == 0)
    ++this->Next;
  return record;
}

void DecoderProcess::ReadPixels(
  const SliceRecord& record, void* into, const ProgressFunction& progress)
{
  this->Process.Read(into, record.pixelBytes, this->BeatOf(progress));
  ++this->Next;
}

void DecoderProcess::Finish(const ProgressFunction& progress)
{
  this->Process.Finish(this->BeatOf(progress));
}

} // namespace hasp
