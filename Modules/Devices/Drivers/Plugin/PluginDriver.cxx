#include "Devices/Drivers/Plugin/PluginDriver.h"

#include "Devices/Drivers/Plugin/HapticDevicePlugin.h"
#include "Devices/PluginLibrary.h"
#include "Grid/FinitePose.h"
#include "Grid/Progress.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hasp
{

namespace
{
constexpr std::size_t MostName = 63, MostAdvice = 200;
constexpr double MostDistanceMm = 10'000.0, UnitWithin = 1e-3;
constexpr PluginKind Kind{ "device plugin", HASP_HAPTIC_DEVICE_PLUGIN_ENTRY, "HapticDevicePlugin.h",
  HASP_HAPTIC_DEVICE_PLUGIN_VERSION };

[[noreturn]] void Fail(DeviceTrouble trouble, const std::string& why)
{
  throw DeviceError(trouble, std::string(Kind.what) + ": " + why);
}

DeviceProfile ProfileOf(const HaspHapticProfile& p, const char* name)
{
  DeviceProfile profile{ .name = PrintableText(name, MostName),
    .poseAxes = p.poseAxes,
    .forceAxes = p.forceAxes,
    .buttons = p.buttons,
    .workspaceMm = { p.workspaceMm[0], p.workspaceMm[1], p.workspaceMm[2] },
    .peakForceN = p.peakForceN,
    .continuousForceN = p.continuousForceN,
    .peakTorqueNmm = p.peakTorqueNmm,
    .continuousTorqueNmm = p.continuousTorqueNmm,
    .stiffnessNPerMm = p.stiffnessNPerMm,
    .dampingNsPerMm = p.dampingNsPerMm,
    .movingMassKg = p.movingMassKg,
    .positionQuantumMm = p.positionQuantumMm,
    .angleQuantumRad = p.angleQuantumRad,
    .delayTicks = p.delayTicks };
  try
  {
    ValidateDeviceProfile(profile);
  }
  catch (const std::invalid_argument& error)
  {
    Fail(DeviceTrouble::Protocol, std::string("its profile cannot be; ") + error.what());
  }
  return profile;
}

/// Why a sample is dropped; nullptr: it is not.
const char* FaultOf(const HaspHapticSample& sample, const DriverSample& read, int buttons) noexcept
{
  if (!IsFinite(read.pose))
    return "numbers that are not finite";
  for (const double coordinate : sample.positionMm)
    if (std::abs(coordinate) > MostDistanceMm)
      return "positions further than 10 m away; are they in mm?";
  if (std::abs(glm::length(read.pose.orientation) - 1.0) > UnitWithin)
    return "quaternions that are not unit";
  if (buttons < 32 && sample.buttons >> buttons != 0)
    return "buttons that its profile does not have";
  return nullptr;
}
} // namespace

/// The library, its table and the session while there is one, undone in the opposite order.
class PluginDriver::Library
{
public:
  Library(const std::string& file, const std::string& settings)
    : Loaded(Kind, file),
      Table(this->Loaded.Get<HaspHapticDevicePlugin>()),
      Settings(settings)
  {
    if (!this->Table.describe || !this->Table.open || !this->Table.exchange || !this->Table.close)
      this->Loaded.Refuse("the plugin's table lacks describe, open, exchange or close");
    HaspHapticProfile profile{};
    profile.size = sizeof profile;
    if (this->Table.describe(this->Settings.c_str(), &profile) != HASP_HAPTIC_DESCRIBED)
      this->Loaded.Refuse("the plugin does not understand its settings; its maker says which there "
                          "are");
    this->Profile = ProfileOf(profile, this->Table.name);
  }
  ~Library() { this->Close(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  void Open()
  {
    int trouble = HASP_HAPTIC_ABSENT;
    this->Session = this->Table.open(this->Settings.c_str(), &trouble);
    this->Last = { .fresh = false, .homed = false }; // nothing is known before the first sample
    this->Wrong = 0;
    if (this->Session)
      return;
    if (trouble == HASP_HAPTIC_BUSY)
      Fail(DeviceTrouble::Busy, "another program has its device; end that");
    if (trouble == HASP_HAPTIC_FORBIDDEN)
      Fail(DeviceTrouble::Permission,
        "the system does not let this user have its device; its maker says what to install");
    Fail(DeviceTrouble::Absent, "it could not open its device; is it plugged in and switched on, "
                                "and are the settings right?");
  }

  DriverSample Exchange(const Wrench& wrench)
  {
    if (!this->Session)
      Fail(DeviceTrouble::Gone, "its device is not open");
    HaspHapticSample sample{};
    const int answer = this->Say(wrench, sample);
    this->Last.fresh = false;
    switch (answer)
    {
      case HASP_HAPTIC_NONE:
        break;
      case HASP_HAPTIC_GIVEN:
        this->Take(sample);
        break;
      case HASP_HAPTIC_LOST:
        this->Lost = true;
        Fail(DeviceTrouble::Gone, "its device is gone; was it unplugged?");
      default:
        this->Drop("answers that are none of NONE, GIVEN and LOST");
    }
    return this->Last;
  }

  void Close() noexcept
  {
    if (!this->Session)
      return;
    HaspHapticSample sample{};
    if (!this->Lost)
      this->Say({}, sample);
    this->Table.close(this->Session);
    this->Session = nullptr;
    this->Lost = false;
  }

  std::string Advice() const
  {
    const bool asked = this->Session && this->Table.advice;
    return PrintableText(asked ? this->Table.advice(this->Session) : nullptr, MostAdvice);
  }

  DeviceProfile Profile;

private:
  int Say(const Wrench& wrench, HaspHapticSample& sample) const
  {
    const Wrench clamped = ClampToProfile(this->Profile, wrench);
    const glm::dvec3 &f = clamped.force, &t = clamped.torque;
    const HaspHapticWrench said{ { f.x, f.y, f.z }, { t.x, t.y, t.z } };
    sample.size = sizeof sample;
    return this->Table.exchange(this->Session, &said, &sample);
  }

  void Take(const HaspHapticSample& sample)
  {
    const auto& p = sample.positionMm;
    const auto& q = sample.orientation;
    DriverSample read{ { { p[0], p[1], p[2] } }, sample.buttons, true, sample.notHomed == 0 };
    if (this->Profile.poseAxes == 6)
      read.pose.orientation = { q[0], q[1], q[2], q[3] };
    if (const char* fault = FaultOf(sample, read, this->Profile.buttons))
      return this->Drop(fault);
    read.pose.orientation = glm::normalize(read.pose.orientation);
    this->Last = read;
    this->Wrong = 0;
  }

  void Drop(const char* what)
  {
    if (++this->Wrong >= MostWrong)
      Fail(DeviceTrouble::Protocol,
        "it gives " + std::string(what) + ", " + std::to_string(this->Wrong) + " in a row");
  }

  PluginLibrary Loaded;
  const HaspHapticDevicePlugin& Table;
  std::string Settings;
  void* Session = nullptr;
  bool Lost = false;
  DriverSample Last;
  int Wrong = 0;
};

PluginDriver::PluginDriver(const std::string& file, const std::string& settings)
{
  try
  {
    this->Loaded = std::make_unique<Library>(file, settings);
  }
  catch (const DeviceError&)
  {
    throw;
  }
  catch (const std::runtime_error& error) // PluginLibrary's, with our Kind before it
  {
    throw DeviceError(DeviceTrouble::Address, error.what());
  }
}

PluginDriver::~PluginDriver() = default;

const DeviceProfile& PluginDriver::Profile() const noexcept
{
  return this->Loaded->Profile;
}

void PluginDriver::Open(const DriverOpening& how)
{
  this->Close();
  if (how.cancelled())
    throw Cancelled();
  how.says("opening " + this->Profile().name);
  this->Loaded->Open();
}

DriverSample PluginDriver::Exchange(const Wrench& wrench, std::int64_t)
{
  return this->Loaded->Exchange(wrench);
}

void PluginDriver::Close() noexcept
{
  this->Loaded->Close();
}

std::string PluginDriver::Advice() const
{
  return this->Loaded->Advice();
}

} // namespace hasp
