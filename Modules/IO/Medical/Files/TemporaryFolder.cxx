#include "Files/TemporaryFolder.h"
#include "Files/FileError.h"
#include "vtkHaspOutputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

namespace hasp
{
namespace
{

/// "slices/" is the folder slices.
std::filesystem::path WithoutLastSlash(const std::filesystem::path& path)
{
  return path.has_filename() ? path : path.parent_path();
}

std::filesystem::path FolderOf(const std::filesystem::path& path)
{
  const auto folder = WithoutLastSlash(path).parent_path();
  return folder.empty() ? std::filesystem::path(".") : folder;
}

[[noreturn]] void ThrowSystem(const std::filesystem::path& target, const char* what)
{
  ThrowFileError(
    target, std::string(what) + ": " + strerror(errno) + ". What was there before is unchanged");
}

} // namespace

TemporaryFolder::TemporaryFolder(const std::filesystem::path& target)
{
  static std::atomic<unsigned> counter{ 0 };
  int made = 0;
  do
  {
    this->Path = FolderOf(target) /
                 (".hasp-" + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".part");
    this->Noted.emplace(this->Path); // before it is there: a signal may come in between
    made = mkdir(this->Path.c_str(), 0700);
  } while (made != 0 && errno == EEXIST);
  if (made != 0)
    ThrowSystem(target, "cannot be created");
}

TemporaryFolder::~TemporaryFolder()
{
  RemoveTree(this->Path.c_str());
}

bool SyncToDisk(const std::filesystem::path& name)
{
  const int opened = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0)
    return false;
  const bool synced = fsync(opened) == 0 || errno == EINVAL; // a file system that cannot
  const int reason = errno;
  close(opened);
  errno = reason;
  return synced;
}

void PutInPlace(const std::filesystem::path& from, const std::filesystem::path& target)
{
  const auto place = WithoutLastSlash(target);
  struct stat old
  {
  };
  if (stat(place.c_str(), &old) == 0 && S_ISREG(old.st_mode) &&
      chmod(from.c_str(), old.st_mode & 0777) != 0)
    ThrowSystem(target, "cannot be given the rights of the earlier file");
  if (rename(from.c_str(), place.c_str()) != 0)
  {
    if (errno == ENOTEMPTY || errno == EEXIST)
      ThrowFileError(
        target, "cannot be written: a folder is there that is not empty; name another");
    ThrowSystem(target, "cannot be put in place");
  }
  if (!SyncToDisk(FolderOf(place)))
    ThrowFileError(
      target, std::string("is written but may not survive a power cut: ") + strerror(errno));
}

void WriteInspected(const std::string& path,
  const std::function<void(const std::string& pendingName)>& write,
  const std::function<void(const std::string& pendingName)>& inspect)
{
  const auto target = std::filesystem::u8path(path);
  const TemporaryFolder stage(target);
  const auto pending = stage.Name() / ("out" + LowerExtension(WithoutLastSlash(target)));
  write(pending.string());
  inspect(pending.string());
  PutInPlace(pending, target);
}

} // namespace hasp
