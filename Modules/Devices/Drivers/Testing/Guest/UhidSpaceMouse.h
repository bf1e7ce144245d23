#pragma once
#include "Devices/Drivers/Testing/FakeHid.h"

#include <mutex>
#include <thread>

namespace hasp::test
{

/// A SpaceMouse Wireless on its cable, made by /dev/uhid: to the kernel's HID core, and to all who
/// read its hidraw node, a device as any. Plugged in as long as it lives.
class UhidSpaceMouse
{
public:
  UhidSpaceMouse();
  ~UhidSpaceMouse();
  UhidSpaceMouse(const UhidSpaceMouse&) = delete;
  UhidSpaceMouse& operator=(const UhidSpaceMouse&) = delete;

  /// It lies in the queue of each who has the node open when this returns; or nowhere, while the
  /// kernel is not yet done with a device that is new.
  void Say(const Bytes& report);
  /// The output reports that arrived, each with its number in front.
  std::vector<Bytes> Written();

private:
  void Listen(const std::stop_token& stop);

  int Node;
  std::mutex Lock;
  std::vector<Bytes> Outputs; ///< behind Lock
  std::jthread Listener;      ///< the last: it uses the others
};

} // namespace hasp::test
