#pragma once
#include "Devices/Drivers/Falcon/UsbTransport.h"

#include <memory>
#include <string>

namespace hasp
{

constexpr std::uint16_t FalconVendor = 0x0403, FalconProduct = 0xcb48;

/// UsbTransport over libusb: the first interface of a Falcon, whose kernel driver is put aside for
/// as long. Endpoints are those of the descriptor, the first bulk ones of each direction.
///
/// Each opening has a libusb context of its own, which ends with it: nothing stays behind, a device
/// that was plugged in since is found, and other users of libusb in the process are not met.
/// Threads: one at a time.
class LibusbTransport : public UsbTransport
{
public:
  /// `port` as the kernel names it, bus and sockets, "1-2.3"; empty: the first there is that can be
  /// opened.
  explicit LibusbTransport(std::string port = {});
  ~LibusbTransport() override;

  void Open() override;
  void Close() noexcept override;
  void Control(std::uint8_t request, std::uint16_t value) override;
  std::size_t Read(std::span<std::uint8_t> bytes, int timeoutMs) override;
  std::size_t Write(std::span<const std::uint8_t> bytes, int timeoutMs) override;

private:
  class Session;

  Session& Opened() const;

  std::string Port;
  std::unique_ptr<Session> Device;
};

} // namespace hasp
