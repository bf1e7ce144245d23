#pragma once
#include "Devices/Drivers/Testing/TemporaryFolder.h"
#include "FalconModel.h"

#include "Devices/Drivers/Falcon/FalconDriver.h"

#include <gtest/gtest.h>

namespace hasp
{

/// Whether a sentence has these words in it.
inline testing::AssertionResult Says(const std::string& sentence, const std::string& words)
{
  if (sentence.find(words) != std::string::npos)
    return testing::AssertionSuccess() << "it says: " << sentence;
  return testing::AssertionFailure() << "it says: " << sentence;
}

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
