#pragma once
#include "Waiting.h"

#include "Devices/Drivers/Falcon/LibusbTransport.h"
#include "Devices/Drivers/Testing/FalconBench.h"

namespace hasp::test
{

/// A driver over libusb, which reads invented firmware from a file.
class GuestFalconBench : public ::testing::Test
{
protected:
  /// Patient: an emulated processor on a busy machine is late, and that is not what is tested.
  FalconDriver Driver()
  {
    FalconSettings settings;
    settings.firmware = this->Folder.File("image.bin", InventedFirmware()).string();
    settings.answerMs = 18;
    settings.mostSilence = 2'000;
    settings.bootTries = 100;
    settings.bootTimeBoxS = 60.0;
    return FalconDriver(std::make_unique<LibusbTransport>(), settings);
  }
  /// Until an answer is fresh: one may be late.
  static DriverSample Fresh(FalconDriver& driver, const glm::dvec3& forceN = glm::dvec3(0.0))
  {
    for (;;) // 2,000 silences end it by DeviceError
      if (const auto sample = driver.Exchange({ forceN, {} }, 0); sample.fresh)
        return sample;
  }
  /// Prints what there was on the line; noise and misses are no failures here, their figures are
  /// worth a look.
  static void Report(const char* what, const FalconDriver& driver, double seconds)
  {
    const FalconCounts counts = driver.Counts();
    std::printf("guest: %s: %d commands, %d answers, %d silences, %d surplus in %.2f s\n", what,
      static_cast<int>(counts.commands), static_cast<int>(counts.answers),
      static_cast<int>(counts.silences), static_cast<int>(counts.surplus), seconds);
    EXPECT_EQ(counts.refused, 0u);
    EXPECT_EQ(counts.droppedBytes, 0u);
  }

  TemporaryFolder Folder;
};

inline double SecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace hasp::test
