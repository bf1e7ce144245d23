// hasp-device-guard: waits beside a program that uses a haptic device, and takes the force away if
// that program ends while the device is open. CrashGuard.h.
//
//   hasp-device-guard ADDRESS      settings, a 0, and words on standard input
//
// Exit code: 0 done, or nothing was to be done; 1 the device could not be had; 2 wrong use.
#include "Devices/Drivers/CrashGuard.h"
#include "Devices/Drivers/DeviceList.h"

#include <unistd.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fputs("usage: hasp-device-guard ADDRESS, words on standard input\n", stderr);
    return 2;
  }
  try
  {
    const auto text = hasp::ReadGuardedSettings(STDIN_FILENO);
    if (!text)
      return 0; // it ended before it had a device
    const auto settings = text->empty() ? hasp::DeviceSettings() : hasp::ParseDeviceSettings(*text);
    const auto driver = hasp::MakeDriver(argv[1], settings);
    return hasp::GuardDevice(STDIN_FILENO, *driver);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "hasp-device-guard: %s\n", error.what());
    return 2;
  }
}
