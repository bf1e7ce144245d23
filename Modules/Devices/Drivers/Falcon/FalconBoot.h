#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

class UsbTransport;

/// Time as a driver sees it, so that tests need not wait.
struct DeviceClock
{
  std::function<std::int64_t()> nowNs; ///< steady
  std::function<void(int ms)> sleep;
};
DeviceClock SteadyDeviceClock();

/// Where the file of firmware is looked for: `fromSettings`, or else what the environment says in
/// HASP_FALCON_FIRMWARE, or else hasp/falcon-firmware.bin below XDG_DATA_HOME. It is the user's
/// own: the maker's licence lets nobody pass it on, so Hasp has none. Empty if nothing says where.
std::filesystem::path FalconFirmwareFile(const std::string& fromSettings);

/// The file's bytes. Known images are of 7,324 to 8,492 bytes and begin with AA 08, the key of the
/// controller's boot loader; there is no other check, but that the device echoes each byte.
/// Throws DeviceError (Firmware): no file, not readable, no image. Says its name, not its folder.
std::vector<std::uint8_t> ReadFalconFirmware(const std::filesystem::path& file);

struct FalconBootSettings
{
  std::string firmware;        ///< path; empty: as FalconFirmwareFile
  int tries = 12;              ///< whole sequences, >= 1
  double timeBoxS = 20.0;      ///< no new try after it; > 0
  bool eventCharacter = false; ///< see FalconSettings
};

/// Makes an open Falcon answer packets: asks whether it does, for its firmware stays until the
/// power goes, and if not loads it. Loading is known to fail often, and to succeed when it is done
/// anew (libnifalcon's issues 24, 32, 45, 67): each try is the whole sequence, and the device is
/// closed and opened between two.
///
/// Sequence as libnifalcon's: purge, 16 ms latency, 9600 baud, 8N1, no flow control, RTS low, DTR
/// low, DTR high; 0A 43 0D until 0A 44 2C 0D comes back; DTR low, 143 kbaud, 'A' is echoed; the
/// image by 62 bytes, each echoed; then as in running: 1 ms latency, 1.5 Mbaud, purge.
/// Deviation: what was received is purged once more before 'A', so that no late answer to the
/// probes is taken for its echo.
///
/// Throws DeviceError: Firmware (only if it has to be loaded), Boot with the step of the last try,
/// and what `usb` throws as it is opened anew; Cancelled, also where it would have to be loaded and
/// `how` says not to. `usb` may be open or closed then.
/// Takes 10 ms if it runs already, else 1 s; no more than the time box and one try's 2 s.
void StartFalcon(UsbTransport& usb, const DeviceClock& clock, const FalconBootSettings& settings,
  const DriverOpening& how);

} // namespace hasp
