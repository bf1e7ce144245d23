#pragma once
#include "Devices/Drivers/DeviceSession.h"
#include "Realtime/RealTimeScheduling.h"

#include <thread>

namespace hasp
{

/// A device with hardware behind it: a DeviceSession on a thread of its own, which exchanges once a
/// millisecond (or as fast as the device answers) and finds the device again when it is plugged in
/// again. So HAPTIC never waits for a cable; what it reads is up to a period older for it.
///
/// Threads: HapticDevice's for Read and Write; made and destroyed on RENDER; News on any. A thread
/// while this is there, which sleeps 20 ms at a time where no device is open. The destructor waits
/// for the exchange that is under way, and leaves no force.
class DrivenHapticDevice : public HapticDevice
{
public:
  /// Throws as DeviceSession; std::runtime_error if the system gives no thread.
  explicit DrivenHapticDevice(std::unique_ptr<HapticDriver> driver,
    const DeviceSessionSettings& settings = {},
    const SchedulingRequest& scheduling = { .fifoPriority = 79, .lock = MemoryLocking::None });
  ~DrivenHapticDevice() override;

  const DeviceProfile& Profile() const noexcept override { return this->Session.Profile(); }
  DeviceStatus Read(std::int64_t nowNs, DeviceSample& sample) noexcept override;
  DeviceStatus Write(const Wrench& wrench) noexcept override { return this->Session.Write(wrench); }

  DeviceNews News() const { return this->Session.News(); }

private:
  void Run(const SchedulingRequest& scheduling) noexcept;

  DeviceSession Session;
  std::atomic<bool> Stopping{ false };
  std::thread Thread;
};

} // namespace hasp
