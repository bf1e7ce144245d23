#include "Files.h"

#include "Failure.h"
#include "vtkHaspOutputFile.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace hasp
{
namespace
{

struct LongestFirst
{
  bool operator()(const std::string& a, const std::string& b) const
  {
    return a.size() != b.size() ? a.size() > b.size() : a < b;
  }
};

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

fs::path WithoutLastSlash(const fs::path& path)
{
  return path.has_filename() ? path : path.parent_path();
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

} // namespace

std::string BaseName(const std::string& path)
{
  return WithoutLastSlash(fs::path(path).lexically_normal()).filename().string();
}

std::string WithoutFolders(std::string text, const std::vector<std::string>& words)
{
  std::set<std::string, LongestFirst> folders; // else /a/ takes its part of /a/b/ and b/ is shown
  for (const std::string& word : words)
    for (const std::string& path : { word, word.substr(word.find('=') + 1) }) // --output=here/x.png
    {
      const fs::path given = WithoutLastSlash(path);
      std::error_code ignored; // an absolute form that cannot be made cannot be shown either
      folders.insert(fs::absolute(given, ignored).lexically_normal().parent_path().string() + "/");
      folders.insert(given.parent_path().string() + "/");
    }
  folders.erase("/");
  folders.erase("//");
  for (const std::string& folder : folders)
    for (auto at = text.find(folder); at != text.npos; at = text.find(folder, at))
      text.erase(at, folder.size());
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

void WriteFile(const std::string& path, std::string_view bytes)
{
  try
  {
    WriteBytes(bytes, path);
  }
  catch (const std::runtime_error& error)
  {
    throw Failure(ExitCode::WrongUse, error.what());
  }
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
