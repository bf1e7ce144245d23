#include "Planning/DurableFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace hasp
{

namespace
{
[[noreturn]] void Fail(const std::string& what, int error)
{
  throw std::runtime_error(what + ": " + std::generic_category().message(error));
}

/// A file descriptor that is closed. Close() tells whether that went well.
class Descriptor
{
public:
  Descriptor(const std::filesystem::path& path, int flags) : Number(open(path.c_str(), flags, 0666))
  {
  }
  ~Descriptor() { this->Close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int Get() const { return this->Number; }
  bool Close()
  {
    const int number = this->Number;
    this->Number = -1;
    return number < 0 || close(number) == 0;
  }

private:
  int Number;
};

/// Errno of the step that failed, 0 if none did.
int WriteAll(Descriptor& file, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(file.Get(), bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
      return errno;
    bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return fsync(file.Get()) == 0 && file.Close() ? 0 : errno;
}

int SyncFolder(const std::filesystem::path& folder)
{
  Descriptor open(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Some network file systems cannot sync a folder and say EINVAL: no one can do better there.
  return open.Get() >= 0 && (fsync(open.Get()) == 0 || errno == EINVAL) ? 0 : errno;
}
} // namespace

void WriteDurably(
  const std::filesystem::path& path, std::string_view bytes, const std::string& subject)
{
  static std::atomic<unsigned> next{ 0 }; // a name of its own for each file that is being written
  const std::string cannot = subject + " cannot be written";
  for (;;)
  {
    const std::filesystem::path temporary =
      path.parent_path() /
      (std::string(TemporaryBegin) + std::to_string(getpid()) + "-" + std::to_string(next++));
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    if (file.Get() < 0 && errno == EEXIST) // of a program that had the same number and is no more
      continue;
    if (file.Get() < 0)
      Fail(cannot, errno);
    int error = WriteAll(file, bytes);
    if (error == 0 && rename(temporary.c_str(), path.c_str()) != 0)
      error = errno;
    if (error != 0)
    {
      unlink(temporary.c_str());
      Fail(cannot, error);
    }
    if (const int notSynced = SyncFolder(path.parent_path()); notSynced != 0)
      Fail(subject + " is in place, but may not outlast a power cut", notSynced);
    return;
  }
}

void MakeFolderDurably(const std::filesystem::path& folder, const std::string& subject)
{
  if (mkdir(folder.c_str(), 0777) != 0)
  {
    if (errno == EEXIST && std::filesystem::is_directory(folder))
      return;
    Fail(subject + " cannot be made", errno);
  }
  if (const int error = SyncFolder(folder.parent_path()); error != 0)
    Fail(subject + " is made, but may not outlast a power cut", error);
}

std::string ReadWhole(
  const std::filesystem::path& path, std::size_t most, const std::string& subject)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    throw std::runtime_error(subject + " is not there");
  if (!std::filesystem::is_regular_file(path, error))
    throw std::runtime_error(subject + " is not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    Fail(subject + " cannot be read", error.value());
  if (size > most)
    throw std::runtime_error(subject + " has " + std::to_string(size) + " bytes, at most " +
                             std::to_string(most) + " are read");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), std::streamsize(bytes.size())))
    throw std::runtime_error(subject + " cannot be read");
  return bytes;
}

} // namespace hasp
