#include "Devices/HapticDevice.h"

#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* What = "haptic device";

glm::dvec3 Shorten(const glm::dvec3& v, double most) noexcept
{
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}
} // namespace

DeviceProfile GenericProfile()
{
  return {};
}

DeviceProfile FalconProfile()
{
  return { .name = "Falcon",
    .poseAxes = 3,
    .forceAxes = 3,
    .buttons = 4,
    .workspaceMm = { 40, 40, 40 },
    .peakForceN = 8.9,
    .continuousForceN = 8.0,
    .peakTorqueNmm = 0.0,
    .continuousTorqueNmm = 0.0,
    .stiffnessNPerMm = 3.0,
    .dampingNsPerMm = 0.001,
    .movingMassKg = 0.12,
    .positionQuantumMm = 0.043,
    .angleQuantumRad = 0.001,
    .delayTicks = 2 };
}

DeviceProfile TouchProfile()
{
  return { .name = "Touch",
    .poseAxes = 6,
    .forceAxes = 3,
    .buttons = 2,
    .workspaceMm = { 80, 60, 35 },
    .peakForceN = 3.3,
    .continuousForceN = 0.9,
    .peakTorqueNmm = 0.0,
    .continuousTorqueNmm = 0.0,
    .stiffnessNPerMm = 0.4,
    .dampingNsPerMm = 0.0003,
    .movingMassKg = 0.045,
    .positionQuantumMm = 0.055,
    .angleQuantumRad = 0.001,
    .delayTicks = 1 };
}

DeviceProfile PremiumProfile()
{
  return { .name = "Premium",
    .poseAxes = 6,
    .forceAxes = 6,
    .buttons = 1,
    .workspaceMm = { 400, 280, 200 },
    .peakForceN = 22.0,
    .continuousForceN = 3.0,
    .peakTorqueNmm = 188.0,
    .continuousTorqueNmm = 48.0,
    .stiffnessNPerMm = 1.0,
    .dampingNsPerMm = 0.001,
    .movingMassKg = 0.15,
    .positionQuantumMm = 0.02,
    .angleQuantumRad = 0.0002,
    .delayTicks = 0 };
}

void ValidateDeviceProfile(const DeviceProfile& p)
{
  if (p.poseAxes != 3 && p.poseAxes != 6)
    throw std::invalid_argument(
      "haptic device: poseAxes is " + std::to_string(p.poseAxes) + ", must be 3 or 6");
  if (p.forceAxes != 0 && p.forceAxes != 3 && p.forceAxes != 6)
    throw std::invalid_argument(
      "haptic device: forceAxes is " + std::to_string(p.forceAxes) + ", must be 0, 3 or 6");
  CheckRange(What, "buttons", p.buttons, 0, 32);
  for (int axis = 0; axis < 3; ++axis)
    CheckRange(What, "workspaceMm", p.workspaceMm[axis], 1e-3, 10'000.0);
  CheckRange(What, "peakForceN", p.peakForceN, 0.0, 1000.0);
  CheckRange(What, "continuousForceN", p.continuousForceN, 0.0, p.peakForceN);
  CheckRange(What, "peakTorqueNmm", p.peakTorqueNmm, 0.0, 1e6);
  CheckRange(What, "continuousTorqueNmm", p.continuousTorqueNmm, 0.0, p.peakTorqueNmm);
  CheckRange(What, "stiffnessNPerMm", p.stiffnessNPerMm, 0.0, 1e4);
  CheckRange(What, "dampingNsPerMm", p.dampingNsPerMm, 0.0, 1.0);
  CheckRange(What, "movingMassKg", p.movingMassKg, 1e-6, 100.0);
  CheckRange(What, "positionQuantumMm", p.positionQuantumMm, 0.0, 10.0);
  CheckRange(What, "angleQuantumRad", p.angleQuantumRad, 0.0, 1.0);
  CheckRange(What, "delayTicks", p.delayTicks, 0, 16);
}

Wrench ClampToProfile(const DeviceProfile& profile, const Wrench& wrench) noexcept
{
  if (profile.forceAxes == 0 || !IsFinite(wrench))
    return {};
  Wrench clamped{ Shorten(wrench.force, profile.peakForceN) };
  if (profile.forceAxes == 6)
    clamped.torque = Shorten(wrench.torque, profile.peakTorqueNmm);
  // 1e200 N: finite, and its square is not. 0 times infinity would come out.
  return IsFinite(clamped) ? clamped : Wrench{};
}

} // namespace hasp
