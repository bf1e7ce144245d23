#pragma once
#include "Devices/Drivers/HapticDriver.h"

#include <memory>

namespace hasp
{

/// A device behind somebody else's shared library: HapticDevicePlugin.h says how to write one.
///
/// The library is code that runs in this process; load only what the user names. What it says is
/// not believed: a sample that is not finite, further than 10 m away, without a unit quaternion, or
/// with buttons that its profile lacks is dropped, and the one before comes again, not fresh. After
/// MostWrong of them in a row there is no going on. An answer that is none of the three is one too.
///
/// Threads: as HapticDriver; the plugin's own are its own. What the plugin does cannot be cut
/// short: an open or exchange of it that never returns holds the thread that called. Cost: dlopen
/// at construction; one call of the plugin and some 20 comparisons an exchange.
class PluginDriver : public HapticDriver
{
public:
  static constexpr int MostWrong = 50; ///< samples in a row: 50 ms at 1 kHz

  /// file      the library; a name without a slash is one in the current folder, never searched for
  /// settings  for the plugin, as its maker documents it; may be empty
  /// Throws DeviceError: Address if there is no such file, it is no library that can be loaded,
  /// lacks the symbol, is of another version, or does not understand its settings; Protocol if its
  /// profile cannot be. No device is touched.
  explicit PluginDriver(const std::string& file, const std::string& settings = {});
  ~PluginDriver() override; ///< closes, and unloads the library

  /// Its name is what the plugin calls the device, anything but printable ASCII as question marks:
  /// text of somebody else, for the user's eyes, not for logs.
  const DeviceProfile& Profile() const noexcept override;

  /// Asks whether to leave once, before the plugin opens; not in between.
  void Open(const DriverOpening& how) override;
  DriverSample Exchange(const Wrench& wrench, std::int64_t nowNs) override;
  /// What zeroes the force is the plugin's close; a zero wrench is said before, once.
  void Close() noexcept override;
  /// The plugin's sentence, printable ASCII, at most 200 characters: text of somebody else.
  std::string Advice() const override;

private:
  class Library;
  std::unique_ptr<Library> Loaded;
};

} // namespace hasp
