#include "Devices/Drivers/SpaceMouse/SpaceMouseDriver.h"

#include "Devices/SettingsCheck.h"

#include <cmath>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* What = "SpaceMouse";
constexpr int MostButtons = 32; // which model will be plugged in is not known
} // namespace

SpaceMouseDriver::SpaceMouseDriver(
  std::unique_ptr<SixDofSource> source, const SpaceMouseSettings& settings)
  : Source(std::move(source)),
    Settings(settings),
    Input({ .workspaceMm = settings.workspaceMm, .followS = settings.followS }),
    Is(this->Input.Profile())
{
  if (!this->Source)
    throw std::invalid_argument("a SpaceMouse needs a source of its deflections");
  CheckRange(What, "fullMmPerS", settings.fullMmPerS, 0.0, 1000.0);
  CheckRange(What, "fullRadPerS", settings.fullRadPerS, 0.0, 20.0);
  CheckRange(What, "staleS", settings.staleS, 0.01, 1.0);
  CheckRange(What, "waitMs", settings.waitMs, 0.0, 20.0);
  this->Is.name = this->Source->Name();
  this->Is.buttons = MostButtons;
}

SpaceMouseDriver::~SpaceMouseDriver()
{
  this->Close();
}

void SpaceMouseDriver::Open(const DriverOpening& how)
{
  this->Forget();
  this->Source->Open(how);
}

DriverSample SpaceMouseDriver::Exchange(const Wrench&, std::int64_t nowNs)
{
  const SixDofState held = this->State; // since the last exchange
  const SixDofNews news = this->Source->Read(this->State, this->Settings.waitMs);
  const glm::dvec3 push = this->Fresh(this->PushNs, nowNs) ? held.push : glm::dvec3(0.0);
  const glm::dvec3 turn = this->Fresh(this->TurnNs, nowNs) ? held.turn : glm::dvec3(0.0);
  if (news.push)
    this->PushNs = nowNs;
  if (news.turn)
    this->TurnNs = nowNs;
  this->Input.SetRates(this->Settings.fullMmPerS * push, this->Settings.fullRadPerS * turn, nowNs);
  this->Input.SetButtons(this->State.buttons);
  DeviceSample sample;
  const DeviceStatus status = this->Input.Read(nowNs, sample);
  return { .pose = sample.pose, .buttons = sample.buttons, .fresh = status == DeviceStatus::Ok };
}

void SpaceMouseDriver::Close() noexcept
{
  this->Source->Close();
  this->Forget();
}

bool SpaceMouseDriver::Fresh(
  const std::optional<std::int64_t>& saidNs, std::int64_t nowNs) const noexcept
{
  return saidNs &&
         std::abs(static_cast<double>(NsBetween(*saidNs, nowNs))) <= 1e9 * this->Settings.staleS;
}

void SpaceMouseDriver::Forget() noexcept
{
  this->State = {};
  this->PushNs.reset();
  this->TurnNs.reset();
}

} // namespace hasp
