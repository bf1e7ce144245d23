#pragma once
#include "Devices/Drivers/DeviceError.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseModels.h"

#include <cstddef>
#include <span>
#include <vector>

namespace hasp
{

/// How reports come from one HID device and go to it: hidapi, or a fake.
///
/// Threads: one at a time.
class HidTransport
{
public:
  HidTransport() = default;
  virtual ~HidTransport() = default;
  HidTransport(const HidTransport&) = delete;
  HidTransport& operator=(const HidTransport&) = delete;

  /// Finds a SpaceMouse, opens it, and says which it is. Throws DeviceError (Absent, Permission,
  /// Busy, Protocol), and leaves it closed.
  virtual HidCollection Open() = 0;

  /// One input report with its id, cut off where it does not fit; waits up to `timeoutMs`, 0: not.
  /// Gives its bytes, 0 where none came. Throws DeviceError (Gone).
  virtual std::size_t Read(std::span<std::byte> report, int timeoutMs) = 0;

  /// One output report with its id. Throws DeviceError (Gone).
  virtual void Write(std::span<const std::byte> report) = 0;

  /// Of the device that is open; empty where there is none to be had. Does not throw for that.
  virtual std::vector<std::byte> ReportDescriptor() = 0;

  /// Nothing if it is not open.
  virtual void Close() noexcept = 0;
};

} // namespace hasp
