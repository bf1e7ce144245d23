#include "Dicom/DecoderChild.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

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
void WriteList(int into, const std::vector<DicomSlice>& files)
{
  std::string list;
  for (const DicomSlice& slice : files)
    list.append(slice.file.native()).push_back('\0');
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
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
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

} // namespace

DecoderChild StartDecoder(const std::filesystem::path& program, const std::string& mode,
  const std::vector<DicomSlice>& files, std::uint64_t memoryBytes, long processorSeconds)
{
  const Descriptor list{ memfd_create("hasp-dicom-files", MFD_CLOEXEC) };
  if (list.number < 0)
    ThrowSystem("its list of files");
  WriteList(list.number, files);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    ThrowSystem("a pipe");
  Descriptor ours{ ends[0] };
  const Descriptor theirs{ ends[1] };
  const int child = Spawn(program,
    { "hasp-dicom-decode", mode, std::to_string(memoryBytes), std::to_string(processorSeconds) },
    list.number, theirs.number);
  return { child, std::exchange(ours.number, -1) };
}

} // namespace hasp
