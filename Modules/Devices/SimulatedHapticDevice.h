#pragma once
#include "Devices/HandModel.h"
#include "Devices/HapticDevice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

// Times in s since the hand's beginning: the first Read.
struct SimulatedButtons
{
  double fromS = 0.0; ///< these are held until the next entry
  std::uint32_t held = 0;
};
struct SimulatedOutage
{
  double fromS = 0.0, toS = 0.0; ///< unplugged
};

struct SimulatedDeviceSettings
{
  /// The device, and with its movingMassKg and dampingNsPerMm the body that the hand moves.
  DeviceProfile profile = TouchProfile();
  ///@{
  /// What a profile does not say of that body, as in HandBody.
  glm::dvec3 inertiaKgMm2{ 100.0 };
  double turnViscousNmmSPerRad = 0.5;
  double coulombN = 0.0, turnCoulombNmm = 0.0;
  ///@}
  HandGrip grip = LooseGrip();
  std::vector<SimulatedButtons> buttons{}; ///< times increase
  std::vector<SimulatedOutage> outages{};
};

/// A haptic device with a hand on it, in virtual time: HandModel, seen through encoders and a
/// cable. What is read is rounded to the encoders' counts and delayTicks Reads old; what is written
/// is clamped and acts at once, until the next Write. (All of the delay is on the way in: where it
/// lies in the loop makes no difference to its stability.) While unplugged the hand goes on and
/// feels nothing; a wrench written before that is gone.
///
/// The hand's time begins at the first Read, whatever the clock says then (CLOCK_MONOTONIC: the
/// machine's uptime). Where the loop paused, no more than LongestReadNs of the pause go by for the
/// hand: it waits for the rest, so that a Read after a pause costs no more than that.
/// Deterministic: the same Reads and Writes at the same times since the first Read give the same
/// bits.
/// Limit: the workspace's end is no wall.
/// Threads: as HapticDevice. Cost: that of HandModel; 1.5 ms the longest Read.
class SimulatedHapticDevice : public HapticDevice
{
public:
  static constexpr std::int64_t LongestReadNs = 100'000'000;

  /// Throws std::invalid_argument as HandModel and ValidateDeviceProfile do, and if times of
  /// buttons or outages are not finite or not in order.
  SimulatedHapticDevice(const SimulatedDeviceSettings& settings, HandIntention intention);

  const DeviceProfile& Profile() const noexcept override { return this->Settings.profile; }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  DeviceStatus Write(const Wrench& wrench) noexcept override;

  /// The truth behind the encoders, on the hand's own time.
  const HandModel& Hand() const noexcept { return this->Model; }
  HandModel& Hand() noexcept { return this->Model; }
  /// What acts on the hand now.
  const Wrench& Applied() const noexcept { return this->Acting; }

private:
  bool PluggedAt(double timeS) const noexcept;
  std::uint32_t ButtonsAt(double timeS) const noexcept;
  DeviceSample Measure() const noexcept;

  SimulatedDeviceSettings Settings;
  HandModel Model;
  Wrench Acting;
  bool Plugged = true, Began = false;
  std::int64_t ReadNs = 0;            ///< of the newest Read
  std::array<DeviceSample, 17> Cable; ///< the last delayTicks + 1 samples, a ring
  std::size_t Sent = 0;               ///< samples that went in
};

} // namespace hasp
