#include "Devices/Drivers/Testing/FakeHidraw.h"

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace hasp::test
{

namespace
{
template <class... Values>
std::string Printed(const char* format, Values... values)
{
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string Hex(const Bytes& bytes)
{
  std::string hex;
  for (const std::byte byte : bytes)
    hex += Printed("%02X", std::to_integer<unsigned>(byte));
  return hex;
}

void MustHaveWorked(GError* error)
{
  if (!error)
    return;
  ADD_FAILURE() << error->message;
  g_error_free(error);
}
} // namespace

bool FakeHidraw::Works()
{
  // umockdev_in_mock_environment of 0.17.16 says no under its own wrapper too.
  return dlopen("libumockdev-preload.so.0", RTLD_LAZY | RTLD_NOLOAD) != nullptr;
}

void FakeHidraw::Plug(int number, const HidCollection& is, const Bytes& descriptor, bool wired)
{
  auto node = std::make_unique<Node>();
  node->Descriptor = descriptor;

  // As udevadm info --export-db has it, from the node up to the bus.
  const std::string usb = Printed("/devices/pci0000:00/0000:00:14.0/usb1/1-%d", number + 1);
  const std::string face = usb + Printed("/1-%d:1.0", number + 1);
  const std::string hid =
    (wired ? face : std::string("/devices/virtual/misc/uhid")) +
    Printed("/%04X:%04X:%04X.%04X", wired ? 3 : 5, is.vendor, is.product, number + 1);
  const std::string raw = hid + Printed("/hidraw/hidraw%d", number);
  std::string db =
    "P: " + raw + Printed("\nN: hidraw%d\nE: DEVNAME=/dev/hidraw%d\n", number, number) +
    Printed("E: MAJOR=240\nE: MINOR=%d\nE: SUBSYSTEM=hidraw\nA: dev=240:%d\\n\n", number, number) +
    "L: device=../../../" + hid.substr(hid.rfind('/') + 1) + "\n\n";
  db += "P: " + hid +
        Printed("\nE: HID_ID=%04X:%08X:%08X\n", wired ? 3 : 5, is.vendor, is.product) +
        "E: HID_NAME=" + is.productName + "\nE: HID_UNIQ=\nE: SUBSYSTEM=hid\n" +
        "H: report_descriptor=" + Hex(descriptor) + "\n\n";
  node->SysPaths = { "/sys" + raw, "/sys" + hid };
  if (wired)
  {
    db +=
      "P: " + face + "\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n\n";
    db += "P: " + usb + "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: bcdDevice=0435\\n\n" +
          Printed("A: idVendor=%04x\\n\nA: idProduct=%04x\\n\n", is.vendor, is.product) +
          "A: manufacturer=3Dconnexion\\n\nA: product=" + is.productName + "\\n\n\n";
    node->SysPaths.push_back("/sys" + face);
    node->SysPaths.push_back("/sys" + usb);
  }
  GError* error = nullptr;
  umockdev_testbed_add_from_string(this->Bed, db.c_str(), &error);
  MustHaveWorked(error);

  node->Answers = UMOCKDEV_IOCTL_BASE(g_object_new(UMOCKDEV_TYPE_IOCTL_BASE, nullptr));
  g_signal_connect(node->Answers, "handle-ioctl", G_CALLBACK(OnIoctl), node.get());
  g_signal_connect(node->Answers, "handle-read", G_CALLBACK(OnRead), node.get());
  g_signal_connect(node->Answers, "handle-write", G_CALLBACK(OnWrite), node.get());
  error = nullptr;
  umockdev_testbed_attach_ioctl(this->Bed, DevicePath(number).c_str(), node->Answers, &error);
  MustHaveWorked(error);

  // What the node is made of is ready as long as a byte waits in it, which nobody ever takes.
  const int inside = umockdev_testbed_get_dev_fd(this->Bed, DevicePath(number).c_str());
  EXPECT_EQ(write(inside, "x", 1), 1);
  this->Nodes[number] = std::move(node);
}

void FakeHidraw::Unplug(int number)
{
  auto node = std::move(this->Nodes.at(number));
  this->Nodes.erase(number);
  {
    const std::lock_guard lock(node->Lock);
    node->ReadsUntilError = 0;
    node->Error = ENODEV;
    node->WritesRefused = true;
  }
  GError* error = nullptr;
  umockdev_testbed_detach_ioctl(this->Bed, DevicePath(number).c_str(), &error);
  MustHaveWorked(error);
  for (const std::string& path : node->SysPaths)
    umockdev_testbed_remove_device(this->Bed, path.c_str());
  g_object_unref(node->Answers);
  this->Gone.push_back(std::move(node));
}

void FakeHidraw::Say(int number, const Bytes& report)
{
  Node& node = *this->Nodes.at(number);
  const std::lock_guard lock(node.Lock);
  node.Reports.push_back(report);
}

void FakeHidraw::FailReads(int number, int more, int error)
{
  Node& node = *this->Nodes.at(number);
  const std::lock_guard lock(node.Lock);
  node.ReadsUntilError = more;
  node.Error = error;
}

void FakeHidraw::RefuseWrites(int number, bool refused)
{
  Node& node = *this->Nodes.at(number);
  const std::lock_guard lock(node.Lock);
  node.WritesRefused = refused;
}

std::vector<Bytes> FakeHidraw::Written(int number)
{
  Node& node = *this->Nodes.at(number);
  const std::lock_guard lock(node.Lock);
  return node.Written;
}

std::size_t FakeHidraw::Unread(int number)
{
  Node& node = *this->Nodes.at(number);
  const std::lock_guard lock(node.Lock);
  return node.Reports.size();
}

std::string FakeHidraw::RealPath(int number) const
{
  gchar* const root = umockdev_testbed_get_root_dir(this->Bed);
  const std::string path = root + DevicePath(number);
  g_free(root);
  return path;
}

gboolean FakeHidraw::OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  Node& node = *static_cast<Node*>(data);
  UMockdevIoctlData* const arg = umockdev_ioctl_client_get_arg(client);
  const auto answer = [&](const void* bytes, std::size_t size)
  {
    GError* error = nullptr;
    UMockdevIoctlData* const into = umockdev_ioctl_data_resolve(arg, 0, size, &error);
    MustHaveWorked(error);
    std::memcpy(into->data, bytes, size);
    umockdev_ioctl_client_complete(client, 0, 0);
    g_object_unref(into);
  };
  const gulong request = umockdev_ioctl_client_get_request(client);
  if (request == HIDIOCGRDESCSIZE)
  {
    const int size = static_cast<int>(node.Descriptor.size());
    answer(&size, sizeof size);
  }
  else if (request == HIDIOCGRDESC)
  {
    hidraw_report_descriptor said{};
    said.size = static_cast<__u32>(node.Descriptor.size());
    std::memcpy(said.value, node.Descriptor.data(), node.Descriptor.size());
    answer(&said, sizeof said);
  }
  else
    umockdev_ioctl_client_complete(client, -1, ENOTTY);
  return TRUE;
}

gboolean FakeHidraw::OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  Node& node = *static_cast<Node*>(data);
  const std::lock_guard lock(node.Lock);
  if (node.ReadsUntilError == 0)
    umockdev_ioctl_client_complete(client, -1, node.Error);
  else if (node.Reports.empty())
    umockdev_ioctl_client_complete(client, -1, EAGAIN);
  else
  {
    UMockdevIoctlData* const into = umockdev_ioctl_client_get_arg(client);
    const Bytes report = node.Reports.front();
    node.Reports.pop_front();
    const std::size_t size = std::min(report.size(), static_cast<std::size_t>(into->data_len));
    std::memcpy(into->data, report.data(), size);
    umockdev_ioctl_client_complete(client, static_cast<glong>(size), 0);
  }
  if (node.ReadsUntilError > 0)
    --node.ReadsUntilError;
  return TRUE;
}

gboolean FakeHidraw::OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  Node& node = *static_cast<Node*>(data);
  const std::lock_guard lock(node.Lock);
  if (node.WritesRefused)
  {
    umockdev_ioctl_client_complete(client, -1, EIO);
    return TRUE;
  }
  UMockdevIoctlData* const from = umockdev_ioctl_client_get_arg(client);
  const auto* const bytes = reinterpret_cast<const std::byte*>(from->data);
  node.Written.emplace_back(bytes, bytes + from->data_len);
  umockdev_ioctl_client_complete(client, from->data_len, 0);
  return TRUE;
}

} // namespace hasp::test
