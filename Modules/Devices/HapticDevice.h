#pragma once
#include "Grid/RigidPose.h"

#include <cstdint>
#include <limits>
#include <string>

/// Haptic devices as the HAPTIC thread uses them: once a tick Read, then Write.
///
/// Device axes: mm, origin in the middle of the workspace, x to the user's right, y up, z towards
/// the user; right-handed. The body is the stylus, grip or handle; a torque is about its origin.
/// WorkspaceMapping takes poses from there into the world and wrenches back.
namespace hasp
{

/// What a device can do, or is made to look like. Nominal figures: a driver fills in its own.
struct DeviceProfile
{
  std::string name = "generic";
  int poseAxes = 6;                     ///< 3 (position) or 6
  int forceAxes = 6;                    ///< 0 (input alone), 3 or 6
  int buttons = 2;                      ///< in [0, 32]
  glm::dvec3 workspaceMm{ 80, 60, 40 }; ///< half of its box, along x, y, z
  double peakForceN = 3.3;              ///< 0 where there is none
  double continuousForceN = 0.9;        ///< for minutes, without overheating
  double peakTorqueNmm = 180.0;         ///< 0 unless forceAxes is 6
  double continuousTorqueNmm = 60.0;
  double stiffnessNPerMm = 0.4;    ///< largest nominal one of its controller
  double dampingNsPerMm = 0.001;   ///< its own, felt in free space
  double movingMassKg = 0.1;       ///< with the hand on it, felt in free space
  double positionQuantumMm = 0.05; ///< an encoder's count, in the middle
  double angleQuantumRad = 0.001;
  int delayTicks = 1; ///< transport, at 1 kHz
};

// Devices of the kinds that are in use. From public sources: the largest forces, and the stiffness
// of the Falcon and the Touch. All else is nominal, ours, and to be replaced by what a device says.
DeviceProfile GenericProfile();
DeviceProfile FalconProfile();  ///< 3 axes of pose and force, 8.9 N
DeviceProfile TouchProfile();   ///< 6 axes of pose, 3 of force, 3.3 N
DeviceProfile PremiumProfile(); ///< 6 and 6, 22 N

/// Throws std::invalid_argument with the value and what is legal.
void ValidateDeviceProfile(const DeviceProfile& profile);

/// No more than the profile's peak: force and torque each shortened by length, so that directions
/// stay; torque is dropped where there is none, all of it where a number is not finite. HAPTIC.
Wrench ClampToProfile(const DeviceProfile& profile, const Wrench& wrench) noexcept;

/// How a device is, bit by bit; 0 is well. A device that is not well gets no force.
enum class DeviceStatus : std::uint32_t
{
  Ok = 0,
  Stale = 1,     ///< no new pose since the last Read; the one before came once more
  NotHomed = 2,  ///< where it is, is not known yet
  Unplugged = 4, ///< gone; it may come back
  Fault = 8,     ///< it says things that cannot be
  Ended = 16     ///< a recording is over
};
constexpr DeviceStatus operator|(DeviceStatus a, DeviceStatus b) noexcept
{
  return static_cast<DeviceStatus>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool Has(DeviceStatus status, DeviceStatus bits) noexcept
{
  return (static_cast<std::uint32_t>(status) & static_cast<std::uint32_t>(bits)) != 0;
}
/// Whether forces may go out: there, homed and sane. A stale pose alone may keep them, for as long
/// as GuardedHapticDevice allows.
constexpr bool TakesForce(DeviceStatus status) noexcept
{
  return !Has(status,
    DeviceStatus::NotHomed | DeviceStatus::Unplugged | DeviceStatus::Fault | DeviceStatus::Ended);
}

/// What a device said. A plain value.
struct DeviceSample
{
  std::int64_t timeNs = 0;   ///< when it was there, on the loop's clock
  RigidPose pose{};          ///< device axes; orientation the identity where poseAxes is 3
  std::uint32_t buttons = 0; ///< bit n: button n is held
};

/// From one time to another, ns. Any two will do, as a recording may say any: where they are
/// farther apart than 64 bits reach, as far as those do.
constexpr std::int64_t NsBetween(std::int64_t fromNs, std::int64_t toNs) noexcept
{
  using Limits = std::numeric_limits<std::int64_t>;
  if (fromNs < 0 && toNs > Limits::max() + fromNs)
    return Limits::max();
  if (fromNs > 0 && toNs < Limits::min() + fromNs)
    return Limits::min();
  return toNs - fromNs;
}

/// A device, whatever it is made of.
///
/// Time is passed in, as the loop has it (LoopTick::nowNs): a device without a clock of its own
/// runs in virtual time. Once a tick Read, then Write; a tick without Write leaves the force as it
/// is. Threads: HAPTIC alone between the loop's start and end, its owner before and after. Read and
/// Write take no memory, no lock, and do not throw.
class HapticDevice
{
public:
  HapticDevice() = default;
  virtual ~HapticDevice() = default;
  HapticDevice(const HapticDevice&) = delete;
  HapticDevice& operator=(const HapticDevice&) = delete;

  virtual const DeviceProfile& Profile() const noexcept = 0;

  /// The newest sample there is at `nowNs`. Where it is not Ok, `sample` is the last good one, or
  /// as it was passed in before the first.
  virtual DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept = 0;

  /// What the hand is to feel from now on: device axes, torque about the body's origin. Clamped as
  /// ClampToProfile. After anything but Ok or Stale the force is zero.
  virtual DeviceStatus Write(const Wrench& wrench) noexcept = 0;
};

} // namespace hasp
