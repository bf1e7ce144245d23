#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// A device that the system shows, whether or not it can be used.
struct FoundDevice
{
  std::string address;  ///< as MakeDriver takes it
  std::string name;     ///< "Novint Falcon"
  bool force = false;   ///< it can push
  bool mayOpen = true;  ///< by this user
  bool driver = true;   ///< this build has its driver
  std::string remedy{}; ///< where one of the two is not: a sentence with what to do
};

/// Where the system shows them. Tests have folders of their own.
struct DeviceFolders
{
  std::filesystem::path sys = "/sys", dev = "/dev";
  std::filesystem::path spacenav = "/var/run/spnav.sock";
};

/// All devices of known kinds: read off the system's files alone. No device is opened, no library
/// asked, no socket made, so it costs nothing to ask at any time: about 1 ms. What lies behind a
/// service or in a plugin is not found this way; it is named (DeviceAddress.h).
/// Nothing throws for what cannot be read: that is not there. Any thread.
std::vector<FoundDevice> FindDevices(const DeviceFolders& folders = {});

/// The address of the first that pushes and can be used, or else of the first that can be used;
/// empty: there is none. Any thread.
std::string FirstUsable(const std::vector<FoundDevice>& found);

/// The same device with its place: "falcon" as "falcon:1-2", the first of its kind that can be
/// used. As it is if it has a place, or there is none of its kind. Any thread.
std::string WithPlace(const std::string& address, const std::vector<FoundDevice>& found);

/// Rules for udev that let whoever sits at the machine use these devices: the text of
/// 60-hasp-devices.rules.
std::string UdevRules();

} // namespace hasp
