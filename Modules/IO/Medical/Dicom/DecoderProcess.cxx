#include "Dicom/DecoderProcess.h"
#include "Volumes/VolumeFormat.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace hasp
{
namespace
{

/// Closes a file descriptor at the end of its scope.
struct Descriptor
{
  int number = -1;
  ~Descriptor()
  {
    if (this->number >= 0)
      close(this->number);
  }
};

[[noreturn]] void ThrowSystem(const std::string& what)
{
  throw std::runtime_error("the DICOM decoder cannot be started: " + what + ": " + strerror(errno));
}

/// The list of files lies in memory, not in a pipe: parent and child can then never wait for each
/// other, and no path touches the disk.
void WriteList(int into, const std::vector<std::filesystem::path>& files)
{
  std::string list;
  for (const auto& file : files)
    list.append(file.native()).push_back('\0');
  for (std::size_t done = 0; done < list.size();)
  {
    const ssize_t wrote = write(into, list.data() + done, list.size() - done);
    if (wrote < 0 && errno != EINTR)
      ThrowSystem("its list of files");
    done += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
  }
  if (lseek(into, 0, SEEK_SET) != 0)
    ThrowSystem("its list of files");
}

int Spawn(
  const std::filesystem::path& program, std::array<std::string, 4> words, int input, int output)
{
  char* arguments[] = { words[0].data(), words[1].data(), words[2].data(), words[3].data(),
    nullptr };
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = -1;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
  {
    errno = error;
    ThrowSystem(program.filename().string());
  }
  return child;
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
    Settings(settings),
    Started(Clock::now())
{
  const auto program = FindDecoder();
  const Descriptor list{ memfd_create("hasp-dicom-files", MFD_CLOEXEC) };
  if (list.number < 0)
    ThrowSystem("its list of files");
  WriteList(list.number, files);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    ThrowSystem("a pipe");
  this->Output = ends[0];
  const Descriptor childEnd{ ends[1] };
  try
  {
    this->Child = Spawn(program,
      { "hasp-dicom-decode", mode == Mode::Scan ? "scan" : "decode",
        std::to_string(settings.decoderMemoryBytes),
        std::to_string(static_cast<long>(std::ceil(settings.decoderTotalSeconds)) + 1) },
      list.number, childEnd.number);
  }
  catch (...)
  {
    close(this->Output); // no destructor runs for what was never made
    throw;
  }
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
  return this->Next < this->Files.size()
           ? " at " + (FileNamesShown() ? FileLabel(this->Files[this->Next])
                                        : "file " + std::to_string(this->Next + 1))
           : std::string();
}

std::size_t DecoderProcess::ReadSome(void* into, std::size_t size, const ProgressFunction& progress)
{
  const auto asked = Clock::now();
  for (;;)
  {
    ReportProgress(
      progress, double(this->Next) / double(std::max<std::size_t>(1, this->Files.size())));
    const auto since = [](Clock::time_point then)
    { return std::chrono::duration<double>(Clock::now() - then).count(); };
    const double silent = since(asked), total = since(this->Started);
    if (silent >= this->Settings.decoderSilenceSeconds ||
        total >= this->Settings.decoderTotalSeconds)
      throw std::runtime_error("the DICOM decoder hangs" + this->AtFile() + ": no end after " +
                               Text(std::round(10.0 * std::max(silent, total)) / 10.0) +
                               " s, so it was stopped. Take that file out of the folder, or raise "
                               "the decoder's time limit for a slow disk");
    const double left = std::min(
      this->Settings.decoderSilenceSeconds - silent, this->Settings.decoderTotalSeconds - total);
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
  if (WIFEXITED(status) && WEXITSTATUS(status) == 3)
    throw std::runtime_error("the DICOM decoder needs more memory than its " +
                             Text(double(this->Settings.decoderMemoryBytes) / (1 << 20)) + " MiB" +
                             at + remedy + ", or raise decoderMemoryBytes");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 5)
    throw std::runtime_error("DCMTK's dictionary of DICOM attributes is not installed (Debian: "
                             "libdcmtk17); without it DICOM cannot be read");
  if (WIFEXITED(status))
    throw std::runtime_error(
      "the DICOM decoder gave up with code " + std::to_string(WEXITSTATUS(status)) + at + remedy);
  throw std::runtime_error("the DICOM decoder crashed" + at + " (" +
                           (WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "unknown") + ")" +
                           remedy);
}

void DecoderProcess::ThrowGarbage(const std::string& what) const
{
  throw std::runtime_error("the DICOM decoder sent no valid answer" + this->AtFile() + " (" + what +
                           "); is HASP_DICOM_DECODER the hasp-dicom-decode of this build?");
}

void DecoderProcess::Check(const SliceRecord& r) const
{
  if (r.magic != SliceRecord::Magic || r.reserved != 0)
    this->ThrowGarbage("magic number");
  if (r.index != this->Next)
    this->ThrowGarbage("out of order");
  if (r.status > static_cast<std::uint32_t>(SliceStatus::Last) || (r.flags & ~AllFlags) != 0)
    this->ThrowGarbage("status");
  if (r.rows > 65535 || r.columns > 65535)
    this->ThrowGarbage("size");
  if (!Ended(r.modality, sizeof(r.modality)) || !Ended(r.photometric, sizeof(r.photometric)) ||
      !Ended(r.transferSyntax, sizeof(r.transferSyntax)) || !Ended(r.series, sizeof(r.series)) ||
      !Ended(r.frame, sizeof(r.frame)))
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
