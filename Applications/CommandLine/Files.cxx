#include "Files.h"

#include "Failure.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace hasp
{
namespace
{

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

fs::path FolderOf(const std::string& path)
{
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// Beside the file and with its ending, which writers go by; the process number keeps two runs
/// apart.
std::string PendingName(const std::string& path)
{
  std::string name = ".pending-" + std::to_string(getpid());
  name.append("-").append(BaseName(path));
  return (FolderOf(path) / name).string();
}

Failure CannotWrite(const std::string& path, const std::string& reason)
{
  return Failure(
    ExitCode::WrongUse, "cannot write " + BaseName(path) + ": " + reason + "; nothing was written");
}

void RequireEnding(const std::string& path, const std::vector<std::string>& endings)
{
  if (endings.empty() ||
      std::find(endings.begin(), endings.end(), Lower(fs::path(path).extension())) != endings.end())
    return;
  std::string known;
  for (const std::string& ending : endings)
    known += (known.empty() ? "" : ", ") + ending;
  throw CannotWrite(path, "its name must end in " + known);
}

/// A file descriptor that closes itself, and removes its file unless told to keep it.
class NewFile
{
public:
  explicit NewFile(std::string path) : Path(std::move(path))
  {
    this->Descriptor = open(this->Path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (this->Descriptor < 0)
      throw std::system_error(errno, std::generic_category());
  }
  ~NewFile()
  {
    if (this->Descriptor >= 0)
      close(this->Descriptor);
    if (!this->Path.empty())
      unlink(this->Path.c_str());
  }
  NewFile(const NewFile&) = delete;
  void operator=(const NewFile&) = delete;

  void Write(std::string_view bytes)
  {
    while (!bytes.empty())
    {
      const ssize_t written = write(this->Descriptor, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR)
        throw std::system_error(errno, std::generic_category());
      bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
  }
  void RenameTo(const std::string& path)
  {
    if (fsync(this->Descriptor) != 0 || rename(this->Path.c_str(), path.c_str()) != 0)
      throw std::system_error(errno, std::generic_category());
    this->Path.clear();
  }

private:
  std::string Path;
  int Descriptor = -1;
};

} // namespace

std::string BaseName(const std::string& path)
{
  const fs::path p = fs::path(path).lexically_normal();
  return (p.has_filename() ? p : p.parent_path()).filename().string();
}

std::string WithoutFolders(std::string text, const std::vector<std::string>& paths)
{
  const auto remove = [&](const fs::path& folder)
  {
    const std::string prefix = folder.string() + "/";
    if (prefix.size() > 1)
      for (auto at = text.find(prefix); at != text.npos; at = text.find(prefix, at))
        text.erase(at, prefix.size());
  };
  for (const std::string& path : paths)
  {
    const fs::path given =
      fs::path(path).has_filename() ? fs::path(path) : fs::path(path).parent_path();
    std::error_code ignored; // an absolute form that cannot be made cannot be shown either
    remove(fs::absolute(given, ignored).lexically_normal().parent_path());
    remove(given.parent_path());
  }
  return text;
}

void RequireWritable(const std::string& path, const std::vector<std::string>& endings)
{
  RequireEnding(path, endings);
  std::error_code error;
  const fs::path folder = FolderOf(path);
  if (!fs::is_directory(folder, error))
    throw CannotWrite(path, "its folder does not exist; make it first");
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    throw CannotWrite(path, "a folder has this name; choose another");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw CannotWrite(path, "it is not a regular file; choose another name");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw CannotWrite(path, "its folder is not yours to write to; choose another");
}

void WriteFileAtomically(const std::string& path, std::string_view bytes)
{
  try
  {
    NewFile file(PendingName(path));
    file.Write(bytes);
    file.RenameTo(path);
  }
  catch (const std::system_error& error)
  {
    throw CannotWrite(path, error.code().message());
  }
}

PendingFile::PendingFile(const std::string& path) : Target(path), Pending(PendingName(path)) {}

PendingFile::~PendingFile()
{
  if (!this->Pending.empty())
    unlink(this->Pending.c_str());
}

void PendingFile::Keep()
{
  if (rename(this->Pending.c_str(), this->Target.c_str()) != 0)
    throw CannotWrite(this->Target, std::generic_category().message(errno));
  this->Pending.clear();
}

void RequireInput(const std::string& path)
{
  std::error_code error;
  const std::string name = BaseName(path);
  if (!fs::exists(path, error))
    throw Failure(ExitCode::BadInput, name + ": no such file or folder; check the path");
  if (fs::is_directory(path, error) && fs::is_empty(path, error))
    throw Failure(
      ExitCode::BadInput, name + ": the folder is empty; give the one that holds the slices");
}

} // namespace hasp
