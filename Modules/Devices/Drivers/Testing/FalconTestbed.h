#pragma once
#include "FalconModel.h"

#include <functional>
#include <memory>
#include <string>

namespace hasp
{

/// A Falcon in this system's /sys and /dev/bus/usb, as far as this process sees them: umockdev
/// (libumockdev-preload) serves what libusb asks of the kernel, and a FalconModel behind it answers
/// in real time. The process must run under umockdev-wrapper, else construction throws.
///
/// Threads: all but the answers, which come from umockdev's own thread.
class FalconTestbed
{
public:
  FalconTestbed();
  ~FalconTestbed();
  FalconTestbed(const FalconTestbed&) = delete;
  FalconTestbed& operator=(const FalconTestbed&) = delete;

  /// The model, while nobody else has it.
  void With(const std::function<void(FalconModel&)>& use);

  void Plug();   ///< under a new device number, as the kernel does; at port "1-1"
  void Unplug(); ///< gone from the bus; nothing if it is not there
  /// After so many more transfers have been begun, none is answered any more: the moment of
  /// unplugging, before the system has taken note.
  void BreakAfter(int transfers);
  void SetBusy(bool busy); ///< another program has its interface
  void Forbid();           ///< nobody may open its node

private:
  struct Internals;
  std::unique_ptr<Internals> Bed;
};

} // namespace hasp
