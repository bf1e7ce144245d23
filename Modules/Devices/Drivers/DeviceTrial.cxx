#include "Devices/Drivers/DeviceTrial.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace hasp
{

namespace
{
constexpr std::int64_t LongestSilenceNs = 20'000'000;
}

DeviceTrial::DeviceTrial(HapticDevice& device) : Device(device)
{
  this->Loop.Start({ .scheduling = { .fifoPriority = 80, .lock = MemoryLocking::None } },
    [this](const LoopTick& tick) noexcept { return this->Tick(tick); });
}

DeviceTrial::~DeviceTrial()
{
  this->Loop.Stop();
  this->Device.Write({});
}

DeviceSight DeviceTrial::Look() noexcept
{
  this->Seen.Update();
  const DeviceSight* seen = this->Seen.Latest();
  return seen != nullptr ? *seen : DeviceSight{};
}

bool DeviceTrial::Tick(const LoopTick& tick) noexcept
{
  if (this->Asked.Update())
    this->Now.givenN = 0.0;
  const ForceTrial* trial = this->Asked.Latest();
  this->Now.status = this->Device.Read(tick.nowNs, this->Now.sample);
  if (!Has(this->Now.status, DeviceStatus::Stale))
    this->HeardNs = tick.nowNs;
  const bool alive =
    TakesForce(this->Now.status) && NsBetween(this->HeardNs, tick.nowNs) <= LongestSilenceNs;
  const bool pressed = (this->Now.sample.buttons & DeadMansButton) != 0;
  // A button that was down from the beginning may be stuck, and that of a silent device may be up
  // by now: it has to be seen up first.
  this->SeenUp = alive && (this->SeenUp || !pressed);
  const bool held = alive && pressed && this->SeenUp && trial != nullptr;
  if (held && !this->Held)
    this->HeldSinceNs = tick.nowNs;
  this->Held = held;
  // 1 ns: held now counts, and a time that is 0 would not.
  const double heldS =
    held ? 1e-9 * static_cast<double>(1 + NsBetween(this->HeldSinceNs, tick.nowNs)) : 0.0;
  this->Now.asked = trial != nullptr ? WrenchOf(*trial, heldS) : Wrench{};
  this->Now.givenN = std::max(this->Now.givenN, glm::length(this->Now.asked.force));
  this->Device.Write(this->Now.asked);
  ++this->Now.ticks;
  this->Seen.Write(this->Now);
  return true;
}

} // namespace hasp
