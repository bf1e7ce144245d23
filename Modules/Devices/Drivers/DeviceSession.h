#pragma once
#include "Devices/Drivers/ForceGate.h"
#include "Devices/Drivers/HapticDriver.h"
#include "Realtime/TripleBuffer.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace hasp
{

struct DeviceSessionSettings
{
  ForceGateSettings gate{};
  std::int64_t periodNs = 1'000'000;    ///< between two exchanges, from start to start
  std::int64_t retryNs = 1'000'000'000; ///< between two tries to open; > 0
};

enum class DevicePhase
{
  Searching, ///< not there, or it cannot be opened: tried again and again
  Opening,   ///< being opened, which may take seconds (firmware)
  Homing,    ///< open; the user has something to do first (advice)
  Running,
  Closed
};

/// How a device is, for people.
struct DeviceNews
{
  DevicePhase phase = DevicePhase::Searching;
  DeviceTrouble trouble = DeviceTrouble::Absent; ///< while searching: of the last try
  std::string says;                              ///< the trouble's sentence, or what goes on
  std::string advice;                            ///< what the user has to do; empty: nothing
  std::string warning;                           ///< of the last opening; empty: none
  std::uint64_t opened = 0;                      ///< times
  std::uint64_t exchanges = 0, stale = 0;        ///< … of them without anything new
  std::uint64_t lost = 0;                        ///< times that it went while it was open
};

/// A driver that is opened, asked, lost and found again, behind the ForceGate: all that a device
/// needs besides a thread. Once lost it gives no force, and the next one that is there begins with
/// none.
///
/// Threads: Step, Close on the driver's; Read and Write on HAPTIC (as HapticDevice says); News on
/// any. Time is passed in, so that all of it runs in virtual time. Step may wait as the driver
/// does, and take memory; Read and Write cost 30 ns.
class DeviceSession
{
public:
  /// Throws std::invalid_argument if there is no driver, its profile is none or a setting is out
  /// of its range.
  explicit DeviceSession(
    std::unique_ptr<HapticDriver> driver, const DeviceSessionSettings& settings = {});
  ~DeviceSession(); ///< closes it
  DeviceSession(const DeviceSession&) = delete;
  DeviceSession& operator=(const DeviceSession&) = delete;

  /// The driver's, with HandOverTicks more of delay: what a stable coupling is chosen from.
  const DeviceProfile& Profile() const noexcept { return this->Is; }
  /// From HAPTIC to the driver and back, the worst: `hasp report haptics`, haptics.falcon.delay.
  static constexpr int HandOverTicks = 2;

  /// One exchange, or a try to open it. Returns when the next one is due.
  std::int64_t Step(std::int64_t nowNs) noexcept;
  /// No force, and let go. A Step after this opens it again.
  void Close() noexcept;
  /// Any thread: an opening that goes on leaves, and Step opens nothing any more.
  void Cancel() noexcept { this->Leaving.store(true, std::memory_order_relaxed); }

  DeviceStatus Read(DeviceSample& sample) noexcept;
  DeviceStatus Write(const Wrench& wrench) noexcept;

  DeviceNews News() const;

private:
  struct Heard
  {
    DeviceSample sample;
    std::uint64_t fresh = 0; ///< samples so far
    DeviceStatus status = DeviceStatus::Unplugged;
  };
  void Open();
  void Exchange(std::int64_t nowNs);
  void Lose(DeviceTrouble trouble, const std::string& says);
  void Say(DevicePhase phase, const std::string& says, const std::string& advice = {});

  std::unique_ptr<HapticDriver> Driver;
  DeviceProfile Is;
  DeviceSessionSettings Settings;
  ForceGate Gate;
  bool IsOpen = false;
  std::int64_t TryNs = 0; ///< not before that
  bool Pausing = false;   ///< the next Step says until when
  Heard Last;             ///< the driver's
  std::atomic<bool> Leaving{ false };
  TripleBuffer<Heard> Said;
  TripleBuffer<Wrench> Wanted;
  std::uint64_t Seen = 0; ///< HAPTIC's: of Heard::fresh
  DeviceStatus SeenStatus = DeviceStatus::Unplugged;
  mutable std::mutex Telling;
  DeviceNews Told;
};

} // namespace hasp
