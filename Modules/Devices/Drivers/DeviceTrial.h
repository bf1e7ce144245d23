#pragma once
#include "Devices/Drivers/ForceTrial.h"
#include "Realtime/LoopThread.h"
#include "Realtime/TripleBuffer.h"

namespace hasp
{

/// What a device did in its last tick.
struct DeviceSight
{
  DeviceSample sample{};
  DeviceStatus status = DeviceStatus::Unplugged;
  Wrench asked{};      ///< of the trial
  double givenN = 0.0; ///< the largest force that was asked of the device since the last Ask
  std::uint64_t ticks = 0;
};

/// Somebody looks at a device and feels it: a loop of 1 kHz that reads it, and writes what a trial
/// says as long as button 0 is held, if it was seen up before. While it is not held, or nothing new
/// was heard of it for 20 ms, and at the end, it writes zero.
/// Threads: RENDER, or whoever owns it; the device is the loop's while this is there. Cost: a
/// thread.
class DeviceTrial
{
public:
  static constexpr std::uint32_t DeadMansButton = 1; ///< bit 0

  /// Throws std::runtime_error if the system gives no thread.
  explicit DeviceTrial(HapticDevice& device);
  ~DeviceTrial();

  /// From the next tick on.
  void Ask(const ForceTrial& trial) noexcept { this->Asked.Write(trial); }
  DeviceSight Look() noexcept;

private:
  bool Tick(const LoopTick& tick) noexcept;

  HapticDevice& Device;
  TripleBuffer<ForceTrial> Asked;
  TripleBuffer<DeviceSight> Seen;
  // The loop's
  DeviceSight Now;
  std::int64_t HeldSinceNs = 0, HeardNs = 0;
  bool Held = false, SeenUp = false;
  LoopThread Loop;
};

} // namespace hasp
