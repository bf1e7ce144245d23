#pragma once
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

/// A folder of this test's own; what lies there goes with it.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "hasp-device-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("no temporary folder");
    this->Path = name;
  }
  ~TemporaryFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Path, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path File(const std::string& name, const std::vector<std::uint8_t>& bytes) const
  {
    const auto file = this->Path / name;
    std::ofstream(file, std::ios::binary)
      .write(
        reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
  }
  std::filesystem::path Path;
};

} // namespace hasp
