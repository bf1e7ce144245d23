#include "Files/AtomicFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspOutputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <sstream>

namespace hasp
{
namespace
{

std::filesystem::path FolderOf(const std::filesystem::path& file)
{
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& file, std::string_view ending) : Target(file)
{
  if (file.filename().empty())
    ThrowFileError(file, "cannot be written: no file name is given");
  if (std::error_code error; std::filesystem::is_directory(file, error))
    ThrowFileError(file, "cannot be written: it is a folder");
  // Not mkstemp: a file made by open has the rights that the umask leaves, as any new file.
  static std::atomic<unsigned> counter{ 0 };
  std::filesystem::path name;
  do
  {
    std::ostringstream unique;
    unique << ".hasp-" << getpid() << '-' << counter++ << ending; // names may name a patient
    name = FolderOf(file) / unique.str();
    this->Noted.emplace(name); // before it is there: a signal may come in between
    this->Descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (this->Descriptor < 0 && errno == EEXIST);
  if (this->Descriptor < 0)
    this->Throw("cannot be created");
  this->Temporary = name;
}

AtomicFile::~AtomicFile()
{
  if (this->Descriptor >= 0)
    close(this->Descriptor);
  if (!this->Temporary.empty())
    unlink(this->Temporary.c_str());
}

void AtomicFile::Throw(const char* what) const
{
  ThrowFileError(this->Target,
    std::string(what) + ": " + strerror(errno) + ". The earlier file, if any, is unchanged");
}

void AtomicFile::Write(const void* bytes, std::size_t size)
{
  const auto* from = static_cast<const char*>(bytes);
  while (size > 0)
  {
    const ssize_t wrote = write(this->Descriptor, from, size);
    if (wrote < 0 && errno != EINTR)
      this->Throw("cannot be written");
    from += wrote > 0 ? wrote : 0;
    size -= wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
  }
}

void AtomicFile::Commit()
{
  struct stat old
  {
  };
  const bool replaces = stat(this->Target.c_str(), &old) == 0;
  if ((replaces && fchmod(this->Descriptor, old.st_mode & 0777) != 0) ||
      fsync(this->Descriptor) != 0)
    this->Throw("cannot be written");
  const int written = this->Descriptor;
  this->Descriptor = -1;
  if (close(written) != 0)
    this->Throw("cannot be written");
  if (rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
    this->Throw("cannot be put in place");
  this->Temporary.clear();
  this->Noted.reset();
  // The name itself reaches the disk with its folder. File systems that cannot do that say so by
  // EINVAL; the file is in place then all the same.
  const int folder = open(FolderOf(this->Target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0)
  {
    const bool failed = fsync(folder) != 0 && errno != EINVAL;
    const int reason = errno;
    close(folder);
    errno = reason;
    if (failed)
      this->Throw("is written but may not survive a power cut");
  }
}

void WriteBytes(std::string_view bytes, const std::string& path)
{
  AtomicFile output(std::filesystem::u8path(path));
  output.Write(bytes.data(), bytes.size());
  output.Commit();
}

} // namespace hasp
