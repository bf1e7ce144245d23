#pragma once
#include "Devices/Drivers/Haply/HaplyMessages.h"
#include "Devices/Drivers/Haply/WebSocketClient.h"
#include "Devices/Drivers/HapticDriver.h"

namespace hasp
{

struct HaplySettings
{
  std::string address = "ws://localhost:10001"; ///< ParseWebSocketAddress says what is legal
  /// Whether the service may be on another machine. What goes there is neither secret nor signed:
  /// who sits between may move the device. A cable of your own, and nothing else, is the place.
  bool allowRemote = false;
  std::string deviceId; ///< which Inverse3; empty: the first that the service names
  bool grip = true;     ///< there is a VerseGrip: 6 axes of pose, of which it gives the turn
  /// The workspace's middle from the device's base, device axes; nominal, from a position that the
  /// maker's pages show. Not used where the service counts from the middle itself.
  glm::dvec3 centreMm{ 0.0, 150.0, 120.0 };
  WebSocketClient::Milliseconds opening{ 3000 }; ///< to connect and hear of the device: [10, 60000]
  WebSocketClient::Milliseconds answer{ 5 };     ///< to a force, until not fresh: [0, 20]
};

/// A Haply Inverse3 with a VerseGrip, through the Haply Inverse Service that its maker lets run on
/// the same machine: JSON over a WebSocket, HaplyMessages.h.
///
/// One exchange: the force goes out, and the service answers with one state. What came late of the
/// exchange before is dropped for the newer. 3 axes of force, so torques are dropped. The turn
/// stays as it was while the grip is not heard of, and is the identity before it ever was.
/// Unverified on a device: the whole protocol, which axes are which, the turn's zero, the middle of
/// the workspace, and the profile but for its peak force and workspace. That the service zeroes the
/// force when a connection is cut without a goodbye is not known: Close says zero while it can.
/// Threads: as HapticDriver. Cost: some 100 us an exchange beside the service's own time.
class HaplyDriver : public HapticDriver
{
public:
  static constexpr int MostWrong = 50;                       ///< messages in a row
  static constexpr std::int64_t MostSilenceNs = 500'000'000; ///< without any: the service hangs

  /// Throws DeviceError(Address) if the settings are not legal, or name another machine without
  /// allowRemote. Connects to nothing.
  explicit HaplyDriver(const HaplySettings& settings = {});
  ~HaplyDriver() override; ///< closes

  /// Name Inverse3. 10 N and 100 mm to each side are public figures; the rest is nominal, ours.
  const DeviceProfile& Profile() const noexcept override { return this->Device; }

  /// Throws DeviceError: Absent where no service answers or it has no such device, Protocol where
  /// what answers is none, says what cannot be, or turns its axes. Cancelled within some 20 ms.
  void Open(const DriverOpening& how) override;
  /// Waits 5 ms at most for the answer, as settings say, and 20 ms until the force is taken.
  /// Throws DeviceError: Gone, or Protocol after MostWrong messages that cannot be.
  DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) override;
  /// Says zero force and goodbye, and waits for the answer to that: 80 ms at most.
  void Close() noexcept override;
  std::string Advice() const override;

private:
  void Take(const HaplyState& state);
  void Judge(const std::string& text, std::int64_t nowNs);

  HaplySettings Settings;
  WebSocketAddress Address;
  DeviceProfile Device;
  WebSocketClient Service;
  std::string DeviceId; ///< of the open one
  bool Centred = false;
  bool GripHeard = false;
  DriverSample Last;
  int Wrong = 0;
  std::optional<std::int64_t> HeardNs; ///< when a message came, or the first exchange was
};

} // namespace hasp
