#pragma once
#include "Devices/Drivers/DeviceError.h"
#include "Devices/Drivers/Falcon/UsbTransport.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

constexpr std::uint16_t FalconVendor = 0x0403, FalconProduct = 0xcb48;

/// A Falcon on the bus, and whether this program may have it.
struct FoundFalcon
{
  std::string port;                     ///< bus and sockets, as the kernel names it: "1-2.3"
  std::optional<DeviceTrouble> trouble; ///< nothing: it can be opened
  std::string sentence;                 ///< what to do about the trouble
};

/// Those that are plugged in, by port. Tries to open each, and lets it go. None where the bus
/// cannot be asked. Throws nothing but std::bad_alloc. Any thread; takes some ms.
std::vector<FoundFalcon> FindFalcons();

/// UsbTransport over libusb: the first interface of a Falcon, whose kernel driver is put aside for
/// as long. Endpoints are those of the descriptor, the first bulk ones of each direction.
///
/// Each opening has a libusb context of its own, which ends with it: nothing stays behind, a device
/// that was plugged in since is found, and other users of libusb in the process are not met.
/// Threads: one at a time.
class LibusbTransport : public UsbTransport
{
public:
  /// `port` as FoundFalcon::port; empty: the first there is that can be opened.
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
