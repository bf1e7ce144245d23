#include "Dicom/DecoderProcess.h"
#include "Dicom/DecoderChild.h"
#include "Dicom/DicomTerms.h"
#include "Volumes/VolumeFormat.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace hasp
{
namespace
{

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
  return std::max(slice.fileBytes, std::min(DeclaredBytes(slice), 64 * slice.fileBytes));
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
    Settings(settings),
    Memory(DecoderMemory(mode == Mode::Decode, this->Files, settings.decoderMemoryBytes)),
    Started(Clock::now())
{
  const DecoderChild child = StartDecoder(FindDecoder(), mode == Mode::Scan ? "scan" : "decode",
    this->Files, this->Memory, static_cast<long>(std::ceil(settings.decoderTotalSeconds)) + 1);
  this->Child = child.process;
  this->Output = child.output;
}

DecoderProcess::~DecoderProcess()
{
  if (this->Output >= 0)
    close(this->Output);
  if (this->Child > 0)
  {
    kill(this->Child, SIGKILL);
    this->Reap();
  }
}

int DecoderProcess::Reap()
{
  int status = 0;
  while (waitpid(this->Child, &status, 0) < 0 && errno == EINTR)
    ;
  this->Child = -1;
  return status;
}

std::string DecoderProcess::AtFile() const
{
  return this->Next < this->Files.size() ? " at " + SliceName(this->Files[this->Next])
                                         : std::string();
}

double DecoderProcess::SilenceSeconds() const
{
  const bool decoding = this->Doing == Mode::Decode && this->Next < this->Files.size();
  return this->Settings.decoderSilenceSeconds +
         (decoding ? double(WorkBytes(this->Files[this->Next])) / SlowestBytesPerSecond : 0.0);
}

std::size_t DecoderProcess::ReadSome(void* into, std::size_t size, const ProgressFunction& progress)
{
  const auto asked = Clock::now();
  const double silenceSeconds = this->SilenceSeconds();
  for (;;)
  {
    ReportProgress(
      progress, double(this->Next) / double(std::max<std::size_t>(1, this->Files.size())));
    const auto since = [](Clock::time_point then)
    { return std::chrono::duration<double>(Clock::now() - then).count(); };
    const double silent = since(asked), total = since(this->Started);
    if (silent >= silenceSeconds || total >= this->Settings.decoderTotalSeconds)
      throw std::runtime_error("the DICOM decoder hangs" + this->AtFile() + ": no end after " +
                               Text(std::round(10.0 * std::max(silent, total)) / 10.0) +
                               " s, so it was stopped. Take that file out of the folder, or raise "
                               "the decoder's time limit for a slow disk");
    const double left =
      std::min(silenceSeconds - silent, this->Settings.decoderTotalSeconds - total);
    pollfd wait{ this->Output, POLLIN, 0 };
    const int ready = poll(&wait, 1, static_cast<int>(std::min(500.0, 1000.0 * left)) + 1);
    if (ready <= 0)
      continue;
    const ssize_t got = read(this->Output, into, size);
    if (got >= 0)
      return static_cast<std::size_t>(got);
    if (errno != EINTR)
      throw std::runtime_error(
        std::string("the DICOM decoder cannot be read from: ") + strerror(errno));
  }
}

void DecoderProcess::ReadAll(void* into, std::size_t size, const ProgressFunction& progress)
{
  auto* bytes = static_cast<char*>(into);
  while (size > 0)
  {
    const std::size_t got = this->ReadSome(bytes, size, progress);
    if (got == 0)
      this->ThrowEnded();
    bytes += got;
    size -= got;
  }
}

void DecoderProcess::ThrowEnded()
{
  const std::string at = this->AtFile();
  // It has closed its output but need not have ended: it does now.
  kill(this->Child, SIGKILL);
  const int status = this->Reap();
  const std::string remedy = ". Take that file out of the folder or export the series again";
  if (WIFEXITED(status))
    this->ThrowExited(WEXITSTATUS(status), at, remedy);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGSYS)
    throw std::runtime_error("the DICOM decoder tried what it may not do" + at +
                             " (a forbidden system call) and was stopped before it was done; the "
                             "file may be made to attack" +
                             remedy);
  throw std::runtime_error("the DICOM decoder crashed" + at + " (" +
                           (signal != 0 ? strsignal(signal) : "unknown") + ")" + remedy);
}

void DecoderProcess::ThrowExited(int code, const std::string& at, const std::string& remedy) const
{
  if (code == 3)
    throw std::runtime_error("the DICOM decoder needs more memory than the " +
                             Text(std::round(double(this->Memory) / (1 << 20))) +
                             " MiB it was given" + at +
                             (this->Memory == this->Settings.decoderMemoryBytes
                                 ? remedy + ", or raise decoderMemoryBytes"
                                 : ": the file unpacks to far more than it declares" + remedy));
  if (code == 4)
    throw std::runtime_error(
      "the DICOM decoder cannot limit itself on this system (is /proc there, "
      "and may limits be set?); without limits it reads nothing");
  if (code == 5)
    throw std::runtime_error("DCMTK's dictionary of DICOM attributes is not installed (Debian: "
                             "libdcmtk17); without it DICOM cannot be read");
  throw std::runtime_error(
    "the DICOM decoder gave up with code " + std::to_string(code) + at + remedy);
}

void DecoderProcess::ThrowGarbage(const std::string& what) const
{
  throw std::runtime_error("the DICOM decoder sent no valid answer" + this->AtFile() + " (" + what +
                           "); is HASP_DICOM_DECODER the hasp-dicom-decode of this build?");
}

void DecoderProcess::Check(const SliceRecord& r) const
{
  if (r.magic != SliceRecord::Magic)
    this->ThrowGarbage("magic number");
  if (r.index != this->Next)
    this->ThrowGarbage("out of order");
  if (r.status > static_cast<std::uint32_t>(SliceStatus::Last) || (r.flags & ~AllFlags) != 0)
    this->ThrowGarbage("status");
  if (r.rows > 65535 || r.columns > 65535)
    this->ThrowGarbage("size");
  if (!TextsAreKnown(r))
    this->ThrowGarbage("text");
  const bool pixels =
    this->Doing == Mode::Decode && r.status == static_cast<std::uint32_t>(SliceStatus::Image);
  if (r.pixelBytes != (pixels ? std::uint64_t(r.rows) * r.columns * 2 : 0))
    this->ThrowGarbage("number of pixels");
}

SliceRecord DecoderProcess::NextRecord(const ProgressFunction& progress)
{
  SliceRecord record{};
  this->ReadAll(&record, sizeof(record), progress);
  this->Check(record);
  if (record.pixelBytes == 0)
    ++this->Next;
  return record;
}

void DecoderProcess::ReadPixels(
  const SliceRecord& record, void* into, const ProgressFunction& progress)
{
  this->ReadAll(into, record.pixelBytes, progress);
  ++this->Next;
}

void DecoderProcess::Finish(const ProgressFunction& progress)
{
  char more = 0;
  if (this->ReadSome(&more, 1, progress) != 0)
    this->ThrowGarbage("more than was asked for");
  // All answers have come and were checked; how it ends no longer matters, that it ends does.
  kill(this->Child, SIGKILL);
  this->Reap();
}

} // namespace hasp
