#pragma once
#include "Devices/Drivers/SpaceMouse/HidTransport.h"

#include <string>
#include <vector>

struct hid_device_;

namespace hasp
{

/// A SpaceMouse through hidapi over Linux' hidraw.
///
/// hidapi before 0.14 gives no report descriptor: it is read where the kernel shows it.
/// Limit: a report that is written waits until the device has taken it, of a device that hangs for
/// the 5 s that Linux gives it.
/// Threads: one at a time; several transports on several threads are fine. hidapi begins with the
/// first that is open or opens, and ends with the last.
class HidapiTransport : public HidTransport
{
public:
  /// path  of the system's node ("/dev/hidraw3"); empty: the first that can be opened
  explicit HidapiTransport(std::string path = {});
  ~HidapiTransport() override;

  /// Throws DeviceError: Absent, Permission, Busy, Protocol (the node is no HID device).
  HidCollection Open() override;
  std::size_t Read(std::span<std::byte> report, int timeoutMs) override;
  void Write(std::span<const std::byte> report) override;
  std::vector<std::byte> ReportDescriptor() override;
  void Close() noexcept override;

private:
  std::string Path;     ///< that is wanted
  std::string OpenPath; ///< that is open
  hid_device_* Handle = nullptr;
};

} // namespace hasp
