#include "Files.h"

#include "Failure.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#if HASP_WITH_OPENSSL
#include "Planning/Sha256.h"
#endif

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
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

/// Why no file can be made in a folder, as only trying tells: of some folders the system says that
/// they can be written to, and refuses it then. Empty: one can. Nothing is left: the file has a
/// name only where the file system cannot do without, for a moment.
std::string WhyNotIn(const fs::path& folder)
{
  int file = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0 && (errno == EOPNOTSUPP || errno == EISDIR))
  {
    std::string name = (folder / ".hasp-XXXXXX").string();
    file = mkstemp(name.data());
    if (file >= 0)
      unlink(name.c_str());
  }
  if (file < 0)
    return std::generic_category().message(errno);
  close(file);
  return {};
}

Failure CannotWrite(const std::string& path, const std::string& reason)
{
  return Failure(ExitCode::WrongUse,
    "cannot write " + FileLabel(path) + ": " + reason + "; nothing was written");
}

void RequireEnding(const std::string& path, const std::vector<std::string>& endings)
{
  const std::string name = Lower(fs::path(path).filename()); // .nii.gz is one ending
  if (name.ends_with(".3mf"))
    RequireThreeMf();
  if (endings.empty() || std::any_of(endings.begin(), endings.end(),
                           [&](const std::string& ending) { return name.ends_with(ending); }))
    return;
  std::string known;
  for (const std::string& ending : endings)
    known += (known.empty() ? "" : ", ") + ending;
  throw CannotWrite(path, "its name must end in " + known);
}

} // namespace

void RequireThreeMf()
{
#if !HASP_WITH_LIB3MF
  throw Failure(ExitCode::WrongUse,
    "3mf is written by builds with HASP_ENABLE_LIB3MF=ON (Debian: lib3mf-dev); choose stl, ply or "
    "obj: nothing was written");
#endif
}

std::string SafeText(const std::exception& error)
{
  if (const auto* system = dynamic_cast<const std::system_error*>(&error)) // holds paths
    return "the system refuses: " + system->code().message();
  if (dynamic_cast<const nlohmann::json::exception*>(&error)) // quotes the file
    return "no valid JSON";
  return error.what();
}

std::string WithoutFunctionNames(const std::string& text)
{
  static const std::regex name("\\b[A-Z]\\w*[a-z][A-Z]\\w*(::\\w+)?: ");
  return std::regex_replace(text, name, "");
}

void RequireWritable(const std::string& path, const std::vector<std::string>& endings)
{
  RequireEnding(path, endings);
  std::error_code error;
  const fs::path folder = FolderOf(path);
  const fs::file_type place = fs::status(folder, error).type();
  if (place == fs::file_type::none)
    throw CannotWrite(path, "its folder cannot be reached: " + error.message());
  if (place != fs::file_type::directory)
    throw CannotWrite(path, "its folder does not exist; make it first");
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none)
    throw CannotWrite(path, error.message() + "; choose another name");
  if (fs::is_directory(status))
    throw CannotWrite(path, "a folder has this name; choose another");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw CannotWrite(path, "it is not a regular file; choose another name");
  if (const std::string why = WhyNotIn(folder); !why.empty())
    throw CannotWrite(path, "its folder takes no file: " + why + "; choose another");
}

void RequireDifferent(const std::string& path, const std::string& other, const std::string& options)
{
  const auto plain = [](const std::string& name)
  {
    std::error_code unknown; // then the name is compared as it is
    const fs::path found = fs::weakly_canonical(fs::absolute(name, unknown), unknown);
    return found.empty() ? fs::path(name) : found;
  };
  std::error_code missing; // one that is not there is no other's hard link
  if (plain(path) == plain(other) || fs::equivalent(path, other, missing))
    throw Failure(
      ExitCode::WrongUse, options + " are one file; give two names: nothing was written");
}

void RequireWritableFolder(const std::string& path, const std::string& called)
{
  const fs::path given(path), place = given.has_filename() ? given : given.parent_path();
  const auto refuse = [&](const std::string& reason)
  {
    throw Failure(
      ExitCode::WrongUse, "cannot write " + called + ": " + reason + "; nothing was written");
  };
  std::error_code error;
  const fs::path parent = FolderOf(place.string());
  if (!fs::is_directory(parent, error))
    refuse("the folder it is to lie in does not exist; make it first");
  const bool there = fs::exists(place, error);
  if (there && !fs::is_directory(place, error))
    refuse("a file has this name; choose another");
  if (there && !fs::is_empty(place, error))
    refuse("a folder that is not empty has this name; choose another");
  if (const std::string why = WhyNotIn(parent); !why.empty())
    refuse("the folder it is to lie in takes no file: " + why + "; choose another");
}

void WriteFile(const std::string& path, std::string_view bytes)
{
  try
  {
    WriteBytes(bytes, path);
  }
  catch (const std::runtime_error& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
}

std::string HashOfFile([[maybe_unused]] const std::string& path)
{
#if HASP_WITH_OPENSSL
  if (path.empty())
    return {};
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  return file ? Sha256(bytes) : std::string();
#else
  return {};
#endif
}

std::string FreeName(const std::string& stem, const std::string& ending)
{
  std::error_code ignored;
  std::string name;
  int n = 0;
  do
    name = stem + "-" + std::to_string(++n) + ending;
  while (std::filesystem::exists(name, ignored)); // writing says what is wrong with the folder
  return name;
}

void RequireInput(const std::string& path)
{
  std::error_code error;
  const std::string name = FileLabel(path);
  if (!fs::exists(path, error))
    throw Failure(ExitCode::BadInput, name + ": no such file or folder; check the path");
  if (fs::is_directory(path, error) && fs::is_empty(path, error))
    throw Failure(
      ExitCode::BadInput, name + ": it is empty; give the folder that holds the slices");
}

} // namespace hasp
