#include "Devices/SimulatedHapticDevice.h"

#include "Devices/SettingsCheck.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* What = "simulated device";

glm::dvec3 Count(const glm::dvec3& v, double quantum) noexcept
{
  if (quantum == 0.0)
    return v;
  return { std::round(v.x / quantum) * quantum, std::round(v.y / quantum) * quantum,
    std::round(v.z / quantum) * quantum };
}

double Seconds(std::int64_t ns) noexcept
{
  return 1e-9 * static_cast<double>(ns);
}

HandBody BodyOf(const SimulatedDeviceSettings& settings)
{
  HandBody body;
  body.massKg = settings.profile.movingMassKg;
  body.viscousNsPerMm = settings.profile.dampingNsPerMm;
  body.inertiaKgMm2 = settings.inertiaKgMm2;
  body.turnViscousNmmSPerRad = settings.turnViscousNmmSPerRad;
  body.coulombN = settings.coulombN;
  body.turnCoulombNmm = settings.turnCoulombNmm;
  return body;
}
} // namespace

SimulatedHapticDevice::SimulatedHapticDevice(
  const SimulatedDeviceSettings& settings, HandIntention intention)
  : Settings(settings),
    Model(BodyOf(settings), settings.grip, std::move(intention))
{
  ValidateDeviceProfile(settings.profile);
  double beforeS = -1e9;
  for (const SimulatedButtons& buttons : settings.buttons)
  {
    CheckRange(What, "a button's time", buttons.fromS, beforeS, 1e9);
    beforeS = buttons.fromS;
  }
  for (const SimulatedOutage& outage : settings.outages)
  {
    CheckRange(What, "an outage's beginning", outage.fromS, -1e9, 1e9);
    CheckRange(What, "an outage's end", outage.toS, outage.fromS, 1e9);
  }
}

bool SimulatedHapticDevice::PluggedAt(double timeS) const noexcept
{
  return std::none_of(this->Settings.outages.begin(), this->Settings.outages.end(),
    [timeS](const SimulatedOutage& o) { return timeS >= o.fromS && timeS < o.toS; });
}

std::uint32_t SimulatedHapticDevice::ButtonsAt(double timeS) const noexcept
{
  std::uint32_t held = 0;
  for (const SimulatedButtons& buttons : this->Settings.buttons)
    held = timeS >= buttons.fromS ? buttons.held : held;
  return held;
}

DeviceSample SimulatedHapticDevice::Measure() const noexcept
{
  const DeviceProfile& profile = this->Settings.profile;
  const RigidPose& truth = this->Model.Pose();
  DeviceSample sample{ this->ReadNs };
  sample.pose.position = Count(truth.position, profile.positionQuantumMm);
  if (profile.poseAxes == 6)
    sample.pose.orientation =
      profile.angleQuantumRad == 0.0
        ? truth.orientation
        : TurnBy(Count(RotationVector(truth.orientation), profile.angleQuantumRad));
  sample.buttons = this->ButtonsAt(Seconds(this->Model.TimeNs()));
  return sample;
}

DeviceStatus SimulatedHapticDevice::Read(std::int64_t nowNs, DeviceSample& sample) noexcept
{
  if (!this->Began)
    this->ReadNs = nowNs;
  const std::int64_t handNs =
    this->Model.TimeNs() +
    std::clamp<std::int64_t>(NsBetween(this->ReadNs, nowNs), 0, LongestReadNs);
  const bool news = nowNs > this->ReadNs || this->Sent == 0;
  this->Began = true;
  this->ReadNs = std::max(this->ReadNs, nowNs);
  this->Plugged = this->PluggedAt(Seconds(handNs));
  if (!this->Plugged)
    this->Acting = {};
  this->Model.Advance(handNs, this->Acting);
  if (!this->Plugged)
    return DeviceStatus::Unplugged;
  if (news)
    this->Cable[this->Sent++ % this->Cable.size()] = this->Measure();
  const auto delay = static_cast<std::size_t>(this->Settings.profile.delayTicks);
  // While the first samples are on their way, the first of all.
  sample = this->Cable[(this->Sent - 1 - std::min(delay, this->Sent - 1)) % this->Cable.size()];
  return news ? DeviceStatus::Ok : DeviceStatus::Stale;
}

DeviceStatus SimulatedHapticDevice::Write(const Wrench& wrench) noexcept
{
  this->Acting = this->Plugged ? ClampToProfile(this->Settings.profile, wrench) : Wrench{};
  return this->Plugged ? DeviceStatus::Ok : DeviceStatus::Unplugged;
}

} // namespace hasp
