#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <filesystem>
#include <memory>

namespace hasp
{

/// A driver whose device is let go without force even if this program ends in the middle of it, by
/// a crash or by SIGKILL: a small program waits on a pipe beside it (hasp-device-guard), and when
/// the pipe ends while the device is open it opens the device and closes it, which leaves zero.
///
/// The program is started by the first Open, and not at all for a device without motors. Where it
/// cannot be started Open goes on without it and says so (DriverOpening::says).
/// Threads: as HapticDriver. Cost: a sleeping process of about 2 MB while the device is open; a
/// byte through a pipe for each Open and Close.
class CrashGuard : public HapticDriver
{
public:
  /// program  hasp-device-guard
  /// address  what it opens: as MakeDriver takes it
  CrashGuard(std::unique_ptr<HapticDriver> driver, std::filesystem::path program,
    const std::string& address);
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
  void Tell(char word) noexcept;

  std::unique_ptr<HapticDriver> Driver;
  std::filesystem::path Program;
  std::string Address;
  int Pipe = -1;
  int Child = 0;
};

/// What hasp-device-guard does: reads words from `pipe` until it ends, and then, if the last one
/// said that the device is open, opens and closes it, trying for `patienceS` (the program that
/// ended may still hold it). Returns its exit code: 0 nothing was to be done or zero force was
/// left, 1 the device could not be had.
int GuardDevice(int pipe, HapticDriver& driver, double patienceS = 2.0);

} // namespace hasp
