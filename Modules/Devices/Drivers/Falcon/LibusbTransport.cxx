#include "Devices/Drivers/Falcon/LibusbTransport.h"

#include "Devices/Drivers/DeviceError.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
constexpr int Interface = 0;
constexpr unsigned ControlMs = 1000;

template <auto Function>
struct Call
{
  template <typename T>
  void operator()(T* pointer) const
  {
    Function(pointer);
  }
};
using Context = std::unique_ptr<libusb_context, Call<libusb_exit>>;
using Handle = std::unique_ptr<libusb_device_handle, Call<libusb_close>>;
using Config = std::unique_ptr<libusb_config_descriptor, Call<libusb_free_config_descriptor>>;

[[noreturn]] void Refuse(DeviceTrouble trouble, const std::string& sentence)
{
  throw DeviceError(trouble, "Falcon: " + sentence);
}

/// libusb's error as ours. It names none of what the user has to do.
[[noreturn]] void RefuseCode(int code)
{
  switch (code)
  {
    case LIBUSB_ERROR_ACCESS:
      Refuse(DeviceTrouble::Permission,
        "it is plugged in, but this account may not use it; let an administrator install the udev "
        "rule"
        " that hasp devices --udev-rules prints, then plug it in again");
    case LIBUSB_ERROR_BUSY:
      Refuse(DeviceTrouble::Busy, "another program has it; end that program and try again");
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      Refuse(DeviceTrouble::Gone, "it was unplugged; plug it in again");
    case LIBUSB_ERROR_IO:
      Refuse(DeviceTrouble::Gone, "its connection broke; look at the cable, and plug it in again");
    case LIBUSB_ERROR_PIPE:
      Refuse(DeviceTrouble::Protocol, "it refuses what it was asked; switch it off and on");
    default:
      Refuse(DeviceTrouble::Protocol, "USB does not work with it (" +
                                        std::string(libusb_error_name(code)) +
                                        "); plug it out and in again");
  }
}

int Check(int code)
{
  if (code < 0)
    RefuseCode(code);
  return code;
}

Context NewContext()
{
  libusb_context* context = nullptr;
  if (libusb_init(&context) != 0)
    Refuse(DeviceTrouble::Absent, "this system shows no USB devices");
  return Context(context);
}

/// "1-2.3": the bus, and the sockets on the way.
std::string PortOf(libusb_device* device)
{
  std::array<std::uint8_t, 8> sockets{};
  const int depth = libusb_get_port_numbers(device, sockets.data(), sockets.size());
  std::string port = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < depth; ++i)
  {
    port += i == 0 ? '-' : '.';
    port += std::to_string(sockets[i]);
  }
  return port;
}

/// The Falcons of a bus, held for as long as this is.
class Falcons
{
public:
  explicit Falcons(libusb_context* context)
  {
    const auto count = libusb_get_device_list(context, &this->All);
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      libusb_device_descriptor descriptor{};
      if (libusb_get_device_descriptor(this->All[i], &descriptor) == 0 &&
          descriptor.idVendor == FalconVendor && descriptor.idProduct == FalconProduct)
        this->Found.push_back({ PortOf(this->All[i]), this->All[i] });
    }
    std::sort(this->Found.begin(), this->Found.end(),
      [](const One& a, const One& b) { return a.port < b.port; });
  }
  ~Falcons()
  {
    if (this->All)
      libusb_free_device_list(this->All, 1);
  }
  Falcons(const Falcons&) = delete;
  Falcons& operator=(const Falcons&) = delete;

  struct One
  {
    std::string port;
    libusb_device* device;
  };
  auto begin() const { return this->Found.begin(); }
  auto end() const { return this->Found.end(); }

private:
  libusb_device** All = nullptr;
  std::vector<One> Found;
};

/// An opened device whose interface is ours.
class Claim
{
public:
  explicit Claim(libusb_device* device)
  {
    libusb_device_handle* handle = nullptr;
    Check(libusb_open(device, &handle));
    this->Device.reset(handle);
    // Where the system cannot, no kernel driver is in the way either.
    libusb_set_auto_detach_kernel_driver(handle, 1);
    Check(libusb_claim_interface(handle, Interface));
  }
  ~Claim()
  {
    if (this->Device)
      libusb_release_interface(this->Device.get(), Interface); // what was not claimed, is not found
  }
  Claim(Claim&&) = default;

  libusb_device_handle* Get() const { return this->Device.get(); }

private:
  Handle Device;
};
} // namespace

/// From Open to Close; members are undone in the opposite order.
class LibusbTransport::Session
{
public:
  explicit Session(const std::string& port)
    : Bus(NewContext()),
      Device(ClaimOne(this->Bus.get(), port))
  {
    libusb_config_descriptor* given = nullptr;
    Check(libusb_get_active_config_descriptor(libusb_get_device(this->Device.Get()), &given));
    const Config config(given);
    if (config->bNumInterfaces > Interface && config->interface[Interface].num_altsetting > 0)
    {
      const auto& first = config->interface[Interface].altsetting[0];
      for (int i = first.bNumEndpoints; i-- > 0;) // the first of each stays
        this->TakeEndpoint(first.endpoint[i]);
    }
    if (this->In == 0 || this->Out == 0)
      Refuse(DeviceTrouble::Protocol, "it has no endpoints for data; is it a Falcon?");
  }

  libusb_device_handle* Get() const { return this->Device.Get(); }

  /// How many bytes went; a time that is over is no error.
  std::size_t Transfer(std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size, int timeoutMs)
  {
    int done = 0;
    const int code = libusb_bulk_transfer(this->Get(), endpoint, bytes, static_cast<int>(size),
      &done, static_cast<unsigned>(timeoutMs));
    if (code != LIBUSB_ERROR_TIMEOUT)
      Check(code);
    return static_cast<std::size_t>(done);
  }

  std::uint8_t In = 0, Out = 0;

private:
  /// Throws the first one's trouble where none can be had.
  static Claim ClaimOne(libusb_context* context, const std::string& port)
  {
    const Falcons all(context);
    std::optional<DeviceError> trouble;
    for (const auto& falcon : all)
      try
      {
        if (port.empty() || falcon.port == port)
          return Claim(falcon.device);
      }
      catch (const DeviceError& error)
      {
        if (!trouble)
          trouble = error;
      }
    if (trouble)
      throw *trouble;
    Refuse(DeviceTrouble::Absent,
      (port.empty() ? "none is plugged in" : "none is plugged in at \"" + port + "\"") +
        std::string("; it needs its USB cable and its own power supply"));
  }

  void TakeEndpoint(const libusb_endpoint_descriptor& endpoint)
  {
    if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK)
      return;
    const bool in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN;
    (in ? this->In : this->Out) = endpoint.bEndpointAddress;
  }

  Context Bus;
  Claim Device;
};

LibusbTransport::LibusbTransport(std::string port) : Port(std::move(port)) {}

LibusbTransport::~LibusbTransport() = default;

void LibusbTransport::Open()
{
  this->Close();
  this->Device = std::make_unique<Session>(this->Port);
}

void LibusbTransport::Close() noexcept
{
  this->Device.reset();
}

LibusbTransport::Session& LibusbTransport::Opened() const
{
  if (!this->Device)
    Refuse(DeviceTrouble::Gone, "it is not open");
  return *this->Device;
}

void LibusbTransport::Control(std::uint8_t request, std::uint16_t value)
{
  // wIndex 0: an FTDI chip with one line.
  constexpr auto toDevice =
    static_cast<std::uint8_t>(int{ LIBUSB_ENDPOINT_OUT } | int{ LIBUSB_REQUEST_TYPE_VENDOR });
  Check(libusb_control_transfer(
    this->Opened().Get(), toDevice, request, value, 0, nullptr, 0, ControlMs));
}

std::size_t LibusbTransport::Read(std::span<std::uint8_t> bytes, int timeoutMs)
{
  auto& device = this->Opened();
  return device.Transfer(device.In, bytes.data(), bytes.size(), timeoutMs);
}

std::size_t LibusbTransport::Write(std::span<const std::uint8_t> bytes, int timeoutMs)
{
  auto& device = this->Opened();
  // libusb does not write to what goes out; its functions have one signature for both ways.
  return device.Transfer(
    device.Out, const_cast<std::uint8_t*>(bytes.data()), bytes.size(), timeoutMs);
}

} // namespace hasp
