#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace hasp
{

/// A driver whose device is let go without force even if this program ends in the middle of it, by
/// a crash or by SIGKILL: a small program waits on a pipe beside it (hasp-device-guard), and when
/// the pipe ends while the device is open it opens the device and closes it, which leaves zero.
///
/// The program is started by the first Open, and not at all for a device without motors; once more
/// if it has gone. Where it cannot be started Open goes on without it and warns. It inherits no
/// handle of this program: one would keep the device.
/// Threads: as HapticDriver. Cost: a sleeping process of about 2 MB while the device is open; a
/// byte through a pipe for each Open and Close.
class CrashGuard : public HapticDriver
{
public:
  /// program   hasp-device-guard
  /// address   what it opens: as MakeDriver takes it
  /// settings  with which: as ParseDeviceSettings takes them; empty: the defaults
  CrashGuard(std::unique_ptr<HapticDriver> driver, std::filesystem::path program,
    const std::string& address, const std::string& settings = {});
  ~CrashGuard() override;

  const DeviceProfile& Profile() const noexcept override { return this->Driver->Profile(); }
  void Open(const DriverOpening& how) override;
  DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) override
  {
    return this->Driver->Exchange(wrench, nowNs);
  }
  void Close() noexcept override;
  std::string Advice() const override { return this->Driver->Advice(); }

private:
  bool Start();
  void Stop() noexcept;
  bool Tell(const std::string& words) noexcept;

  std::unique_ptr<HapticDriver> Driver;
  std::filesystem::path Program;
  std::string Address, Settings;
  int Pipe = -1;
  int Child = 0;
};

/// The settings that a CrashGuard sends first; nothing if it ended before all were there.
std::optional<std::string> ReadGuardedSettings(int pipe);

/// What hasp-device-guard does then: reads words from `pipe` until it ends, and, if the last one
/// said that the device is open, opens and closes it, trying for `patienceS` (the program that
/// ended may still hold it). Returns its exit code: 0 nothing was to be done or zero force was
/// left, or the device is not there or would have to be set up first: then it has no force; 1 it
/// could not be had.
int GuardDevice(int pipe, HapticDriver& driver, double patienceS = 2.0);

} // namespace hasp
