#include "Devices/Drivers/DrivenHapticDevice.h"

#include "Realtime/LoopThread.h"
#include "Realtime/SignalsBlocked.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>

namespace hasp
{

namespace
{
constexpr std::int64_t LongestSleepNs = 20'000'000; // so soon the thread hears that it is to end
}

DrivenHapticDevice::DrivenHapticDevice(std::unique_ptr<HapticDriver> driver,
  const DeviceSessionSettings& settings, const SchedulingRequest& scheduling)
  : Session(std::move(driver), settings)
{
  const SignalsBlocked inherited;
  try
  {
    this->Thread = std::thread([this, scheduling] { this->Run(scheduling); });
  }
  catch (const std::system_error& error)
  {
    throw std::runtime_error(
      std::string("haptic device: the system gives no thread: ") + error.what());
  }
}

DrivenHapticDevice::~DrivenHapticDevice()
{
  this->Stopping.store(true, std::memory_order_relaxed);
  this->Session.Cancel();
  this->Thread.join();
}

DeviceStatus DrivenHapticDevice::Read(std::int64_t nowNs, DeviceSample& sample) noexcept
{
  const std::int64_t before = sample.timeNs;
  const DeviceStatus status = this->Session.Read(sample);
  if (sample.timeNs != before)
    sample.timeNs = std::min(sample.timeNs, nowNs); // the driver's clock is the loop's
  return status;
}

void DrivenHapticDevice::Run(const SchedulingRequest& scheduling) noexcept
{
  const RealTimeScheduling asked(scheduling);
  MonotonicClock clock;
  std::int64_t dueNs = 0;
  while (!this->Stopping.load(std::memory_order_relaxed))
  {
    const std::int64_t nowNs = clock.NowNs();
    if (nowNs < dueNs)
      clock.SleepUntil(std::min(dueNs, nowNs + LongestSleepNs));
    else
      dueNs = this->Session.Step(nowNs);
  }
  this->Session.Close();
}

} // namespace hasp
