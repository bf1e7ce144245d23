#include "Devices/Drivers/SpaceMouse/HidapiTransport.h"

#include <hidapi/hidapi.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>

namespace hasp
{

namespace
{
/// hidapi is begun and ended once, however many use it; and what it keeps for the whole process,
/// the sentence of its last error, is for one thread at a time: held while anything of hidapi is
/// called that is about no open device.
class HidapiUse
{
public:
  HidapiUse() : Lock(Mutex)
  {
    if (Users == 0 && hid_init() != 0)
      throw DeviceError(DeviceTrouble::Absent, "hidapi does not start: install it anew");
    ++Users;
  }
  ~HidapiUse()
  {
    if (--Users == 0)
      hid_exit();
  }
  HidapiUse(const HidapiUse&) = delete;
  HidapiUse& operator=(const HidapiUse&) = delete;

  void OpenOne() noexcept { ++Users; } ///< a device that is open is a user
  void CloseOne() noexcept { --Users; }

private:
  static inline std::mutex Mutex;
  static inline int Users = 0;
  std::unique_lock<std::mutex> Lock;
};

std::string Utf8(const wchar_t* text)
{
  std::string utf8;
  for (; text && *text; ++text)
  {
    const auto c = static_cast<std::uint32_t>(*text);
    const auto add = [&](std::uint32_t byte) { utf8.push_back(static_cast<char>(byte)); };
    if (c < 0x80)
      add(c);
    else if (c < 0x800)
    {
      add(0xc0 | c >> 6);
      add(0x80 | (c & 0x3f));
    }
    else if (c < 0x10000 && (c < 0xd800 || c > 0xdfff))
    {
      add(0xe0 | c >> 12);
      add(0x80 | (c >> 6 & 0x3f));
      add(0x80 | (c & 0x3f));
    }
    else // no name of a device is written in what lies beyond
      add('?');
  }
  return utf8;
}

std::optional<DeviceTrouble> TroubleOf(int error) noexcept
{
  switch (error)
  {
    case 0:
      return {};
    case EACCES:
    case EPERM:
      return DeviceTrouble::Permission;
    case EBUSY:
      return DeviceTrouble::Busy;
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case EIO:
      return DeviceTrouble::Absent;
    default:
      return DeviceTrouble::Protocol;
  }
}

/// A SpaceMouse that is there, as hidapi lists it.
struct Listed
{
  HidCollection collection;
  const SpaceMouseModel* model = nullptr; ///< never null
};

/// All of them, in the order of the system.
std::vector<Listed> Enumerate()
{
  std::vector<Listed> listed;
  const std::unique_ptr<hid_device_info, void (*)(hid_device_info*)> all(
    hid_enumerate(0, 0), hid_free_enumeration);
  for (const hid_device_info* one = all.get(); one; one = one->next)
  {
    const HidCollection collection{ one->path ? one->path : "", one->vendor_id, one->product_id,
      one->usage_page, one->usage, Utf8(one->product_string) };
    if (const SpaceMouseModel* model = SpaceMouseOf(collection))
      listed.push_back({ collection, model });
  }
  return listed;
}

DeviceError NoneThere()
{
  return { DeviceTrouble::Absent,
    "no SpaceMouse is there: plug it in, or switch it on and see that its receiver is plugged in" };
}

/// error: of the system; 0: it opens, and is no HID device
DeviceError WhyNotOpen(int error, const std::string& name)
{
  const std::optional<DeviceTrouble> trouble = TroubleOf(error);
  if (trouble == DeviceTrouble::Absent) // unplugged since it was found
    return NoneThere();
  if (trouble == DeviceTrouble::Permission)
    return { *trouble, "the " + name +
                         " is there, and this user may not read it: add the udev rules"
                         " (hasp devices --udev-rules), then unplug it and plug it in again" };
  if (trouble == DeviceTrouble::Busy)
    return { *trouble, "the " + name + " is in use by another program: end that one" };
  const std::string why = trouble
                            ? "cannot be opened (" + std::generic_category().message(error) + ")"
                            : "does not answer as a HID device";
  return { DeviceTrouble::Protocol,
    "the " + name + " " + why + ": unplug it and plug it in again" };
}

DeviceError WhyGone()
{
  return { DeviceTrouble::Gone,
    "the SpaceMouse is gone: plug it in again, or switch it on, and it goes on by itself" };
}

/// Why a node that hidapi did not open does not open: hidapi keeps the number to itself. 0 if it
/// does.
int OpeningError(const std::string& path) noexcept
{
  const int handle = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (handle < 0)
    return errno;
  close(handle);
  return 0;
}
} // namespace

HidapiTransport::HidapiTransport(std::string path) : Path(std::move(path)) {}

HidapiTransport::~HidapiTransport()
{
  this->Close();
}

HidCollection HidapiTransport::Open()
{
  this->Close();
  HidapiUse use;
  DeviceError why = NoneThere();
  for (const Listed& mouse : Enumerate())
  {
    const std::string& path = mouse.collection.path;
    if (!this->Path.empty() && path != this->Path)
      continue;
    this->OpenPath = path;
    this->Handle = hid_open_path(path.c_str());
    if (this->Handle)
    {
      use.OpenOne();
      return mouse.collection;
    }
    why = WhyNotOpen(OpeningError(path), mouse.model->name);
  }
  throw why;
}

std::size_t HidapiTransport::Read(std::span<std::byte> report, int timeoutMs)
{
  if (!this->Handle)
    throw WhyGone();
  errno = 0;
  const int bytes = hid_read_timeout(this->Handle, reinterpret_cast<unsigned char*>(report.data()),
    report.size(), std::max(timeoutMs, 0));
  if (bytes >= 0)
    return static_cast<std::size_t>(bytes);
  if (errno == EINTR) // a signal came, and no report
    return 0;
  throw WhyGone();
}

void HidapiTransport::Write(std::span<const std::byte> report)
{
  if (!this->Handle || hid_write(this->Handle,
                         reinterpret_cast<const unsigned char*>(report.data()), report.size()) < 0)
    throw WhyGone();
}

std::vector<std::byte> HidapiTransport::ReportDescriptor()
{
  const std::string node = this->OpenPath.substr(this->OpenPath.rfind('/') + 1);
  const std::string file = "/sys/class/hidraw/" + node + "/device/report_descriptor";
  std::vector<std::byte> bytes(4096); // HID_MAX_DESCRIPTOR_SIZE of Linux
  std::size_t size = 0;
  const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0)
    return {};
  ssize_t came = 1;
  while (size < bytes.size() && came > 0)
  {
    came = read(handle, bytes.data() + size, bytes.size() - size);
    size += came > 0 ? static_cast<std::size_t>(came) : 0;
  }
  close(handle);
  bytes.resize(size);
  return bytes;
}

void HidapiTransport::Close() noexcept
{
  if (!this->Handle)
    return;
  HidapiUse use;
  hid_close(this->Handle);
  use.CloseOne();
  this->Handle = nullptr;
  this->OpenPath.clear();
}

} // namespace hasp
