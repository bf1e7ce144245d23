#pragma once
#include "Devices/Drivers/Falcon/FalconBoot.h"
#include "Devices/Drivers/Falcon/FalconPacket.h"
#include "Devices/Drivers/Falcon/UsbTransport.h"

#include <deque>
#include <memory>
#include <random>
#include <vector>

namespace hasp
{

/// A Falcon as it looks from its cable: an FTDI chip, the controller's boot loader behind it, and
/// once an image is complete the firmware that answers packets, with arms, encoders and motors.
/// Written from the facts of the protocol; the image that it takes is any.
///
/// Time is `nowNs`, and stands still but for who moves it.
class FalconModel
{
public:
  /// What can be wrong with it.
  struct Faults
  {
    bool silent = false;       ///< sends nothing
    bool noModemLines = false; ///< refuses that request
    bool deadFirmware = false; ///< takes the image and does not run
    int wrongEchoAt = -1;      ///< this byte of the image comes back wrong,
    int wrongEchoes = 0;       ///< so many times
    std::int64_t delayNs = 0;  ///< of answers to packets
    /// Of the answers to packets, the share in [0, 1] that is ..., drawn one after the other.
    double lost = 0.0, cut = 0.0, shifted = 0.0, noise = 0.0;
    double repeated = 0.0; ///< twice at once, and once more 0.3 ms later
  };
  Faults faults;
  std::int64_t nowNs = 0;

  explicit FalconModel(std::vector<std::uint8_t> image);

  // The hand and the power.
  void MoveTo(const glm::dvec3& positionMm); ///< within reach
  void Press(std::uint8_t buttons) { this->Buttons = buttons; }
  /// All the way out and all the way in: with the homing bit set, encoders find their zeros.
  void PullOutAndPushIn();
  void SwitchOffAndOn(); ///< loses the firmware and the zeros
  void StartRunning();   ///< as if the image were loaded
  void SetCounts(const std::array<int, 3>& counts) { this->Counts = counts; } ///< whatever they say

  bool Runs() const { return this->State == Mode::Running; }
  const FalconCommand& Told() const { return this->Last; } ///< the last packet
  std::uint64_t Packets() const { return this->PacketNumber; }
  bool PushesNobody() const { return this->Last.motors == std::array<int, 3>{}; }
  /// What the motors do to the grip, N, if `countsPerNm` is how strong they are.
  glm::dvec3 ForceN(double countsPerNm) const;

  // The chip.
  bool Control(std::uint8_t request, std::uint16_t value); ///< false: refused
  void Receive(std::span<const std::uint8_t> bytes);
  bool HasAnswer() const;
  int LatencyMs() const { return this->Latency; }
  /// One transfer to the host, with the status bytes; two bytes if there is nothing.
  std::size_t Send(std::span<std::uint8_t> bytes);

private:
  enum class Mode
  {
    Off, ///< until DTR rises
    Asked,
    Loading,
    Dead,
    Running
  };
  void TakeBootByte(std::uint8_t byte);
  void TakePacketByte(std::uint8_t byte);
  void Obey(const FalconCommand& command);
  void Queue(std::uint8_t byte, std::int64_t dueNs);
  bool Happens(double share);

  std::vector<std::uint8_t> Image;
  Mode State = Mode::Off;
  std::size_t Loaded = 0;
  std::vector<std::uint8_t> Heard; ///< by the boot loader
  int Baud = 0, Latency = 16;
  bool Dtr = false;
  struct Byte
  {
    std::uint8_t value;
    std::int64_t dueNs;
  };
  std::deque<Byte> Outbox;
  std::vector<std::uint8_t> Command; ///< as far as it is there
  FalconCommand Last;
  std::uint64_t PacketNumber = 0;
  std::int64_t LastAnswerNs = 0;

  glm::dvec3 PositionMm{ 0.0 };
  std::array<int, 3> Counts{}, ZeroOffset{ 321, -77, 1234 };
  std::uint8_t Buttons = 0, Homed = 0;
  std::mt19937 Random{ 7 };
};

/// The cable in one process: UsbTransport on a model, which it moves through time. Outlives
/// drivers.
struct FalconCable
{
  std::shared_ptr<FalconModel> model;
  bool plugged = true;
  bool open = false;
  int calls = 0;                        ///< since construction, but for Close
  int unplugAt = -1;                    ///< that call finds it unplugged
  std::optional<DeviceTrouble> refuses; ///< what Open throws

  DeviceClock Clock();
};
std::unique_ptr<UsbTransport> PlugInto(std::shared_ptr<FalconCable> cable);

/// Invented bytes of a size that images have, with the boot loader's key in front.
std::vector<std::uint8_t> InventedFirmware(std::size_t size = 7'914);

} // namespace hasp
