// The driver and an FTDI chip that none of us wrote: QEMU's own. It answers our requests by its own
// understanding of them, adds the status bytes, and sets the speed of a line at whose other end,
// outside of the guest, a model listens (ServeFalcon.cxx).
#include "GuestFalconBench.h"

#include <libusb.h>

#include <dlfcn.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <filesystem>

namespace
{

using namespace hasp;
using namespace hasp::test;

constexpr std::uint16_t QemuProduct = 0x6001;
bool passesForFalcon = false;

/// How many interfaces the kernel's own driver of FTDI chips has.
std::ptrdiff_t KernelHas()
{
  std::ptrdiff_t count = 0;
  const std::filesystem::path driver = "/sys/bus/usb/drivers/ftdi_sio";
  for (const auto& entry : std::filesystem::directory_iterator(driver))
    count += entry.path().filename().string().find(':') != std::string::npos ? 1 : 0;
  return count;
}

class GuestSerial : public GuestFalconBench
{
protected:
  GuestSerial() { passesForFalcon = true; }
  ~GuestSerial() override { passesForFalcon = false; }
};

TEST_F(GuestSerial, QemusChipIsUnderstood)
{
  ASSERT_TRUE(Becomes([] { return KernelHas() == 1; })) << "the kernel's driver takes it first";
  auto driver = this->Driver();
  const auto start = std::chrono::steady_clock::now();
  driver.Open({});
  EXPECT_EQ(KernelHas(), 0) << "it is put aside";
  ASSERT_TRUE(Becomes([&] { return this->Fresh(driver).homed; }));
  std::printf("guest: booted and homed in %.2f s\n", SecondsSince(start));

  const auto exchanges = std::chrono::steady_clock::now();
  for (int n = 0; n < 300; ++n)
  {
    // The model's grip hangs on a spring of 0.2 N/mm: where it goes shows the force that it felt.
    const glm::dvec3 force{ 2 * std::cos(0.02 * n), 1.0, -2 * std::sin(0.03 * n) };
    const glm::dvec3 wantedMm = 5.0 * force;
    // Motors are told by the pose that was read last, so it needs some exchanges to get there.
    if (n % 25 == 0)
    {
      EXPECT_TRUE(Becomes(
        [&] { return glm::distance(this->Fresh(driver, force).pose.position, wantedMm) < 0.3; }))
        << n;
    }
    this->Fresh(driver, force);
  }
  this->Report("QEMU's chip", driver, SecondsSince(exchanges));
  driver.Close();
  EXPECT_TRUE(Becomes([] { return KernelHas() == 1; })) << "the kernel's driver has it again";
}

} // namespace

/// For our library this one stands before libusb's: the number of QEMU's product is its maker's,
/// and nothing else of it is changed on the way to a driver that knows one product only.
extern "C" int libusb_get_device_descriptor(
  libusb_device* device, libusb_device_descriptor* descriptor)
{
  using Real = int (*)(libusb_device*, libusb_device_descriptor*);
  static const auto real = reinterpret_cast<Real>(dlsym(RTLD_NEXT, "libusb_get_device_descriptor"));
  const int code = real(device, descriptor);
  if (passesForFalcon && descriptor->idVendor == FalconVendor &&
      descriptor->idProduct == QemuProduct)
    descriptor->idProduct = FalconProduct;
  return code;
}
