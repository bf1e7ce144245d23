#include "Devices/Drivers/DeviceSession.h"

#include "Devices/SettingsCheck.h"
#include "Grid/Progress.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double UnitWithin = 1e-3;        // what a driver's own rounding may leave
constexpr std::uint64_t AdviceEvery = 100; // exchanges
constexpr int MostDelayTicks = 16;         // that a profile may have

DeviceProfile ProfileOf(const HapticDriver* driver)
{
  if (!driver)
    throw std::invalid_argument("haptic device: there is no driver");
  DeviceProfile profile = driver->Profile();
  ValidateDeviceProfile(profile);
  profile.delayTicks = std::min(profile.delayTicks + DeviceSession::HandOverTicks, MostDelayTicks);
  return profile;
}

bool IsPose(const RigidPose& pose) noexcept
{
  return IsFinite(pose) && std::abs(glm::length(pose.orientation) - 1.0) <= UnitWithin;
}
} // namespace

DeviceSession::DeviceSession(
  std::unique_ptr<HapticDriver> driver, const DeviceSessionSettings& settings)
  : Driver(std::move(driver)),
    Is(ProfileOf(this->Driver.get())),
    Settings(settings),
    Gate(this->Is, settings.gate)
{
  CheckRange("haptic device", "periodNs", static_cast<double>(settings.periodNs), 1e5, 1e8);
  CheckRange("haptic device", "retryNs", static_cast<double>(settings.retryNs), 1e6, 6e10);
}

DeviceSession::~DeviceSession()
{
  this->Close();
}

std::int64_t DeviceSession::Step(std::int64_t nowNs) noexcept
{
  // What drivers throw besides DeviceError (no memory, say) is a trouble of that device, too: the
  // program lives on.
  try
  {
    if (this->IsOpen)
    {
      this->Exchange(nowNs);
      return nowNs + this->Settings.periodNs;
    }
    if (this->Leaving.load(std::memory_order_relaxed))
      return nowNs + this->Settings.retryNs;
    // The pause begins when a try has ended, however long that took: it is to be read what it said.
    if (std::exchange(this->Pausing, false))
      this->TryNs = nowNs + this->Settings.retryNs;
    if (nowNs < this->TryNs)
      return this->TryNs;
    this->Open();
    return nowNs + this->Settings.periodNs;
  }
  catch (const DeviceError& error)
  {
    this->Lose(error.trouble, error.what());
  }
  catch (const Cancelled&)
  {
    this->Lose(DeviceTrouble::Absent, "opening the device was cancelled");
  }
  catch (const std::exception& error)
  {
    this->Lose(DeviceTrouble::Protocol, error.what());
  }
  return nowNs + this->Settings.periodNs;
}

void DeviceSession::Open()
{
  this->Say(DevicePhase::Opening, "opening the device");
  this->Driver->Open({ .cancelled = [this] { return this->Leaving.load(); },
    .says = [this](const std::string& what) { this->Say(DevicePhase::Opening, what); },
    .warns =
      [this](const std::string& what)
    {
      const std::lock_guard lock(this->Telling);
      this->Told.warning = what;
    } });
  this->IsOpen = true;
  const std::lock_guard lock(this->Telling);
  ++this->Told.opened;
}

void DeviceSession::Exchange(std::int64_t nowNs)
{
  if (this->Wanted.Update())
    this->Gate.Want(*this->Wanted.Latest(), nowNs);
  const bool ready = TakesForce(this->Last.status);
  const DriverSample said = this->Driver->Exchange(this->Gate.At(nowNs, ready), nowNs);
  DeviceStatus status = said.homed ? DeviceStatus::Ok : DeviceStatus::NotHomed;
  if (!said.sane || !IsPose(said.pose))
    status = status | DeviceStatus::Fault;
  else if (said.fresh)
  {
    this->Last.sample = { nowNs, said.pose, said.buttons };
    ++this->Last.fresh;
  }
  this->Last.status = status;
  this->Said.Write(this->Last);
  const bool homed = said.homed;
  const std::lock_guard lock(this->Telling);
  this->Told.stale += said.fresh ? 0 : 1;
  const DevicePhase phase = homed ? DevicePhase::Running : DevicePhase::Homing;
  const bool isNew = std::exchange(this->Told.phase, phase) != phase;
  if (isNew)
    this->Told.says = homed ? "the device is running" : "the device has to be homed";
  if (isNew || this->Told.exchanges % AdviceEvery == 0)
    this->Told.advice = this->Driver->Advice();
  ++this->Told.exchanges;
}

void DeviceSession::Lose(DeviceTrouble trouble, const std::string& says)
{
  this->Driver->Close();
  const bool wasOpen = std::exchange(this->IsOpen, false);
  this->Pausing = true;
  this->Last.status = DeviceStatus::Unplugged;
  this->Said.Write(this->Last);
  this->Gate.At(0, false); // what was wanted of the one that is gone is not the next one's
  const std::lock_guard lock(this->Telling);
  this->Told.phase = DevicePhase::Searching;
  this->Told.trouble = trouble;
  this->Told.says = says;
  this->Told.advice.clear();
  this->Told.warning.clear();
  this->Told.lost += wasOpen ? 1 : 0;
}

void DeviceSession::Close() noexcept
{
  this->Driver->Close();
  this->IsOpen = false;
  this->Pausing = false;
  this->TryNs = 0;
  this->Last.status = DeviceStatus::Unplugged;
  this->Said.Write(this->Last);
  this->Gate.At(0, false);
  const std::lock_guard lock(this->Telling);
  this->Told.phase = DevicePhase::Closed;
  this->Told.says.clear();
  this->Told.advice.clear();
}

DeviceStatus DeviceSession::Read(DeviceSample& sample) noexcept
{
  this->Said.Update();
  const Heard* heard = this->Said.Latest();
  if (heard == nullptr)
    return this->SeenStatus = DeviceStatus::Unplugged;
  const bool fresh = std::exchange(this->Seen, heard->fresh) != heard->fresh;
  if (heard->fresh > 0)
    sample = heard->sample;
  this->SeenStatus = heard->status;
  return fresh ? heard->status : heard->status | DeviceStatus::Stale;
}

DeviceStatus DeviceSession::Write(const Wrench& wrench) noexcept
{
  this->Wanted.Write(wrench);
  return this->SeenStatus;
}

DeviceNews DeviceSession::News() const
{
  const std::lock_guard lock(this->Telling);
  return this->Told;
}

void DeviceSession::Say(DevicePhase phase, const std::string& says, const std::string& advice)
{
  const std::lock_guard lock(this->Telling);
  this->Told.phase = phase;
  this->Told.says = says;
  this->Told.advice = advice;
}

} // namespace hasp
