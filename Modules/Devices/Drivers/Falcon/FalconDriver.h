#pragma once
#include "Devices/Drivers/Falcon/FalconBoot.h"
#include "Devices/Drivers/Falcon/FalconPacket.h"

#include <glm/mat3x3.hpp>

#include <atomic>
#include <memory>
#include <optional>

namespace hasp
{

struct FalconSettings
{
  /// Path of the firmware's file; empty: as FalconFirmwareFile (FalconBoot.h).
  std::string firmware{};
  /// Motor numbers for one newton metre at an arm, in (0, 100,000]. The true scale is NOT public.
  /// libnifalcon sends 10,000, and nobody wrote down a force that was measured. Half of that, so
  /// that what is felt is rather less than what is said: at 5,000 1 N along z is 126 a motor, and
  /// 8.9 N in any direction about the middle stay below 4095. Measure yours with a spring scale.
  double countsPerNm = 5'000.0;
  /// The ring's colours: red not homed, green homed, and blue with force on.
  bool lights = true;
  /// Has the FTDI chip send at each '>' instead of waiting for its timer: up to 1 ms less delay by
  /// the chip's data sheet (FTDI AN232B-04). Not tried on a device, so it is off.
  bool eventCharacter = false;
  int answerMs = 10; ///< waits so long for an answer, in [1, 18]
  /// So many exchanges without an answer, one after the other, are a DeviceError; >= 1.
  int mostSilence = 50;
  int bootTries = 12;         ///< FalconBootSettings, >= 1
  double bootTimeBoxS = 20.0; ///< > 0
};

/// What there was on the line since construction.
struct FalconCounts
{
  std::uint64_t commands = 0;     ///< packets sent whole
  std::uint64_t answers = 0;      ///< packets received
  std::uint64_t silences = 0;     ///< exchanges without an answer
  std::uint64_t surplus = 0;      ///< answers that no command was waiting for
  std::uint64_t resyncs = 0;      ///< times that the start of a packet had to be looked for
  std::uint64_t droppedBytes = 0; ///< that belonged to no packet
  std::uint64_t refused = 0;      ///< answers whose counts no pose has
};

/// Novint Falcon: three axes of position and of force, four buttons (bit 0 right, 1 front, 2
/// centre, 3 left).
///
/// Force: motors = -countsPerNm J^T F, J at the pose that was read last. The minus is
/// libnifalcon's: positive numbers pull the grip in. Motors are zero until the zeros of all three
/// encoders are found, as long as no pose is known, and for a wrench that is not finite; a torque
/// is dropped, the device has none.
///
/// One command gets one answer. Commands that were not answered are kept count of, so that a late
/// answer is not taken for that of the next; after anything odd the line is first emptied. So an
/// answer that is lost for good costs two samples that are not fresh, each after answerMs.
///
/// Throws as HapticDriver; std::invalid_argument if a setting is out of its range or there is no
/// transport. Threads: as HapticDriver; Counts any. Exchange waits for the bus (1 ms as a rule) and
/// costs 2 us beside.
/// Limits: no part of this was tried on a device. One answer too many that comes by itself between
/// two exchanges is not seen as such; poses are one exchange old then, until something odd is seen.
class FalconDriver : public HapticDriver
{
public:
  explicit FalconDriver(std::unique_ptr<UsbTransport> usb, const FalconSettings& settings = {},
    DeviceClock clock = SteadyDeviceClock());
  ~FalconDriver() override;

  const DeviceProfile& Profile() const noexcept override { return this->Shape; }
  void Open(const DriverOpening& how) override;
  DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) override;
  void Close() noexcept override;
  std::string Advice() const override;

  FalconCounts Counts() const noexcept;

private:
  struct Line; ///< of an open device

  FalconCommand CommandFor(const glm::dvec3& forceN) const noexcept;
  std::optional<FalconAnswer> Ask(const FalconCommand& command);
  bool Hear(std::span<std::uint8_t> payload, std::optional<FalconAnswer>& newest);
  void UpdatePose(const FalconAnswer& answer);

  enum Count
  {
    Commands,
    Answers,
    Silences,
    Surplus,
    Resyncs,
    Dropped,
    Refused,
    CountNumber
  };
  void Add(Count which, std::uint64_t more = 1) noexcept;

  std::unique_ptr<UsbTransport> Usb;
  FalconSettings Settings;
  DeviceClock Clock;
  DeviceProfile Shape;
  std::unique_ptr<Line> Opened;
  DriverSample Sample;                ///< the last one
  std::optional<glm::dmat3> Jacobian; ///< there is a pose, and it takes force
  std::array<std::atomic<std::uint64_t>, CountNumber> Counted{};
};

} // namespace hasp
