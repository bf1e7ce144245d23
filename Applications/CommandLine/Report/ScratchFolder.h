#pragma once
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace hasp
{

/// A folder of our own for what a report writes: no one else may look into it, two programs never
/// have the same one, and it is gone with all that is in it when this is. A program that is killed
/// leaves it. Throws std::runtime_error.
class ScratchFolder
{
public:
  ScratchFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "hasp-report-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw std::runtime_error("no temporary folder can be made to write files to");
    this->Place = pattern;
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Place, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& Path() const { return this->Place; }

private:
  std::filesystem::path Place;
};

} // namespace hasp
