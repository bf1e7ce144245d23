#include "Devices/ReplayHapticDevice.h"

#include "Devices/SettingsCheck.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
using Bits = std::array<std::uint64_t, 6>;

/// NaN equals itself here, and -0 is not 0.
Bits BitsOf(const Wrench& w) noexcept
{
  const std::array<double, 6> numbers = { w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y,
    w.torque.z };
  return std::bit_cast<Bits>(numbers);
}

double Apart(const glm::dvec3& a, const glm::dvec3& b) noexcept
{
  const glm::dvec3 apart = a - b;
  return IsFinite(apart) ? glm::length(apart) : std::numeric_limits<double>::infinity();
}
} // namespace

ReplayHapticDevice::ReplayHapticDevice(std::shared_ptr<const HapticRecording> recording)
  : Recording(std::move(recording))
{
  if (!this->Recording)
    throw std::invalid_argument("haptic recording: there is none to replay");
  this->Is.name = "replay";
  this->Is.poseAxes = this->Recording->poseAxes;
  this->Is.forceAxes = this->Recording->forceAxes;
  this->Is.peakForceN = this->Is.continuousForceN = this->Recording->peakForceN;
  this->Is.peakTorqueNmm = this->Is.continuousTorqueNmm = this->Recording->peakTorqueNmm;
  this->Is.positionQuantumMm = this->Is.angleQuantumRad = 0.0; // what they were is in the poses
  this->Is.delayTicks = 0;
}

DeviceStatus ReplayHapticDevice::Read(std::int64_t, DeviceSample& sample) noexcept
{
  this->Over = this->Next >= this->Recording->records.size();
  if (this->Over)
    return DeviceStatus::Ended;
  const HapticRecord& record = this->Recording->records[this->Next++];
  sample = record.sample;
  return record.status;
}

DeviceStatus ReplayHapticDevice::Write(const Wrench& wrench) noexcept
{
  if (this->Over)
    return DeviceStatus::Ended;
  if (this->Next == 0)
    return DeviceStatus::Ok; // before the first tick: there is nothing to compare with
  const HapticRecord& record = this->Recording->records[this->Next - 1];
  ++this->Found.compared;
  if (BitsOf(wrench) != BitsOf(record.wrench))
  {
    if (this->Found.different++ == 0)
      this->Found.firstDifferent = record.number;
    this->Found.mostForceN =
      std::max(this->Found.mostForceN, Apart(wrench.force, record.wrench.force));
    this->Found.mostTorqueNmm =
      std::max(this->Found.mostTorqueNmm, Apart(wrench.torque, record.wrench.torque));
  }
  return record.status;
}

std::optional<std::int64_t> ReplayHapticDevice::NextNs() const noexcept
{
  if (this->Next >= this->Recording->records.size())
    return std::nullopt;
  return this->Recording->records[this->Next].nowNs;
}

std::string WhyBitsDiffer(const HapticRecording& recording, std::string_view kernelsNow)
{
  constexpr std::size_t Kept = 8; // characters of a name, in a recording
  const std::string_view then = recording.kernels;
  if (then.empty() || then.substr(0, Kept) == kernelsNow.substr(0, Kept))
    return {};
  return "the recording was made with other contact kernels than those here (" +
         std::string(kernelsNow) + "): sums differ by rounding";
}

void ReplayHapticDevice::Rewind() noexcept
{
  this->Next = 0;
  this->Over = false;
  this->Found = {};
}

} // namespace hasp
