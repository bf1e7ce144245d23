#include "Devices/InputHapticDevice.h"

#include "Devices/SettingsCheck.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr const char* What = "input device";
constexpr double LongestTickS = 0.1; // after a pause nothing leaps
constexpr double Farthest = 1e6;     // a kilometre: sums of such steps keep their micrometres

bool IsStep(const glm::dvec3& v) noexcept
{
  return std::abs(v.x) <= Farthest && std::abs(v.y) <= Farthest && std::abs(v.z) <= Farthest;
}
} // namespace

InputHapticDevice::InputHapticDevice(const InputDeviceSettings& settings) : Settings(settings)
{
  CheckRange(What, "followS", settings.followS, 0.0, 1.0);
  CheckRange(What, "staleS", settings.staleS, 1e-3, 10.0);
  this->Is.name = "input";
  this->Is.forceAxes = 0;
  this->Is.workspaceMm = settings.workspaceMm;
  this->Is.peakForceN = this->Is.continuousForceN = 0.0;
  this->Is.peakTorqueNmm = this->Is.continuousTorqueNmm = 0.0;
  this->Is.positionQuantumMm = this->Is.angleQuantumRad = 0.0;
  this->Is.delayTicks = 0;
  ValidateDeviceProfile(this->Is);
}

void InputHapticDevice::MoveBy(const glm::dvec3& mm) noexcept
{
  if (!IsStep(mm))
    return;
  this->Said.moved += mm;
  this->Exchange.Write(this->Said);
}

void InputHapticDevice::TurnBy(const glm::dvec3& radians) noexcept
{
  if (!IsStep(radians))
    return;
  this->Said.turned = glm::normalize(hasp::TurnBy(radians) * this->Said.turned);
  this->Exchange.Write(this->Said);
}

void InputHapticDevice::MoveTo(const RigidPose& pose) noexcept
{
  const double length = glm::length(pose.orientation);
  if (!IsStep(pose.position) || !(std::abs(length - 1.0) <= 1e-3))
    return;
  this->Said.place = { pose.position, pose.orientation / length };
  ++this->Said.placed;
  this->Said.moved = glm::dvec3(0.0);
  this->Said.turned = { 1, 0, 0, 0 };
  this->Exchange.Write(this->Said);
}

void InputHapticDevice::SetRates(
  const glm::dvec3& mmPerS, const glm::dvec3& radPerS, std::int64_t nowNs) noexcept
{
  if (!IsStep(mmPerS) || !IsStep(radPerS))
    return;
  this->Said.mmPerS = mmPerS;
  this->Said.radPerS = radPerS;
  this->Said.ratesNs = nowNs;
  this->Exchange.Write(this->Said);
}

void InputHapticDevice::SetButtons(std::uint32_t held) noexcept
{
  this->Said.buttons = held;
  this->Exchange.Write(this->Said);
}

void InputHapticDevice::TakeSteps(const Input& input) noexcept
{
  if (input.placed != this->Heard.placed)
  {
    this->Goal = this->Pose = input.place;
    this->Heard.moved = glm::dvec3(0.0);
    this->Heard.turned = { 1, 0, 0, 0 };
  }
  this->Goal.position += input.moved - this->Heard.moved;
  this->Goal.orientation =
    glm::normalize(input.turned * glm::conjugate(this->Heard.turned) * this->Goal.orientation);
  this->Heard = input;
}

void InputHapticDevice::Follow(double dtS) noexcept
{
  const double share =
    this->Settings.followS > 0.0 ? -std::expm1(-dtS / this->Settings.followS) : 1.0;
  this->Pose.position += share * (this->Goal.position - this->Pose.position);
  const glm::dvec3 turn =
    RotationVector(this->Goal.orientation * glm::conjugate(this->Pose.orientation));
  this->Pose.orientation = glm::normalize(hasp::TurnBy(share * turn) * this->Pose.orientation);
}

DeviceStatus InputHapticDevice::Read(std::int64_t nowNs, DeviceSample& sample) noexcept
{
  const bool news = !this->Any || nowNs > this->NowNs;
  const double dtS =
    this->Any && news
      ? std::min(1e-9 * static_cast<double>(NsBetween(this->NowNs, nowNs)), LongestTickS)
      : 0.0;
  if (this->Exchange.Update())
    this->TakeSteps(*this->Exchange.Latest());
  const Input& heard = this->Heard;
  if (std::abs(static_cast<double>(NsBetween(heard.ratesNs, nowNs))) <= 1e9 * this->Settings.staleS)
  {
    this->Goal.position += dtS * heard.mmPerS;
    this->Goal.orientation =
      glm::normalize(hasp::TurnBy(dtS * heard.radPerS) * this->Goal.orientation);
  }
  const glm::dvec3& box = this->Settings.workspaceMm;
  this->Goal.position = glm::clamp(this->Goal.position, -box, box);
  this->Follow(dtS);
  if (news)
    this->NowNs = nowNs;
  this->Any = true;
  sample = { this->NowNs, this->Pose, heard.buttons };
  return news ? DeviceStatus::Ok : DeviceStatus::Stale;
}

} // namespace hasp
