#include "Devices/Drivers/DeviceSearch.h"

#include "Devices/Drivers/SpaceMouse/SpaceMouseModels.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

namespace hasp
{

namespace
{
namespace fs = std::filesystem;

constexpr std::string_view FalconVendor = "0403", FalconProduct = "cb48";
constexpr std::size_t MostBytes = 8192; // of what the kernel says in one file
// Generic desktop, multi-axis controller: the first two items of the descriptor's collection.
constexpr std::array<unsigned char, 4> MultiAxis{ 0x05, 0x01, 0x09, 0x08 };
const char* const Rules = "it is not yours to use; install the udev rule (hasp devices --udev-rules"
                          " prints it and says how) and plug it in again";

/// Empty for what cannot be read.
std::string ReadAll(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string text(MostBytes, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  return text;
}

std::string ReadLine(const fs::path& file)
{
  const std::string text = ReadAll(file);
  return text.substr(0, text.find_last_not_of(" \n") + 1);
}

template <class Number>
std::optional<Number> Parse(std::string_view text, int base)
{
  Number number{};
  const auto end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number, base);
  if (error != std::errc() || at != end)
    return {};
  return number;
}

/// In the order of their names; nothing where there is no such folder.
std::vector<fs::path> EntriesOf(const fs::path& folder)
{
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(entry->path());
  std::ranges::sort(entries);
  return entries;
}

void SayWhy(FoundDevice& device, const fs::path& node, bool built, const char* option)
{
  device.mayOpen = ::access(node.c_str(), R_OK | W_OK) == 0;
  device.driver = built;
  if (!built)
    device.remedy =
      std::string("this build of Hasp has no driver for it; configure it with ") + option + "=ON";
  else if (!device.mayOpen)
    device.remedy = Rules;
}

void FindOnUsb(const DeviceFolders& folders, std::vector<FoundDevice>& found)
{
  for (const fs::path& entry : EntriesOf(folders.sys / "bus/usb/devices"))
  {
    if (ReadLine(entry / "idVendor") != FalconVendor ||
        ReadLine(entry / "idProduct") != FalconProduct)
      continue;
    const auto bus = Parse<int>(ReadLine(entry / "busnum"), 10);
    const auto number = Parse<int>(ReadLine(entry / "devnum"), 10);
    if (!bus || !number)
      continue;
    char node[32];
    std::snprintf(node, sizeof node, "bus/usb/%03d/%03d", *bus, *number);
    FoundDevice device{
      .address = "falcon:" + entry.filename().string(), .name = "Novint Falcon", .force = true
    };
    SayWhy(device, folders.dev / node, HASP_WITH_LIBUSB, "HASP_ENABLE_LIBUSB");
    found.push_back(device);
  }
}

/// What `key=` is followed by in lines of text.
std::string ValueOf(const std::string& text, const std::string& key)
{
  const std::size_t at = ("\n" + text).find("\n" + key + "=");
  if (at == std::string::npos)
    return {};
  const std::size_t from = at + key.size() + 1;
  return text.substr(from, text.find('\n', from) - from);
}

std::optional<HidCollection> CollectionOf(const fs::path& node)
{
  const std::string event = ReadAll(node / "device/uevent");
  const std::string id =
    ValueOf(event, "HID_ID"); // bus:vendor:product, as "0003:0000256F:0000C62E"
  const std::size_t first = id.find(':'), second = id.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos)
    return {};
  const std::string_view text = id;
  const auto vendor = Parse<std::uint32_t>(text.substr(first + 1, second - first - 1), 16);
  const auto product = Parse<std::uint32_t>(text.substr(second + 1), 16);
  if (!vendor || !product || *vendor > 0xffff || *product > 0xffff)
    return {};
  const std::string descriptor = ReadAll(node / "device/report_descriptor");
  HidCollection collection{ .path = node.filename().string(),
    .vendor = static_cast<std::uint16_t>(*vendor),
    .product = static_cast<std::uint16_t>(*product),
    .productName = ValueOf(event, "HID_NAME") };
  if (std::ranges::search(descriptor, MultiAxis,
        [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; })
        .begin() != descriptor.end())
  {
    collection.usagePage = 1;
    collection.usage = 8;
  }
  return collection;
}

void FindHid(const DeviceFolders& folders, std::vector<FoundDevice>& found)
{
  for (const fs::path& entry : EntriesOf(folders.sys / "class/hidraw"))
  {
    const auto collection = CollectionOf(entry);
    const SpaceMouseModel* model = collection ? SpaceMouseOf(*collection) : nullptr;
    if (model == nullptr)
      continue;
    const std::string node = entry.filename().string();
    FoundDevice device{ .address = "spacemouse:" + node, .name = model->name };
    SayWhy(device, folders.dev / node, HASP_WITH_HIDAPI, "HASP_ENABLE_HIDAPI");
    found.push_back(device);
  }
}

void FindSpacenav(const DeviceFolders& folders, std::vector<FoundDevice>& found)
{
  std::error_code error;
  if (!fs::is_socket(folders.spacenav, error))
    return;
  const bool usual = folders.spacenav == DeviceFolders{}.spacenav;
  FoundDevice device{ .address = usual ? "spacenav" : "spacenav:" + folders.spacenav.string(),
    .name = "6-DOF mouse of the spacenavd daemon" };
  device.mayOpen = ::access(folders.spacenav.c_str(), R_OK | W_OK) == 0;
  if (!device.mayOpen)
    device.remedy = "its socket is not yours to use; ask whoever set spacenavd up";
  found.push_back(device);
}
} // namespace

std::vector<FoundDevice> FindDevices(const DeviceFolders& folders)
{
  std::vector<FoundDevice> found;
  FindOnUsb(folders, found);
  FindHid(folders, found);
  FindSpacenav(folders, found);
  return found;
}

std::string FirstUsable(const std::vector<FoundDevice>& found)
{
  for (const bool force : { true, false })
    for (const FoundDevice& device : found)
      if (device.mayOpen && device.driver && device.force == force)
        return device.address;
  return {};
}

std::string WithPlace(const std::string& address, const std::vector<FoundDevice>& found)
{
  for (const FoundDevice& device : found)
    if (device.mayOpen && device.driver && device.address.starts_with(address + ":"))
      return device.address;
  return address;
}

} // namespace hasp
