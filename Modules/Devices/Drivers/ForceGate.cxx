#include "Devices/Drivers/ForceGate.h"

namespace hasp
{

namespace
{
const DeviceProfile& Checked(const DeviceProfile& profile)
{
  ValidateDeviceProfile(profile);
  return profile;
}
} // namespace

ForceGate::ForceGate(const DeviceProfile& profile, const ForceGateSettings& settings)
  : Of(Checked(profile)),
    Dog(settings.watchdog),
    Limiter({ .force = profile.peakForceN,
      .torque = profile.peakTorqueNmm,
      .forceSlew = settings.forceSlew,
      .torqueSlew = settings.torqueSlew,
      .rampInS = settings.rampInS })
{
}

void ForceGate::Want(const Wrench& wrench, std::int64_t nowNs) noexcept
{
  const auto& [force, torque] = wrench;
  this->Dog.Feed(nowNs, { force.x, force.y, force.z, torque.x, torque.y, torque.z });
}

Wrench ForceGate::At(std::int64_t nowNs, bool ready) noexcept
{
  const WatchedForce watched = this->Dog.At(nowNs, ready);
  const double seconds =
    this->Any ? 1e-9 * static_cast<double>(NsBetween(this->BeforeNs, nowNs)) : 0.0;
  this->BeforeNs = nowNs;
  this->Any = true;
  if (watched.state != WatchdogState::Fresh && watched.state != WatchdogState::Ramping)
  {
    this->Limiter.Restart();
    return {};
  }
  const ForceNumbers& f = watched.force;
  return this->Limiter.Limit(
    ClampToProfile(this->Of, { { f[0], f[1], f[2] }, { f[3], f[4], f[5] } }), seconds);
}

} // namespace hasp
