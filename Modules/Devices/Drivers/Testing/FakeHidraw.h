#pragma once
#include "Devices/Drivers/Testing/FakeHid.h"

#include <umockdev.h>

#include <map>
#include <mutex>

namespace hasp::test
{

/// A system whose /dev/hidraw* and /sys are umockdev's: HID devices that hidapi finds, opens, reads
/// and writes as real ones. One at a time, in a process that runs under umockdev-wrapper.
///
/// A node is always ready, and a read that finds no report says so (EAGAIN): a wait for a report is
/// not one. umockdev answers on a thread of its own.
class FakeHidraw
{
public:
  FakeHidraw() : Bed(umockdev_testbed_new()) {}
  ~FakeHidraw()
  {
    while (!this->Nodes.empty())
      this->Unplug(this->Nodes.begin()->first);
    g_object_unref(this->Bed);
  }
  FakeHidraw(const FakeHidraw&) = delete;
  FakeHidraw& operator=(const FakeHidraw&) = delete;

  /// Whether this process runs under umockdev-wrapper.
  static bool Works();

  /// As /dev/hidraw<number>, each number once. Wired, or by Bluetooth.
  void Plug(int number, const HidCollection& is, const Bytes& descriptor, bool wired = true);
  /// Its node goes; a program that has it open finds it gone (ENODEV), as from Linux.
  void Unplug(int number);

  void Say(int number, const Bytes& report);
  /// Of the reads from now on the one after `more` fails with the number `error`, and all that
  /// follow: unplugged while a read is under way. -1: none does.
  void FailReads(int number, int more, int error);
  void RefuseWrites(int number, bool refused);
  std::vector<Bytes> Written(int number); ///< each output report
  std::size_t Unread(int number);

  /// Where the node of /dev/hidraw<number> is in truth, to change who may open it.
  std::string RealPath(int number) const;

private:
  struct Node
  {
    std::mutex Lock; // of all below: umockdev's thread, and the test's
    Bytes Descriptor;
    std::deque<Bytes> Reports;
    std::vector<Bytes> Written;
    int ReadsUntilError = -1, Error = 0; ///< -1: none fails
    bool WritesRefused = false;
    UMockdevIoctlBase* Answers = nullptr;
    std::vector<std::string> SysPaths;
  };
  static gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static gboolean OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node);
  static std::string DevicePath(int number) { return "/dev/hidraw" + std::to_string(number); }

  UMockdevTestbed* Bed;
  std::map<int, std::unique_ptr<Node>> Nodes;
  std::vector<std::unique_ptr<Node>> Gone; ///< may be open still
};

} // namespace hasp::test
