#include "Tools/HandDevices.h"

#include "Devices/Drivers/DeviceList.h"
#include "Devices/Drivers/LentHapticDevice.h"
#include "Tools/Planner.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

constexpr int LookMs = 200;
// The system first shows a device, and then says whose it is: a look right away would find it
// locked.
constexpr int SettleMs = 700;

bool IsSame(const std::vector<FoundDevice>& a, const std::vector<FoundDevice>& b)
{
  return std::ranges::equal(a, b,
    [](const FoundDevice& one, const FoundDevice& other)
    { return one.address == other.address && one.mayOpen == other.mayOpen; });
}
} // namespace

HandDevices::HandDevices(Planner& planner, Places places) : Of(planner), At(std::move(places))
{
  try
  {
    this->Chosen = ReadDeviceSettings(this->At.settings);
  }
  catch (const std::exception& error)
  {
    planner.SayFault(tr("The settings of devices are not used: %1").arg(error.what()));
    this->At.settings.clear(); // what is there is not written over
  }
  this->Searching.setSingleShot(true);
  this->Searching.setInterval(SettleMs);
  this->Looking.setInterval(LookMs);
  connect(&this->Searching, &QTimer::timeout, this, &HandDevices::Search);
  connect(&this->Looking, &QTimer::timeout, this, &HandDevices::Look);
  connect(&this->Watcher, &QFileSystemWatcher::directoryChanged, &this->Searching,
    qOverload<>(&QTimer::start));
  connect(&planner.tools, &ToolBox::Changed, this, &HandDevices::Follow);
  planner.openDevice = [this] { return this->Lend(); };
  planner.devices = this;
  this->Seen = FindDevices(this->At.folders);
  this->Watch();
}

HandDevices::~HandDevices()
{
  this->Of.openDevice = nullptr;
  this->Of.devices = nullptr;
}

/// Where nodes of devices come and go.
void HandDevices::Watch()
{
  const fs::path& dev = this->At.folders.dev;
  std::error_code error;
  std::vector<fs::path> folders{ dev, dev / "bus/usb" };
  for (fs::directory_iterator bus(dev / "bus/usb", error), end; !error && bus != end;
       bus.increment(error))
    folders.push_back(bus->path());
  for (const fs::path& folder : folders)
    if (const QString path = QString::fromStdString(folder.string());
        fs::is_directory(folder, error) && !this->Watcher.directories().contains(path))
      this->Watcher.addPath(path);
}

void HandDevices::Search()
{
  this->Watch(); // a bus may be new
  std::vector<FoundDevice> found = FindDevices(this->At.folders);
  if (IsSame(found, this->Seen))
    return;
  this->Seen = std::move(found);
  this->Refused.clear();
  if (this->Device && this->OfDevice != this->Address()) // in another socket, or another device
  {
    if (this->Runs)
      this->Of.SayFault(tr("%1 was unplugged. The mouse moves what is in hand.")
                          .arg(QString::fromStdString(this->Device->Profile().name)));
    this->End();
  }
  if (!this->Device && this->Of.tools.InHand())
    this->Begin();
  Q_EMIT this->FoundChanged();
}

std::string HandDevices::Address() const
{
  if (this->Chosen.device == "none")
    return {};
  if (!this->Chosen.device.empty())
    return WithPlace(this->Chosen.device, this->Seen);
  const std::string first = FirstUsable(this->Seen);
  const auto found = std::ranges::find(this->Seen, first, &FoundDevice::address);
  return found != this->Seen.end() && found->force ? first : std::string();
}

bool HandDevices::SetSettings(const DeviceSettings& settings)
{
  const bool kept = !this->At.settings.empty();
  if (kept)
    WriteDeviceSettings(this->At.settings, settings);
  this->Chosen = settings;
  this->Refused.clear();
  const bool held = this->Held;
  this->End();
  if (held)
    this->Hold();
  else if (this->Of.tools.InHand())
    this->Begin();
  return kept;
}

bool HandDevices::Begin()
{
  this->IdleFor = 0;
  if (this->Device)
    return true;
  const std::string address = this->Address();
  if (this->Ending || address.empty() || address == this->Refused)
    return false;
  try
  {
    this->Device = std::make_shared<DrivenHapticDevice>(
      MakeGuardedDriver(address, this->Chosen, this->At.guard));
    this->OfDevice = address;
  }
  catch (const std::exception& error)
  {
    this->Refused = address;
    this->Of.SayFault(tr("The haptic device is not used: %1").arg(error.what()));
    return false;
  }
  this->Looking.start();
  return true;
}

/// Tools have the mouse from here on.
void HandDevices::End()
{
  this->Looking.stop();
  this->Held = false;
  this->Told.clear();
  this->Faulted.clear();
  this->Device.reset(); // it goes when tools have let go of it, and no other comes before
  this->Ending = true;
  if (std::exchange(this->Runs, false))
    Q_EMIT this->Of.DeviceChanged();
  this->Ending = false;
}

std::unique_ptr<HapticDevice> HandDevices::Lend()
{
  if (this->Held || !this->Begin() || !this->Runs)
    return nullptr;
  return std::make_unique<LentHapticDevice>(this->Device);
}

std::shared_ptr<DrivenHapticDevice> HandDevices::Hold()
{
  if (!this->Begin())
    return nullptr;
  this->Held = true;
  if (std::exchange(this->Runs, false))
    Q_EMIT this->Of.DeviceChanged(); // tools give it back
  return this->Device;
}

void HandDevices::LetGo()
{
  this->Held = false;
  this->IdleFor = 0;
}

DeviceNews HandDevices::News() const
{
  if (this->Device)
    return this->Device->News();
  DeviceNews none;
  none.phase = DevicePhase::Closed;
  return none;
}

void HandDevices::Follow()
{
  if (this->Of.tools.InHand())
    this->IdleFor = 0;
}

void HandDevices::Look()
{
  const bool wanted = this->Held || this->Of.tools.InHand() != nullptr;
  this->IdleFor = wanted ? 0 : this->IdleFor + LookMs;
  if (this->IdleFor >= IdleMs)
    return this->End();
  if (this->Held)
    return; // who holds it says what it says
  const DeviceNews news = this->Device->News();
  const QString name = QString::fromStdString(this->Device->Profile().name);
  const bool runs = news.phase == DevicePhase::Running;
  const QString says = QString::fromStdString(news.advice.empty() ? news.says : news.advice);
  if (runs != this->Runs)
  {
    this->Runs = runs;
    this->Faulted = runs ? QString() : says;
    if (runs)
      this->Of.Say(tr("%1 moves what is in hand now.").arg(name));
    else
      this->Of.SayFault(tr("%1: %2. The mouse moves what is in hand.").arg(name, says));
    if (runs && !news.warning.empty())
      this->Of.SayFault(tr("%1: %2").arg(name, QString::fromStdString(news.warning)));
    Q_EMIT this->Of.DeviceChanged();
  }
  else if (!runs && !says.isEmpty() && says != this->Told)
    this->Say(name, says, news.phase == DevicePhase::Searching);
  this->Told = says;
}

/// It is tried again every second: what is wrong is said once, and then no more what is tried.
void HandDevices::Say(const QString& name, const QString& says, bool fault)
{
  if (fault && std::exchange(this->Faulted, says) != says)
    this->Of.SayFault(tr("%1: %2").arg(name, says));
  else if (!fault && this->Faulted.isEmpty())
    this->Of.Say(tr("%1: %2").arg(name, says));
}

} // namespace hasp
