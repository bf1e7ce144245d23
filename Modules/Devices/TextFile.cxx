#include "Devices/TextFile.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hasp
{

namespace
{
[[noreturn]] void Fail(const char* what, const std::string& why)
{
  throw std::runtime_error(std::string(what) + ": " + why);
}
} // namespace

std::string ReadTextFile(const std::string& name, std::size_t mostBytes, const char* what)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error))
    Fail(what, "there is no such file");
  const std::uintmax_t bytes = std::filesystem::file_size(name, error);
  if (error)
    Fail(what, "the file cannot be read");
  if (bytes > mostBytes)
    Fail(what,
      "the file has " + std::to_string(bytes) + " bytes, at most " + std::to_string(mostBytes));
  std::ifstream file(name, std::ios::binary);
  std::string text(bytes, '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(bytes)))
    Fail(what, "the file cannot be read");
  return text;
}

void WriteTextFile(const std::string& name, const std::string& text, const char* what)
{
  // The name says nothing of the file, should it be left behind: Utilities/Docs/Privacy.md.
  static std::atomic<unsigned> number{ 0 };
  const std::filesystem::path temporary =
    std::filesystem::path(name).parent_path() /
    (".hasp-" + std::to_string(getpid()) + "-pose" + std::to_string(++number));
  std::error_code error, ignored;
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    if (!file.flush())
    {
      file.close();
      std::filesystem::remove(temporary, ignored);
      Fail(what, "the file cannot be written");
    }
  }
  std::filesystem::rename(temporary, name, error);
  if (error)
  {
    std::filesystem::remove(temporary, ignored);
    Fail(what, "the file cannot be put in place: " + error.message());
  }
}

} // namespace hasp
