#pragma once
#include "Devices/Drivers/Haply/HaplyDriver.h"
#include "HaplyServiceUnderTest.h"

#include <gtest/gtest.h>

/// What must come has a minute, so that a machine under load passes; nothing waits that long.
inline hasp::HaplySettings PatientSettings(const HaplyServiceUnderTest& service)
{
  hasp::HaplySettings settings;
  settings.address = service.Address();
  settings.opening = std::chrono::milliseconds(60'000);
  settings.answer = std::chrono::milliseconds(20);
  return settings;
}

/// The next sample that is new; the service answers each command, so it comes.
inline hasp::DriverSample NextFresh(hasp::HaplyDriver& driver, const hasp::Wrench& wrench = {})
{
  for (int n = 0; n < 3000; ++n) // 20 ms each
    if (const hasp::DriverSample sample = driver.Exchange(wrench, 0); sample.fresh)
      return sample;
  ADD_FAILURE() << "nothing new in a minute";
  return {};
}

/// What kind of DeviceError `use` throws, and that it says so.
template <typename Use>
void ExpectTrouble(hasp::DeviceTrouble trouble, const char* says, const Use& use)
{
  try
  {
    use();
    ADD_FAILURE() << "nothing was wrong; expected: " << says;
  }
  catch (const hasp::DeviceError& error)
  {
    EXPECT_EQ(error.trouble, trouble) << error.what();
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("049D"), std::string::npos) << error.what();
  }
}
