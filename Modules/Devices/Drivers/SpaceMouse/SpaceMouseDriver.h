#pragma once
#include "Devices/Drivers/SpaceMouse/SixDofSource.h"
#include "Devices/InputHapticDevice.h"

#include <memory>

namespace hasp
{

struct SpaceMouseSettings
{
  double fullMmPerS = 60.0;        ///< of full deflection; in [0, 1000]
  double fullRadPerS = 1.5;        ///< …; in [0, 20]
  double staleS = 0.1;             ///< deflections that are older count as none; in [0.01, 1]
  int waitMs = 4;                  ///< the longest wait for news in an exchange; in [0, 20]
  glm::dvec3 workspaceMm{ 100.0 }; ///< half of the box that poses stay in
  double followS = 0.015;          ///< see InputDeviceSettings; reports come every 8 to 16 ms
};

/// A 6-DOF input as a driver: no force; its deflections are rates, integrated into a pose.
///
/// A deflection counts from the exchange that hears it to the next one, and each half of it, pushes
/// and turns, as long as it is no older than `staleS`: a device that falls silent, or says one half
/// only, does not drift on. A cap pressed and held says so 60 to 125 times a second over HID.
/// spacenavd repeats nothing unless it is told to: a cap held so still that no number changes stops
/// there after `staleS`.
/// It has no dead zone of its own: devices send zeros at rest, and spacenavd has one.
/// The pose stays through Close and Open. Costs an exchange of microseconds, and the wait.
/// Threads: as HapticDriver; takes no memory in Exchange but for what is thrown.
class SpaceMouseDriver : public HapticDriver
{
public:
  /// Throws std::invalid_argument if a setting is out of its range or there is no source.
  explicit SpaceMouseDriver(
    std::unique_ptr<SixDofSource> source, const SpaceMouseSettings& settings = {});
  ~SpaceMouseDriver() override;

  const DeviceProfile& Profile() const noexcept override { return this->Is; }
  void Open(const DriverOpening& how) override;
  DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) override;
  void Close() noexcept override;

  /// In [0, 100] %, if it was said since Open. Threads: that of Exchange.
  std::optional<int> BatteryPercent() const noexcept { return this->Source->BatteryPercent(); }
  /// Reports or events that were wrong, since Open. Threads: that of Exchange.
  std::uint64_t WrongCount() const noexcept { return this->Source->WrongCount(); }

private:
  bool Fresh(const std::optional<std::int64_t>& saidNs, std::int64_t nowNs) const noexcept;
  void Forget() noexcept;

  std::unique_ptr<SixDofSource> Source;
  SpaceMouseSettings Settings;
  InputHapticDevice Input;
  DeviceProfile Is;
  SixDofState State;
  std::optional<std::int64_t> PushNs, TurnNs; ///< when they were said
};

} // namespace hasp
