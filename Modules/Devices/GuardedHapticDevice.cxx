#include "Devices/GuardedHapticDevice.h"

#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double UnitWithin = 1e-3; // what a driver's own rounding may leave

bool IsPose(const RigidPose& pose) noexcept
{
  return IsFinite(pose) && std::abs(glm::length(pose.orientation) - 1.0) <= UnitWithin;
}

ForceNumbers Numbers(const Wrench& w) noexcept
{
  return { w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z };
}
} // namespace

GuardedHapticDevice::GuardedHapticDevice(
  std::unique_ptr<HapticDevice> device, const WatchdogSettings& settings)
  : Device(std::move(device)),
    Dog(settings)
{
  if (!this->Device)
    throw std::invalid_argument("haptic device: there is none to guard");
}

GuardedHapticDevice::~GuardedHapticDevice()
{
  this->Device->Write({});
}

DeviceStatus GuardedHapticDevice::Read(std::int64_t nowNs, DeviceSample& sample) noexcept
{
  DeviceSample read = this->Good;
  this->Status = this->Device->Read(nowNs, read);
  this->NowNs = nowNs;
  if (!this->AnyGood || !Has(this->Status, DeviceStatus::Stale))
    this->PoseNs = nowNs;
  if (!IsPose(read.pose))
  {
    this->Status = this->Status | DeviceStatus::Fault;
    ++this->BadPoses;
  }
  else if (TakesForce(this->Status))
  {
    this->Good = read;
    this->AnyGood = true;
  }
  if (this->AnyGood)
    sample = this->Good;
  // Nobody wrote since the last Read, or nobody may: what acts is held against the time all the
  // same.
  if (!this->Written || !TakesForce(this->Status))
    this->Send();
  this->Written = false;
  return this->Status;
}

DeviceStatus GuardedHapticDevice::Write(const Wrench& wrench) noexcept
{
  this->Dog.Feed(this->PoseNs, Numbers(wrench));
  this->Written = true;
  return this->Send();
}

DeviceStatus GuardedHapticDevice::Send() noexcept
{
  const WatchedForce out = this->Dog.At(this->NowNs, TakesForce(this->Status));
  this->Cut = out.state == WatchdogState::Ramping || out.state == WatchdogState::Silent;
  const ForceNumbers& f = out.force;
  const DeviceStatus status = this->Device->Write(
    ClampToProfile(this->Device->Profile(), { { f[0], f[1], f[2] }, { f[3], f[4], f[5] } }));
  return this->Status | status;
}

GuardCounts GuardedHapticDevice::Counts() const noexcept
{
  return { this->BadPoses, this->Dog.Counts().notFinite, this->Dog.Counts().ramps };
}

} // namespace hasp
