// The whole Falcon driver over the system's own libusb, with umockdev in the kernel's place.
// Nothing here waits for a time or measures one: poll() on umockdev's nodes is always ready.
#include "FalconBench.h"
#include "FalconTestbed.h"

#include "Devices/Drivers/DeviceSearch.h"
#include "Devices/Drivers/Falcon/LibusbTransport.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <sys/syscall.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <thread>

using namespace hasp;

namespace
{
constexpr uid_t Nobody = 65534;

struct FalconUsb : testing::Test
{
  FalconTestbed bed;
  TemporaryFolder folder;
  DriverOpening how;

  /// Patient with a machine that is busy: what these tests are about is not how fast it is.
  FalconSettings Settings()
  {
    FalconSettings settings;
    settings.firmware = this->folder.File("image.bin", InventedFirmware()).string();
    settings.answerMs = 18;
    settings.mostSilence = 2'000;
    settings.bootTries = 100;
    settings.bootTimeBoxS = 80.0;
    return settings;
  }
  FalconDriver Driver()
  {
    return FalconDriver(std::make_unique<LibusbTransport>(), this->Settings());
  }

  /// Until an answer is fresh: where the machine pauses, one may be late.
  static DriverSample Fresh(FalconDriver& driver, const glm::dvec3& forceN = glm::dvec3(0.0))
  {
    for (;;) // 2,000 silences end it by DeviceError
      if (const auto sample = driver.Exchange({ forceN, {} }, 0); sample.fresh)
        return sample;
  }
  static DeviceTrouble Trouble(UsbTransport& usb, const std::string& words)
  {
    try
    {
      usb.Open();
    }
    catch (const DeviceError& error)
    {
      EXPECT_TRUE(Says(error.what(), words));
      return error.trouble;
    }
    ADD_FAILURE() << "it opened";
    return DeviceTrouble::Address;
  }
};

/// Root may open anything: for a while this process is not root.
class NotRoot
{
public:
  NotRoot() { EXPECT_TRUE(geteuid() != 0 || seteuid(Nobody) == 0); }
  ~NotRoot() { EXPECT_TRUE(getuid() != 0 || seteuid(0) == 0); }
};

std::ptrdiff_t OpenFiles()
{
  return std::distance(
    std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
}
} // namespace

TEST_F(FalconUsb, IsFoundWhereItIs)
{
  const auto found = FindDevices();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].address, "falcon:1-1");
  EXPECT_TRUE(found[0].mayOpen);
  EXPECT_EQ(found[0].remedy, "");

  LibusbTransport there("1-1"), elsewhere("1-2");
  there.Open();
  there.Close();
  EXPECT_EQ(this->Trouble(elsewhere, "at \"1-2\""), DeviceTrouble::Absent);

  this->bed.Unplug();
  EXPECT_TRUE(FindDevices().empty());
  EXPECT_EQ(this->Trouble(there, "none is plugged in"), DeviceTrouble::Absent);
  this->bed.Plug();
  there.Open();
}

TEST_F(FalconUsb, ForbiddenIsPermission)
{
  this->bed.Forbid();
  const NotRoot now;
  LibusbTransport usb;
  EXPECT_EQ(this->Trouble(usb, "udev rule"), DeviceTrouble::Permission);
  EXPECT_EQ(this->Trouble(usb, "hasp devices --udev-rules"), DeviceTrouble::Permission);
  const auto found = FindDevices();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].mayOpen, getuid() == 0) << "who is root for good may open anything";
}

TEST_F(FalconUsb, TakenIsBusy)
{
  this->bed.SetBusy(true);
  LibusbTransport usb;
  EXPECT_EQ(this->Trouble(usb, "another program"), DeviceTrouble::Busy);
  this->bed.SetBusy(false);
  usb.Open();
}

TEST_F(FalconUsb, ClosedOrRefusedIsAnError)
{
  LibusbTransport usb;
  EXPECT_THROW(usb.Control(0, 0), DeviceError);
  usb.Open();
  usb.Control(0, 1);
  try
  {
    usb.Control(77, 0); // no such request
    FAIL();
  }
  catch (const DeviceError& error)
  {
    EXPECT_EQ(error.trouble, DeviceTrouble::Protocol);
  }
  usb.Control(0, 1); // and goes on
}

TEST_F(FalconUsb, OpeningLeavesNothingBehind)
{
  LibusbTransport usb;
  usb.Open();
  usb.Close();
  const auto before = OpenFiles();
  constexpr int times = 200;
  for (int n = 0; n < times; ++n)
  {
    usb.Open();
    if (n % 2)
      usb.Close(); // else Open does
  }
  usb.Close();
  // umockdev's side of the connections is in this process too, and its thread closes them when it
  // comes to it.
  using std::chrono::steady_clock;
  const auto patience = steady_clock::now() + std::chrono::seconds(60);
  while (OpenFiles() > before + times / 10 && steady_clock::now() < patience)
    std::this_thread::yield();
  EXPECT_LE(OpenFiles(), before + times / 10);
}

TEST_F(FalconUsb, BootsIsHomedAndExchangesAThousand)
{
  this->bed.With(
    [](FalconModel& model)
    {
      model.faults.wrongEchoAt = 5'555;
      model.faults.wrongEchoes = 1;
    });
  std::vector<std::string> said;
  this->how.says = [&](const std::string& what) { said.push_back(what); };
  auto driver = this->Driver();
  driver.Open(this->how);
  EXPECT_GE(said.size(), 3u); // asked, tried, tried once more

  EXPECT_FALSE(this->Fresh(driver, { 9, 9, 9 }).homed);
  EXPECT_NE(driver.Advice(), "");
  this->bed.With(
    [](FalconModel& model)
    {
      EXPECT_TRUE(model.PushesNobody());
      model.PullOutAndPushIn();
    });
  EXPECT_TRUE(this->Fresh(driver).homed);

  for (int n = 0; n < 1'000; ++n)
  {
    const glm::dvec3 place{ 30 * std::sin(0.01 * n), 25 * std::cos(0.017 * n),
      20 * std::sin(0.02 * n) };
    this->bed.With([&](FalconModel& model) { model.MoveTo(place); });
    ASSERT_LT(glm::distance(this->Fresh(driver).pose.position, place), 0.1) << n;
    const glm::dvec3 force{ 2 * std::cos(0.03 * n), 1.0, -2 * std::sin(0.05 * n) };
    this->Fresh(driver, force);
    this->bed.With([&](FalconModel& model)
      { EXPECT_LT(glm::distance(model.ForceN(5'000.0), force), 0.02) << n; });
  }
  const auto counts = driver.Counts();
  EXPECT_GE(counts.answers, 2'000u);
  EXPECT_EQ(counts.refused, 0u);
  EXPECT_EQ(counts.droppedBytes, 0u);

  driver.Close();
  this->bed.With([](FalconModel& model) { EXPECT_TRUE(model.PushesNobody()); });
  // It runs on, and is not loaded once more.
  said.clear();
  driver.Open(this->how);
  EXPECT_EQ(said.size(), 1u);
  EXPECT_TRUE(this->Fresh(driver).homed);
}

TEST_F(FalconUsb, TwentyUnplugsEndWell)
{
  std::mt19937 random(5);
  auto driver = this->Driver();
  for (int n = 0; n < 20; ++n)
  {
    bool loaded = false;
    this->bed.With(
      [&](FalconModel& model)
      {
        if (n % 4 == 0)
          model.SwitchOffAndOn();
        loaded = model.Runs();
      });
    this->bed.BreakAfter(static_cast<int>(random() % (loaded ? 100 : 700)));
    try
    {
      driver.Open(this->how);
      for (;;)
      {
        driver.Exchange({ { 3, 2, -4 }, {} }, 0);
        this->bed.With([](FalconModel& model) { model.PullOutAndPushIn(); });
      }
    }
    catch (const DeviceError& error)
    {
      EXPECT_TRUE(error.trouble == DeviceTrouble::Gone || error.trouble == DeviceTrouble::Absent)
        << error.what();
      EXPECT_TRUE(Says(error.what(), "plug"));
    }
    driver.Close();
    this->bed.Unplug();
    EXPECT_THROW(driver.Open(this->how), DeviceError);
    this->bed.Plug();
    driver.Open(this->how);
    this->bed.With([](FalconModel& model) { EXPECT_TRUE(model.PushesNobody()); });
    this->Fresh(driver);
    driver.Close();
  }
}

/// --as-nobody: all of it without root's rights, also where root runs the tests. Not by a program
/// around this one: the folders that it lies in may be root's alone.
int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--as-nobody") == 0 && geteuid() == 0)
    {
      if (syscall(SYS_setgroups, 0, nullptr) != 0 || setgid(Nobody) != 0 || setuid(Nobody) != 0)
      {
        std::perror("cannot be nobody");
        return 1;
      }
      if (const char* folder = std::getenv("TMPDIR"); folder && access(folder, W_OK) != 0)
        unsetenv("TMPDIR");
    }
  return RUN_ALL_TESTS();
}
