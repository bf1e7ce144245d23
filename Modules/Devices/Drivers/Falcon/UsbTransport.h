#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace hasp
{

/// The three things that the driver of a USB device asks of the bus: what libusb is behind, and
/// what tests put a model behind.
///
/// Errors: each throws DeviceError where there is no going on, Gone if the device is.
/// Threads: one at a time.
class UsbTransport
{
public:
  UsbTransport() = default;
  virtual ~UsbTransport() = default;
  UsbTransport(const UsbTransport&) = delete;
  UsbTransport& operator=(const UsbTransport&) = delete;

  /// Closes first if it is open. Throws DeviceError: Absent, Permission, Busy, Gone.
  virtual void Open() = 0;
  /// Any number of times.
  virtual void Close() noexcept = 0;

  /// A vendor request to the device, without data. Throws DeviceError: Gone, or Protocol where the
  /// device refuses the request.
  virtual void Control(std::uint8_t request, std::uint16_t value) = 0;

  /// One transfer from the device, as it comes: an FTDI chip's status bytes are in it. Into at most
  /// `bytes`, a multiple of 64. Waits up to `timeoutMs` (> 0); 0 if nothing came.
  virtual std::size_t Read(std::span<std::uint8_t> bytes, int timeoutMs) = 0;

  /// How many bytes the device took within `timeoutMs` (> 0).
  virtual std::size_t Write(std::span<const std::uint8_t> bytes, int timeoutMs) = 0;
};

} // namespace hasp
