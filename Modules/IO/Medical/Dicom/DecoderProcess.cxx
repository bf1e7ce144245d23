#include "Dicom/DecoderProcess.h"
#include "Dicom/DicomTerms.h"
#include "Volumes/VolumeFormat.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hasp
{
namespace
{

std::string ListOf(const std::vector<DicomSlice>& files)
{
  std::string list;
  for (const DicomSlice& slice : files)
    list.append(std::to_string(slice.record.frameNumber) + ":" + slice.file.native())
      .push_back('\0');
  return list;
}

/// Fewer than any decoder unpacks a second, measured: JPEG lossless, the slowest, does five times
/// as many on one core.
constexpr double SlowestBytesPerSecond = 8 << 20;

/// What parsing holds besides the slice: codec tables, buffers and the header's attributes, which
/// take about thirty times their size in the file. Measured: 1 MiB for what scanners write.
constexpr std::uint64_t HeaderBytes = 64 << 20;

std::uint64_t DeclaredBytes(const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  return std::uint64_t(r.rows) * r.columns * std::max<std::uint64_t>(1, r.bitsAllocated / 8);
}

/// What a slice honestly takes to read and unpack. A file far smaller than the picture it declares
/// unpacks fast (runs of one value), or not at all.
std::uint64_t WorkBytes(const DicomSlice& slice)
{
  const std::uint64_t frames =
    std::uint64_t(slice.record.frameNumber) + slice.record.moreFrames + 1;
  const std::uint64_t stored = slice.fileBytes / frames;
  return std::max(stored, std::min(DeclaredBytes(slice), 64 * stored));
}

std::uint64_t DecoderMemory(bool decode, const std::vector<DicomSlice>& files, std::uint64_t atMost)
{
  std::uint64_t largest = 0;
  if (decode)
    for (const DicomSlice& slice : files)
      largest = std::max({ largest, DeclaredBytes(slice), slice.fileBytes });
  return std::min(atMost, HeaderBytes + 4 * largest);
}

template <std::size_t Room>
bool Ended(const char (&text)[Room])
{
  return std::memchr(text, '\0', Room) != nullptr;
}

/// UIDs are only ended: they are compared and never shown.
bool TextsAreKnown(const SliceRecord& r)
{
  return Ended(r.modality) && IsTerm(Modalities, r.modality) && Ended(r.photometric) &&
         IsTerm(Photometrics, r.photometric) && Ended(r.patientPosition) &&
         IsTerm(PatientPositions, r.patientPosition) && Ended(r.transferSyntax) &&
         IsSyntaxName(r.transferSyntax) && Ended(r.series) && Ended(r.frame);
}

} // namespace

DecoderProcess::DecoderProcess(
  Mode mode, std::vector<DicomSlice> files, const VolumeReadSettings& settings)
  : Doing(mode),
    Files(std::move(files)),
    Memory(DecoderMemory(mode == Mode::Decode, this->Files, settings.decoderMemoryBytes)),
    Process(
      { "hasp-dicom-decode", mode == Mode::Scan ? "scan" : "decode", std::to_string(this->Memory),
        std::to_string(static_cast<long>(std::ceil(settings.decoderTotalSeconds)) + 1) },
      ListOf(this->Files), this->SettingsOf(settings))
{
}

ChildSettings DecoderProcess::SettingsOf(const VolumeReadSettings& settings) const
{
  const std::string remedy = "Take that file out of the folder or export the series again";
  return { .program = { "hasp-dicom-decode", "HASP_DICOM_DECODER", "the DICOM decoder" },
    .memoryBytes = this->Memory,
    .silenceSeconds = [this, most = settings.decoderSilenceSeconds]
    { return most + this->WorkSeconds(); },
    .totalSeconds = settings.decoderTotalSeconds,
    .remedy = remedy,
    .memoryRemedy = this->Memory == settings.decoderMemoryBytes
                      ? ". " + remedy + ", or raise decoderMemoryBytes"
                      : ": the file is damaged, or unpacks to far more than it declares. " + remedy,
    .endings = { { 5, "DCMTK's dictionary of DICOM attributes is not installed (Debian: "
                      "libdcmtk17); without it DICOM cannot be read" } },
    .at = [this] { return this->AtFile(); } };
}

std::string DecoderProcess::AtFile() const
{
  return this->Next < this->Files.size() ? " at " + SliceName(this->Files[this->Next])
                                         : std::string();
}

double DecoderProcess::WorkSeconds() const
{
  const bool decoding = this->Doing == Mode::Decode && this->Next < this->Files.size();
  return decoding ? double(WorkBytes(this->Files[this->Next])) / SlowestBytesPerSecond : 0.0;
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
  if (r.magic != SliceRecord::Magic)
    this->Process.ThrowGarbage("magic number");
  if (r.index != this->Next)
    this->Process.ThrowGarbage("out of order");
  const bool inOrder =
    this->Doing == Mode::Decode
      ? r.frameNumber == this->Files[this->Next].record.frameNumber && r.moreFrames == 0
      : r.frameNumber == this->Frame &&
          (r.frameNumber == 0 || r.moreFrames + 1 == this->MoreFrames);
  if (!inOrder)
    this->Process.ThrowGarbage("frame out of order");
  if (r.status > static_cast<std::uint32_t>(SliceStatus::Last) || (r.flags & ~AllFlags) != 0)
    this->Process.ThrowGarbage("status");
  if (r.rows > 65535 || r.columns > 65535)
    this->Process.ThrowGarbage("size");
  if (!TextsAreKnown(r))
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
  this->Frame = record.moreFrames > 0 ? record.frameNumber + 1 : 0;
  this->MoreFrames = record.moreFrames;
  if (record.pixelBytes == 0 && record.moreFrames == 0)
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
