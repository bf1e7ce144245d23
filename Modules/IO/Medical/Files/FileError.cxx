#include "Files/FileError.h"
#include "Files/Utf8.h"
#include "Files/Words.h"
#include "vtkHaspPrintableText.h"

#include <algorithm>
#include <atomic>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

std::atomic<bool> NamesShown{ false };

/// Endings that say what a file is. Any other could be a part of a name.
constexpr const char* KnownEndings[] = { ".dcm", ".hcells", ".html", ".inv3", ".json", ".mha",
  ".mhd", ".nhdr", ".nii", ".nii.gz", ".nrrd", ".obj", ".ply", ".png", ".seg.nrrd", ".stl", ".vti",
  ".vtp" };

/// Controls, and marks that end a line or turn the direction of writing.
bool Commands(char32_t c)
{
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C || c == 0x200E || c == 0x200F ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

} // namespace

/// A name is anybody's text, and terminals obey what they are sent: what commands them, or is no
/// UTF-8, becomes a question mark.
std::string PrintableText(const std::string& name)
{
  std::string text;
  for (std::size_t at = 0; at < name.size();)
  {
    char32_t character = 0;
    const std::size_t size = DecodeUtf8(name, at, character);
    text += size == 0 || Commands(character) ? "?" : name.substr(at, size);
    at += std::max<std::size_t>(size, 1);
  }
  return text;
}

void ShowFileNames(bool shown)
{
  NamesShown = shown;
}

bool FileNamesShown()
{
  return NamesShown;
}

std::string FileLabel(const std::filesystem::path& path)
{
  if (NamesShown)
  {
    const auto whole = path.lexically_normal();
    return PrintableText((whole.has_filename() ? whole : whole.parent_path()).filename().string());
  }
  const std::string ending = LowerExtension(path);
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return "the folder";
  if (std::find(std::begin(KnownEndings), std::end(KnownEndings), ending) != std::end(KnownEndings))
    return "the " + ending + " file";
  return "the file";
}

std::string LowerExtension(const std::filesystem::path& path)
{
  const std::string name = LowerCase(path.filename().string());
  for (const std::string two : { ".nii.gz", ".seg.nrrd" })
    if (name.size() > two.size() && name.ends_with(two))
      return two;
  return std::filesystem::path(name).extension().string();
}

void ThrowFileError(const std::filesystem::path& file, const std::string& what)
{
  throw std::runtime_error(FileLabel(file) + ": " + what);
}

std::string Text(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

} // namespace hasp
