#pragma once
#include "FalconModel.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace hasp::test
{

/// FalconModel as a USB device of the kernel: FunctionFS hands its endpoints to this program, and
/// dummy_hcd is the socket that it is plugged into, in the same machine. From there on, up to
/// usbfs, all is as with a device on a cable; at full speed, as the true one.
///
/// One at a time. Threads: any; the model is moved by threads of its own, on the steady clock.
class GadgetFalcon
{
public:
  GadgetFalcon(); ///< plugged in. Throws std::system_error.
  ~GadgetFalcon();
  GadgetFalcon(const GadgetFalcon&) = delete;
  GadgetFalcon& operator=(const GadgetFalcon&) = delete;

  /// The model keeps its power, and so its firmware and its zeros, without the cable.
  void Plug();
  void Unplug();
  /// Once it has received so many bytes more: before the program that sent them knows the answer.
  void UnplugAfter(std::int64_t bytes) { this->BytesUntilUnplug = bytes; }
  void With(const std::function<void(FalconModel&)>& use);

private:
  void ServeControl(const std::stop_token& stop);
  void ServeOut(const std::stop_token& stop);
  void ServeIn(const std::stop_token& stop);
  void SetClock(); ///< of the model, now

  std::mutex Lock;
  std::condition_variable Heard; ///< the model did
  FalconModel Model{ InventedFirmware() };
  std::atomic<std::int64_t> BytesUntilUnplug = 0; ///< 0: never
  int Control = -1, In = -1, Out = -1;
  std::jthread ControlThread, InThread, OutThread; ///< the last: they use the others
};

} // namespace hasp::test
