#pragma once
#include "FalconModel.h"

#include "Devices/Drivers/Falcon/FalconDriver.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hasp
{

/// Whether a sentence has these words in it.
inline testing::AssertionResult Says(const std::string& sentence, const std::string& words)
{
  if (sentence.find(words) != std::string::npos)
    return testing::AssertionSuccess() << "it says: " << sentence;
  return testing::AssertionFailure() << "it says: " << sentence;
}

/// A folder of this test's own; what lies there goes with it.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "hasp-falcon-XXXXXX").string();
    if (!mkdtemp(name.data()))
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

/// A model, its cable, and a driver of it that reads invented firmware from a file.
struct FalconBench
{
  TemporaryFolder folder;
  std::shared_ptr<FalconModel> model = std::make_shared<FalconModel>(InventedFirmware());
  std::shared_ptr<FalconCable> cable = std::make_shared<FalconCable>();
  FalconSettings settings;
  DriverOpening how;

  FalconBench()
  {
    this->cable->model = this->model;
    this->settings.firmware = this->folder.File("image.bin", InventedFirmware()).string();
  }
  FalconDriver Driver()
  {
    return FalconDriver(PlugInto(this->cable), this->settings, this->cable->Clock());
  }
};

} // namespace hasp
