#pragma once
#include "Devices/Drivers/DeviceSearch.h"
#include "Devices/Drivers/DeviceSettings.h"
#include "Devices/Drivers/DrivenHapticDevice.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <vector>

namespace hasp
{

struct Planner;

/// The haptic device of who sits here: found when it is plugged in, opened when a tool wants it,
/// lent to tools, given up when it is gone or nobody wants it any more. Until it runs, and after it
/// went, tools have the mouse.
///
/// What pushes is taken by itself; a 6-DOF mouse without motors, a plugin or a service only if it
/// is named (DeviceSettings::device). Threads: RENDER. Cost: nothing but the system's word when
/// something is plugged in; a thread of the device, and a look at it five times a second, from the
/// first tool on until no tool was in hand for IdleMs.
class HandDevices : public QObject
{
  Q_OBJECT
public:
  static constexpr int IdleMs = 5000;

  struct Places
  {
    DeviceFolders folders{};
    std::filesystem::path settings; ///< its file; empty: nothing is kept
    std::filesystem::path guard;    ///< hasp-device-guard
  };
  /// Is Planner::openDevice from now on, and must go before the planner.
  HandDevices(Planner& planner, Places places);
  ~HandDevices() override;

  const std::vector<FoundDevice>& Found() const { return this->Seen; }
  const DeviceSettings& Settings() const { return this->Chosen; }
  /// The device is opened anew, if it is wanted. False: they hold until the program ends, and are
  /// not written, for what is in their file is not ours. Throws as WriteDeviceSettings: then
  /// nothing has changed.
  bool SetSettings(const DeviceSettings& settings);
  /// Of what is used, with its place; empty: the mouse alone.
  std::string Address() const;
  /// The device, opened, for somebody who looks at it: tools have the mouse as long as it is held.
  /// Null: there is none, or it cannot be; that is said.
  std::shared_ptr<DrivenHapticDevice> Hold();
  void LetGo();
  /// What it says; Closed while nobody wants it.
  DeviceNews News() const;

Q_SIGNALS:
  void FoundChanged();

private:
  std::unique_ptr<HapticDevice> Lend();
  bool Begin();
  void End();
  void Follow();
  void Look();
  void Say(const QString& name, const QString& says, bool fault);
  void Search();
  void Watch();

  Planner& Of;
  Places At;
  DeviceSettings Chosen;
  std::vector<FoundDevice> Seen;
  QFileSystemWatcher Watcher;
  QTimer Searching, Looking;
  std::shared_ptr<DrivenHapticDevice> Device;
  std::string OfDevice; ///< its address
  std::string Refused;  ///< address that made no driver: said once
  bool Held = false, Runs = false, Ending = false;
  QString Told;    ///< of News, last
  QString Faulted; ///< what was wrong last: said once
  int IdleFor = 0; ///< ms
};

} // namespace hasp
