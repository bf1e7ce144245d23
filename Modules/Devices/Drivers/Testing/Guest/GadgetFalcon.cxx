#include "GadgetFalcon.h"

#include <fcntl.h>
#include <linux/usb/functionfs.h>
#include <poll.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>

// Numbers of USB are little-endian, as the only machine is that this is for.
namespace hasp::test
{

namespace
{
const std::string Gadget = "/sys/kernel/config/usb_gadget/falcon";
const std::string Function = Gadget + "/functions/ffs.falcon", Config = Gadget + "/configs/c.1";
const std::string Names = Gadget + "/strings/0x409", Link = Config + "/ffs.falcon";
const std::string Endpoints = "/endpoints";

void Require(bool good, const std::string& what)
{
  if (!good)
    throw std::system_error(errno, std::generic_category(), what);
}

void WriteAll(int file, const void* bytes, std::size_t size, const std::string& what)
{
  Require(write(file, bytes, size) == static_cast<ssize_t>(size), what);
}

void SetFile(const std::string& file, const std::string& text)
{
  const int handle = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  Require(handle >= 0, file);
  const bool written = write(handle, text.data(), text.size()) > 0;
  const int error = errno;
  close(handle);
  errno = error;
  Require(written, file);
}

int OpenEndpoint(const char* name)
{
  // Not blocking is about an endpoint that nobody is plugged into: with one that is, reads and
  // writes wait for the host, and end where it is unplugged.
  const int endpoint = open((Endpoints + "/" + name).c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  Require(endpoint >= 0, name);
  return endpoint;
}

struct [[gnu::packed]] Descriptors
{
  usb_functionfs_descs_head_v2 head;
  __le32 fullSpeedCount;
  usb_interface_descriptor face;
  usb_endpoint_descriptor_no_audio in, out;
};
struct [[gnu::packed]] Strings
{
  usb_functionfs_strings_head head;
  __le16 language;
  char name[7];
};

/// What the FTDI chip says of itself: two bulk endpoints, packets of 64 bytes.
void Describe(int control)
{
  Descriptors is{};
  is.head.magic = FUNCTIONFS_DESCRIPTORS_MAGIC_V2;
  // Vendor requests are to the device, and so would be the kernel's to refuse, but for this flag.
  is.head.flags = FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_ALL_CTRL_RECIP;
  is.head.length = sizeof is;
  is.fullSpeedCount = 3;
  is.face = { sizeof is.face, USB_DT_INTERFACE, 0, 0, 2, 0xff, 0xff, 0xff, 1 };
  is.in = { sizeof is.in, USB_DT_ENDPOINT, 0x81, USB_ENDPOINT_XFER_BULK, 64, 0 };
  is.out = { sizeof is.out, USB_DT_ENDPOINT, 0x02, USB_ENDPOINT_XFER_BULK, 64, 0 };
  WriteAll(control, &is, sizeof is, "descriptors");
  Strings names{};
  names.head = { FUNCTIONFS_STRINGS_MAGIC, sizeof names, 1, 1 };
  names.language = 0x409;
  std::strcpy(names.name, "falcon");
  WriteAll(control, &names, sizeof names, "strings");
}
} // namespace

GadgetFalcon::GadgetFalcon()
{
  for (const auto& folder : { Gadget, Names, Config, Function })
    Require(mkdir(folder.c_str(), 0755) == 0, folder);
  SetFile(Gadget + "/idVendor", "0x0403");
  SetFile(Gadget + "/idProduct", "0xcb48");
  SetFile(Names + "/product", "a Falcon's model");
  Require(symlink(Function.c_str(), Link.c_str()) == 0, Link);
  mkdir(Endpoints.c_str(), 0755);
  Require(mount("falcon", Endpoints.c_str(), "functionfs", 0, nullptr) == 0, "functionfs");
  this->Control = OpenEndpoint("ep0");
  Describe(this->Control);
  this->In = OpenEndpoint("ep1");
  this->Out = OpenEndpoint("ep2");
  this->ControlThread = std::jthread([this](const std::stop_token& s) { this->ServeControl(s); });
  this->InThread = std::jthread([this](const std::stop_token& s) { this->ServeIn(s); });
  this->OutThread = std::jthread([this](const std::stop_token& s) { this->ServeOut(s); });
  this->Plug();
}

GadgetFalcon::~GadgetFalcon()
{
  this->Unplug();
  for (std::jthread* thread : { &this->ControlThread, &this->InThread, &this->OutThread })
  {
    thread->request_stop();
    thread->join();
  }
  for (const int endpoint : { this->In, this->Out, this->Control })
    close(endpoint);
  umount(Endpoints.c_str());
  unlink(Link.c_str());
  for (const auto& folder : { Function, Config, Names, Gadget })
    rmdir(folder.c_str());
}

void GadgetFalcon::Plug()
{
  const auto sockets = std::filesystem::directory_iterator("/sys/class/udc");
  SetFile(Gadget + "/UDC", sockets->path().filename().string());
}

void GadgetFalcon::Unplug()
{
  try
  {
    SetFile(Gadget + "/UDC", "\n");
  }
  catch (const std::system_error&)
  {
    // It is not plugged in.
  }
}

void GadgetFalcon::With(const std::function<void(FalconModel&)>& use)
{
  const std::lock_guard lock(this->Lock);
  use(this->Model);
}

void GadgetFalcon::SetClock()
{
  this->Model.nowNs =
    std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void GadgetFalcon::ServeControl(const std::stop_token& stop)
{
  while (!stop.stop_requested())
  {
    pollfd waits{ this->Control, POLLIN, 0 };
    usb_functionfs_event event{};
    if (poll(&waits, 1, /*ms, until it looks at stop*/ 20) <= 0 ||
        read(this->Control, &event, sizeof event) != static_cast<ssize_t>(sizeof event) ||
        event.type != FUNCTIONFS_SETUP)
      continue;
    const usb_ctrlrequest& asks = event.u.setup;
    bool takes = asks.bRequestType == (USB_DIR_OUT | USB_TYPE_VENDOR) && asks.wLength == 0;
    if (takes)
    {
      const std::lock_guard lock(this->Lock);
      this->SetClock();
      takes = this->Model.Control(asks.bRequest, asks.wValue);
    }
    // Going on in the direction of the request says yes, in the other no. The host may have gone.
    const bool toHost = asks.bRequestType & USB_DIR_IN;
    [[maybe_unused]] const auto done =
      takes == toHost ? write(this->Control, nullptr, 0) : read(this->Control, nullptr, 0);
  }
}

void GadgetFalcon::ServeOut(const std::stop_token& stop)
{
  std::array<std::uint8_t, 512> bytes;
  while (!stop.stop_requested())
  {
    const ssize_t size = read(this->Out, bytes.data(), bytes.size());
    if (size <= 0) // unplugged
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    {
      const std::lock_guard lock(this->Lock);
      this->SetClock();
      this->Model.Receive(std::span(bytes).first(static_cast<std::size_t>(size)));
      this->Heard.notify_all();
    }
    const std::int64_t before = this->BytesUntilUnplug;
    this->BytesUntilUnplug = std::max<std::int64_t>(0, before - size);
    if (before > 0 && before <= size)
      this->Unplug();
  }
}

void GadgetFalcon::ServeIn(const std::stop_token& stop)
{
  while (!stop.stop_requested())
  {
    std::array<std::uint8_t, 64> packet;
    std::size_t size = 0;
    {
      // The chip sends what it has, or after its latency that it has nothing. By steps of a
      // millisecond, for answers that are not yet due: nobody tells when they are.
      std::unique_lock lock(this->Lock);
      this->SetClock();
      const std::int64_t beganNs = this->Model.nowNs;
      while (!this->Model.HasAnswer() &&
             this->Model.nowNs - beganNs < this->Model.LatencyMs() * std::int64_t{ 1'000'000 })
      {
        this->Heard.wait_for(lock, std::chrono::milliseconds(1));
        this->SetClock();
      }
      size = this->Model.Send(packet);
    }
    if (write(this->In, packet.data(), size) < 0) // unplugged, and what was on its way is lost
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

} // namespace hasp::test
