#include "FalconTestbed.h"

#include <umockdev.h>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <list>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* SysPath = "/devices/pci0000:00/0000:00:14.0/usb1/1-1";

struct Unref
{
  void operator()(void* object) const { g_object_unref(object); }
};
template <typename T>
using Held = std::unique_ptr<T, Unref>;
using Data = Held<UMockdevIoctlData>;

void Require(bool good, GError* error, const char* what)
{
  const std::string why = error ? error->message : "no reason given";
  g_clear_error(&error);
  if (!good)
    throw std::runtime_error("umockdev: " + std::string(what) + ": " + why);
}

/// Device descriptor, configuration, interface, bulk endpoints 0x81 and 0x02 of 64 bytes.
constexpr std::array<std::uint8_t, 50> Descriptors{ 18, 1, 0x00, 0x02, 0, 0, 0, 64, 0x03, 0x04,
  0x48, 0xcb, 0x00, 0x04, 1, 2, 3, 1, 9, 2, 32, 0, 1, 1, 0, 0x80, 50, 9, 4, 0, 0, 2, 0xff, 0xff,
  0xff, 2, 7, 5, 0x81, 2, 64, 0, 0, 7, 5, 0x02, 2, 64, 0, 0 };

std::string Hex(std::span<const std::uint8_t> bytes)
{
  std::string text;
  for (const std::uint8_t byte : bytes)
  {
    char two[3];
    std::snprintf(two, sizeof two, "%02X", byte);
    text += two;
  }
  return text;
}

std::string NodeOf(int number)
{
  char name[32];
  std::snprintf(name, sizeof name, "bus/usb/001/%03d", number);
  return name;
}

/// As umockdev-record would write it down.
std::string Record(int number)
{
  const std::string node = NodeOf(number), n = std::to_string(number);
  return "P: " + std::string(SysPath) + "\nN: " + node + "=" + Hex(Descriptors) +
         "\nE: DEVNAME=/dev/" + node +
         "\nE: DEVTYPE=usb_device\nE: DRIVER=usb\nE: PRODUCT=403/cb48/400\nE: BUSNUM=001"
         "\nE: DEVNUM=" +
         n + "\nE: MAJOR=189\nE: MINOR=" + std::to_string(number - 1) +
         "\nE: SUBSYSTEM=usb\nA: bConfigurationValue=1\\n\nA: bNumConfigurations=1\\n"
         "\nA: busnum=1\\n\nA: devnum=" +
         n +
         "\\n\nA: devpath=1\\n\nA: idProduct=cb48\\n\nA: idVendor=0403\\n\nA: speed=12\\n"
         "\nA: version= 2.00\\n\nA: maxchild=0\\n\nH: descriptors=" +
         Hex(Descriptors) + "\n\n";
}

/// A transfer that libusb has begun and not yet fetched.
struct Transfer
{
  UMockdevIoctlClient* client; ///< whose; not held
  Data urb, buffer;
  std::int64_t beganNs;
  bool done = false;

  usbdevfs_urb& Urb() const { return *reinterpret_cast<usbdevfs_urb*>(this->urb->data); }
  bool IsIn() const { return this->Urb().endpoint & 0x80; }
  void End(int status, std::size_t length)
  {
    this->Urb().status = status;
    this->Urb().actual_length = static_cast<int>(length);
    this->done = true;
  }
};
} // namespace

struct FalconTestbed::Internals
{
  std::mutex mutex; // all below but the bed
  FalconModel model{ InventedFirmware() };
  DeviceClock clock = SteadyDeviceClock();
  std::list<Transfer> transfers;
  bool there = false, busy = false;
  int breakAfter = -1;

  bool listed = false; // in /sys
  int number = 1;
  Held<UMockdevTestbed> bed;
  Held<UMockdevIoctlBase> kernel;

  static gboolean Serve(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self)
  {
    gulong request = 0;
    UMockdevIoctlData* given = nullptr;
    g_object_get(client, "request", &request, "arg", &given, nullptr);
    const Data argument(given);
    int error = EFAULT;
    try
    {
      error = static_cast<Internals*>(self)->Answer(client, request, given);
    }
    catch (const std::runtime_error&)
    {
      // Another program asked, and was killed before its memory was read.
    }
    umockdev_ioctl_client_complete(client, error ? -1 : 0, error);
    return TRUE;
  }
  static void Forget(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self)
  {
    auto& bed = *static_cast<Internals*>(self);
    const std::lock_guard lock(bed.mutex);
    bed.transfers.remove_if([&](const Transfer& t) { return t.client == client; });
  }

  /// What usbfs does. 0 or an errno.
  int Answer(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument)
  {
    const std::lock_guard lock(this->mutex);
    this->model.nowNs = this->clock.nowNs();
    switch (request)
    {
      // What was begun can be fetched and taken back also when the device is gone.
      case USBDEVFS_REAPURB:
      case USBDEVFS_REAPURBNDELAY:
        return this->Reap(client, argument);
      case USBDEVFS_DISCARDURB:
        return this->Discard(client, argument);
      default:
        break;
    }
    if (!this->there)
      return ENODEV;
    switch (request)
    {
      case USBDEVFS_GET_CAPABILITIES:
      {
        const Data value = Resolve(argument, 0, sizeof(std::uint32_t));
        const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET |
                                           USBDEVFS_CAP_BULK_CONTINUATION |
                                           USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
        std::memcpy(value->data, &capabilities, sizeof capabilities);
        return 0;
      }
      case USBDEVFS_CLAIMINTERFACE:
      case USBDEVFS_DISCONNECT_CLAIM:
        return this->busy ? EBUSY : 0;
      case USBDEVFS_GETDRIVER:
        return ENODATA; // no kernel driver is bound
      case USBDEVFS_RELEASEINTERFACE:
      case USBDEVFS_SETCONFIGURATION:
      case USBDEVFS_CLEAR_HALT:
      case USBDEVFS_IOCTL: // the kernel's driver may have it again
        return 0;
      case USBDEVFS_SUBMITURB:
        return this->Submit(client, argument);
      default:
        return ENOTTY;
    }
  }

  static Data Resolve(UMockdevIoctlData* from, std::size_t offset, std::size_t length)
  {
    GError* error = nullptr;
    Data data(umockdev_ioctl_data_resolve(from, offset, length, &error));
    Require(data != nullptr, error, "memory of the program under test");
    return data;
  }

  int Submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
  {
    if (this->breakAfter >= 0 && this->breakAfter-- == 0)
    {
      this->Break();
      return ENODEV;
    }
    Transfer t{ client, Resolve(argument, 0, sizeof(usbdevfs_urb)), nullptr, this->model.nowNs };
    const auto length = static_cast<std::size_t>(t.Urb().buffer_length);
    if (length > 0)
      t.buffer = Resolve(t.urb.get(), offsetof(usbdevfs_urb, buffer), length);
    if (t.Urb().type == USBDEVFS_URB_TYPE_CONTROL)
    {
      const std::uint8_t* setup = t.buffer->data;
      const auto value = static_cast<std::uint16_t>(setup[2] | setup[3] << 8);
      const bool vendorOut = setup[0] == 0x40 && setup[4] == 0 && setup[5] == 0;
      t.End(vendorOut && this->model.Control(setup[1], value) ? 0 : -EPIPE, 0);
    }
    else if (!t.IsIn())
    {
      this->model.Receive({ t.buffer->data, length });
      t.End(0, length);
    }
    this->transfers.push_back(std::move(t));
    return 0;
  }

  int Reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
  {
    for (auto t = this->transfers.begin(); t != this->transfers.end(); ++t)
    {
      if (t->client != client)
        continue;
      // The chip sends what it has, or after its latency that it has nothing.
      const bool due =
        this->model.nowNs - t->beganNs >= this->model.LatencyMs() * std::int64_t{ 1'000'000 };
      if (!t->done && (this->model.HasAnswer() || due))
        t->End(0,
          this->model.Send({ t->buffer->data, static_cast<std::size_t>(t->Urb().buffer_length) }));
      if (!t->done)
        continue;
      const Data pointer = Resolve(argument, 0, sizeof(void*));
      umockdev_ioctl_data_set_ptr(pointer.get(), 0, t->urb.get());
      this->transfers.erase(t);
      return 0;
    }
    return this->there ? EAGAIN : ENODEV;
  }

  int Discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument)
  {
    gulong address = 0;
    std::memcpy(&address, argument->data, sizeof address);
    for (auto& t : this->transfers)
      if (t.client == client && t.urb->client_addr == address && !t.done)
      {
        t.End(-ENOENT, 0);
        return 0;
      }
    return this->there ? EINVAL : ENODEV;
  }

  /// The cable is off: what waits, ends.
  void Break()
  {
    this->there = false;
    this->breakAfter = -1;
    for (auto& t : this->transfers)
      if (!t.done)
        t.End(-ESHUTDOWN, 0);
  }

  std::string Node() const { return "/dev/" + NodeOf(this->number); }
};

FalconTestbed::FalconTestbed()
{
  this->Bed = std::make_unique<Internals>();
  this->Bed->bed.reset(umockdev_testbed_new());
  if (!umockdev_in_mock_environment()) // asks for a bed too
    throw std::runtime_error("run this under umockdev-wrapper");
  this->Bed->kernel.reset(umockdev_ioctl_base_new());
  g_signal_connect(
    this->Bed->kernel.get(), "handle-ioctl", G_CALLBACK(Internals::Serve), this->Bed.get());
  g_signal_connect(
    this->Bed->kernel.get(), "client-vanished", G_CALLBACK(Internals::Forget), this->Bed.get());
  this->Plug();
}

FalconTestbed::~FalconTestbed()
{
  this->Unplug();
}

void FalconTestbed::With(const std::function<void(FalconModel&)>& use)
{
  const std::lock_guard lock(this->Bed->mutex);
  use(this->Bed->model);
}

void FalconTestbed::Plug()
{
  this->Unplug();
  auto& bed = *this->Bed;
  bed.number = bed.number % 127 + 1;
  GError* error = nullptr;
  const bool added =
    umockdev_testbed_add_from_string(bed.bed.get(), Record(bed.number).c_str(), &error);
  Require(added, error, "the device");
  bed.listed = true;
  const bool served =
    umockdev_testbed_attach_ioctl(bed.bed.get(), bed.Node().c_str(), bed.kernel.get(), &error);
  Require(served, error, "its node");
  const std::lock_guard lock(bed.mutex);
  bed.there = true;
}

void FalconTestbed::Unplug()
{
  auto& bed = *this->Bed;
  {
    const std::lock_guard lock(bed.mutex);
    bed.Break();
  }
  if (!std::exchange(bed.listed, false))
    return;
  GError* error = nullptr;
  umockdev_testbed_detach_ioctl(bed.bed.get(), bed.Node().c_str(), &error);
  g_clear_error(&error);
  umockdev_testbed_remove_device(bed.bed.get(), ("/sys" + std::string(SysPath)).c_str());
}

void FalconTestbed::BreakAfter(int transfers)
{
  const std::lock_guard lock(this->Bed->mutex);
  this->Bed->breakAfter = transfers;
}

void FalconTestbed::SetBusy(bool busy)
{
  const std::lock_guard lock(this->Bed->mutex);
  this->Bed->busy = busy;
}

void FalconTestbed::Forbid()
{
  const std::unique_ptr<gchar, decltype(&g_free)> root(
    umockdev_testbed_get_root_dir(this->Bed->bed.get()), g_free);
  // All else stays open, so that it is the node that forbids: umockdev makes sockets in its folder,
  // and connects to the node's.
  const std::string folder = root.get(), node = this->Bed->Node();
  if (chmod(folder.c_str(), 0777) != 0 || chmod((folder + "/ioctl" + node).c_str(), 0777) != 0 ||
      chmod((folder + node).c_str(), 0) != 0)
    throw std::runtime_error("cannot change the node's mode");
}

} // namespace hasp
