#pragma once
#include <string>

namespace hasp
{

/// How a device is named on command lines, in settings and in the planner: "DRIVER" or
/// "DRIVER:REST".
///
///   falcon              the first Novint Falcon; falcon:1-2 the one at that port (as lsusb -t
///   says) spacemouse          the first 3Dconnexion device; spacemouse:hidraw3 that one spacenav
///   through the spacenavd daemon; spacenav:SOCKET through another socket inverse3            a
///   Haply Inverse3 through its service; inverse3:ws://HOST:PORT plugin:FILE.so      a maker's SDK;
///   plugin:FILE.so:SETTINGS
struct DeviceAddress
{
  std::string driver;
  std::string rest; ///< empty: the first, or the usual place
};

/// Throws DeviceError (Address) with the drivers there are.
DeviceAddress ParseDeviceAddress(const std::string& text);

} // namespace hasp
