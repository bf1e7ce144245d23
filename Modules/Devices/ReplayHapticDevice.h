#pragma once
#include "Devices/HapticRecording.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace hasp
{

/// What Write was called with, held against the recording.
struct ReplayDifferences
{
  std::uint64_t compared = 0;       ///< Writes
  std::uint64_t different = 0;      ///< whose bits differ in any number
  std::uint64_t firstDifferent = 0; ///< the tick's number, if there is one
  double mostForceN = 0.0;          ///< largest length of a difference; infinite for one not finite
  double mostTorqueNmm = 0.0;
};

/// A recording as a device: each Read gives the next tick's sample and status, to the last bit, and
/// each Write is compared with what was written then. Run with NextNs as the time, a deterministic
/// step gives the same wrenches again, in virtual time: a fault seen once is seen as often as it
/// takes. That is so with the same contact kernels (others sum in another order: WhyBitsDiffer) and
/// on a thread that flushes denormal numbers if the recorded one did (RealTimeScheduling).
///
/// Threads: as HapticDevice; NextNs and Differences on the same thread. Shares the recording.
class ReplayHapticDevice : public HapticDevice
{
public:
  /// Throws std::invalid_argument if there is no recording.
  explicit ReplayHapticDevice(std::shared_ptr<const HapticRecording> recording);

  const DeviceProfile& Profile() const noexcept override { return this->Is; }

  /// `nowNs` is not looked at. After the last tick: Ended, and `sample` stays as it is; what is
  /// written from then on is not compared.
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  DeviceStatus Write(const Wrench& wrench) noexcept override;

  /// What the next Read was called with when it was recorded; nothing after the last.
  std::optional<std::int64_t> NextNs() const noexcept;
  const ReplayDifferences& Differences() const noexcept { return this->Found; }

  void Rewind() noexcept;

private:
  std::shared_ptr<const HapticRecording> Recording;
  DeviceProfile Is;
  std::size_t Next = 0; ///< of the next Read
  bool Over = false;    ///< the last Read found none
  ReplayDifferences Found;
};

/// A sentence for who finds differences, where other contact kernels than `kernelsNow` ran when it
/// was recorded; empty where they are the same, or not said. Holds nothing of the recording's text.
std::string WhyBitsDiffer(const HapticRecording& recording, std::string_view kernelsNow);

} // namespace hasp
