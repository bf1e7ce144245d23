// The driver through the system's own hidapi, on devices of umockdev. A program of its own: it runs
// under umockdev-wrapper or what does the same, and says that it failed where it does not.
#include "Devices/Drivers/Testing/FakeHidraw.h"

#include "Devices/Drivers/DeviceSearch.h"
#include "Devices/Drivers/SpaceMouse/HidapiTransport.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseDriver.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseHid.h"

#include <gtest/gtest.h>

#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <thread>

namespace
{

using namespace hasp;
using namespace hasp::test;

constexpr std::int64_t Ms = 1'000'000;

HidCollection Is(std::uint16_t vendor, std::uint16_t product, const char* name)
{
  return { {}, vendor, product, 1, 8, name };
}
const HidCollection Compact = Is(0x256f, 0xc635, "SpaceMouse Compact");
const HidCollection Wireless = Is(0x256f, 0xc62e, "SpaceMouse Wireless");
/// A mouse's: usage page 1, usage 2.
const Bytes MouseDescriptor = FromHex("05010902a101093009311581257f750895028106c0");
/// Of one node, first a keyboard, then a multi-axis controller.
const Bytes TwoCollections = []
{
  Bytes both = FromHex("05010906a101c0");
  both.insert(both.end(), WholeDescriptor.begin(), WholeDescriptor.end());
  return both;
}();

template <class Does>
DeviceError ErrorOf(Does&& does)
{
  try
  {
    does();
  }
  catch (const DeviceError& error)
  {
    return error;
  }
  ADD_FAILURE() << "no trouble";
  return { DeviceTrouble::NotBuilt, "" };
}

class SpaceMouseHidTest : public ::testing::Test
{
protected:
  DriverSample At(std::int64_t ms) { return this->Driver.Exchange({}, ms * Ms); }
  /// Exchanges until all that was said is taken.
  DriverSample Taken(int number, std::int64_t ms)
  {
    DriverSample sample = this->At(ms);
    while (this->System.Unread(number) > 0)
      sample = this->At(ms);
    return sample;
  }

  /// Exchanges until that does not go on. A wait may end without a report on a busy machine.
  DeviceError UntilTrouble()
  {
    return ErrorOf(
      [&]
      {
        for (;;)
          this->At(0);
      });
  }

  FakeHidraw System;
  SpaceMouseDriver Driver{ std::make_unique<SpaceMouseHid>(std::make_unique<HidapiTransport>()),
    { .waitMs = 4, .followS = 0.0 } };
};

TEST_F(SpaceMouseHidTest, WhereThereIsNoneItSaysSo)
{
  EXPECT_TRUE(FindDevices().empty());
  const DeviceError error = ErrorOf([&] { this->Driver.Open({}); });
  EXPECT_EQ(error.trouble, DeviceTrouble::Absent);
  EXPECT_NE(std::string(error.what()).find("plug it in"), std::string::npos);
}

TEST_F(SpaceMouseHidTest, FindsTheRightCollections)
{
  this->System.Plug(0, Is(0x046d, 0xc52b, "USB Receiver"), MouseDescriptor);
  this->System.Plug(1, Is(0x256f, 0xc650, "CadMouse"), WholeDescriptor);
  this->System.Plug(2, Is(0x256f, 0xc652, "3Dconnexion Universal Receiver Mouse"), WholeDescriptor);
  this->System.Plug(3, Is(0x256f, 0xc652, "3Dconnexion Universal Receiver"), MouseDescriptor);
  this->System.Plug(4, Is(0x256f, 0xc652, "3Dconnexion Universal Receiver"), TwoCollections);
  this->System.Plug(5, Is(0x046d, 0xc626, "SpaceNavigator"), HalvesDescriptor);
  this->System.Plug(
    6, Is(0x256f, 0xc63a, "SpaceMouse Wireless BT"), WholeDescriptor, /*wired*/ false);
  std::vector<std::string> found;
  for (const FoundDevice& mouse : FindDevices())
  {
    found.push_back(mouse.address + " " + mouse.name);
    EXPECT_TRUE(mouse.mayOpen) << mouse.address;
  }
  EXPECT_EQ(found,
    (std::vector<std::string>{ "spacemouse:hidraw4 3Dconnexion Universal Receiver",
      "spacemouse:hidraw5 SpaceNavigator", "spacemouse:hidraw6 SpaceMouse Wireless (Bluetooth)" }));
  // hidapi takes the same for what they are, and no others.
  for (int node = 0; node < 7; ++node)
  {
    HidapiTransport transport("/dev/hidraw" + std::to_string(node));
    if (node < 4)
    {
      EXPECT_EQ(ErrorOf([&] { transport.Open(); }).trouble, DeviceTrouble::Absent) << node;
      continue;
    }
    const HidCollection collection = transport.Open();
    EXPECT_EQ(collection.usagePage, 1) << node;
    EXPECT_EQ(collection.usage, 8) << node;
  }
}

TEST_F(SpaceMouseHidTest, ReadsHalves)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->Driver.Open({});
  this->System.Say(0, Report(1, { 350, 0, -175 }));
  this->System.Say(0, Report(2, { 0, 0, -350 }));
  this->System.Say(0, ButtonReport(2, 3));
  EXPECT_EQ(this->Taken(0, 0).buttons, 2u);
  const DriverSample sample = this->At(50);
  EXPECT_NEAR(sample.pose.position.x, 3.0, 1e-9);
  EXPECT_NEAR(sample.pose.position.y, 1.5, 1e-9);
  EXPECT_NEAR(RotationVector(sample.pose.orientation).y, 0.075, 1e-9);
  EXPECT_EQ(this->Driver.WrongCount(), 0u);
}

TEST_F(SpaceMouseHidTest, ReadsWholes)
{
  this->System.Plug(3, Wireless, WholeDescriptor);
  this->Driver.Open({});
  for (int n = 0; n < 200; ++n)
    this->System.Say(3, Report(1, { n, -2, 3, -4, 5, -6 }));
  this->System.Say(3, Report(1, { 0, 350, 0, -350, 0, 0 }));
  this->System.Say(3, FromHex("175000"));
  this->Taken(3, 0);
  const DriverSample sample = this->At(50);
  EXPECT_NEAR(sample.pose.position.z, 3.0, 1e-9);
  EXPECT_NEAR(RotationVector(sample.pose.orientation).x, -0.075, 1e-9);
  EXPECT_EQ(this->Driver.BatteryPercent(), 80);
  EXPECT_EQ(this->Driver.WrongCount(), 0u);
}

TEST_F(SpaceMouseHidTest, EveryModelIsOpenedAndHeard)
{
  int number = 0;
  for (const SpaceMouseModel& model : SpaceMouseModels())
  {
    this->System.Plug(number, Is(model.vendor, model.product, model.name),
      number % 2 ? WholeDescriptor : HalvesDescriptor);
    this->Driver.Open({});
    for (std::size_t n = 0; n < model.buttonBits.size(); ++n)
    {
      this->System.Say(number, ButtonReport(std::uint64_t{ 1 } << model.buttonBits[n], 7));
      EXPECT_EQ(this->Taken(number, 0).buttons, 1u << n) << model.name << " " << n;
    }
    this->Driver.Close();
    this->System.Unplug(number++);
  }
}

TEST_F(SpaceMouseHidTest, FullDeflectionIsWhatTheKernelShowsOfTheDescriptor)
{
  this->System.Plug(0, Compact,
    FromHex("05010908a101160cfe26f4010930093109320933093409358102c0")); // +-500
  HidapiTransport transport;
  transport.Open();
  EXPECT_EQ(ReadHidAxes(transport.ReportDescriptor()).fault, nullptr);
  EXPECT_EQ(ReadHidAxes(transport.ReportDescriptor()).ranges[5], (AxisRange{ -500, 500 }));
}

TEST_F(SpaceMouseHidTest, TheLightIsOnWhileItIsOpen)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->Driver.Open({});
  EXPECT_EQ(this->System.Written(0), (std::vector<Bytes>{ FromHex("0401") }));
  this->Driver.Close();
  EXPECT_EQ(this->System.Written(0), (std::vector<Bytes>{ FromHex("0401"), FromHex("0400") }));
  this->System.RefuseWrites(0, true);
  this->Driver.Open({});
  this->System.Say(0, ButtonReport(1, 3));
  EXPECT_EQ(this->Taken(0, 0).buttons, 1u);
  this->Driver.Close();
}

TEST_F(SpaceMouseHidTest, UnpluggedInTheMiddleOfAReadItIsGoneAndComesBack)
{
  int number = 0; // each time another node, as from Linux while the one before is open
  this->System.Plug(number, Compact, HalvesDescriptor);
  for (const int error : { EIO, ENODEV })
    for (int more = 0; more < 5; ++more)
    {
      this->Driver.Open({});
      for (int n = 0; n < 10; ++n)
        this->System.Say(number, Report(1, { 350, 0, 0 }));
      this->System.FailReads(number, more, error);
      const DeviceError gone = this->UntilTrouble();
      EXPECT_EQ(gone.trouble, DeviceTrouble::Gone);
      EXPECT_NE(std::string(gone.what()).find("plug it in"), std::string::npos) << gone.what();
      this->Driver.Close();
      this->System.Unplug(number);
      EXPECT_EQ(ErrorOf([&] { this->Driver.Open({}); }).trouble, DeviceTrouble::Absent);
      this->System.Plug(++number, Compact, HalvesDescriptor);
      this->Driver.Open({});
      this->System.Say(number, ButtonReport(1, 3));
      EXPECT_EQ(this->Taken(number, 0).buttons, 1u);
      this->Driver.Close();
    }
}

TEST_F(SpaceMouseHidTest, ASignalIsNoUnplugging)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->Driver.Open({});
  this->System.Say(0, ButtonReport(1, 3));
  this->System.FailReads(0, 0, EINTR);
  EXPECT_EQ(this->At(0).buttons, 0u);
  this->System.FailReads(0, -1, 0);
  EXPECT_EQ(this->Taken(0, 0).buttons, 1u);
}

TEST_F(SpaceMouseHidTest, ItsNodeGoesWhileItIsOpen)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->Driver.Open({});
  this->At(0);
  this->System.Unplug(0);
  EXPECT_EQ(this->UntilTrouble().trouble, DeviceTrouble::Gone);
  this->Driver.Close();
}

TEST_F(SpaceMouseHidTest, TakesTheOneThatIsNamed)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->System.Plug(1, Wireless, WholeDescriptor);
  HidapiTransport second("/dev/hidraw1"), none("/dev/hidraw9");
  EXPECT_EQ(second.Open().product, Wireless.product);
  EXPECT_EQ(ErrorOf([&] { none.Open(); }).trouble, DeviceTrouble::Absent);
}

TEST_F(SpaceMouseHidTest, WhatIsClosedIsGone)
{
  HidapiTransport transport;
  std::array<std::byte, 8> report;
  EXPECT_EQ(ErrorOf([&] { transport.Read(report, 0); }).trouble, DeviceTrouble::Gone);
  EXPECT_EQ(ErrorOf([&] { transport.Write(report); }).trouble, DeviceTrouble::Gone);
  EXPECT_TRUE(transport.ReportDescriptor().empty());
  transport.Close();
}

std::ptrdiff_t OpenHandles()
{
  return std::distance(
    std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator{});
}

TEST_F(SpaceMouseHidTest, OpensAndClosesAThousandTimesAndLeavesNothing)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->Driver.Open({});
  this->Driver.Close();
  const std::ptrdiff_t before = OpenHandles();
  for (int n = 0; n < 1000; ++n)
  {
    this->Driver.Open({});
    this->Driver.Close();
  }
  // umockdev's thread closes its ends when it comes to it. A leak would be one each time.
  EXPECT_LT(OpenHandles(), before + 100);
  EXPECT_EQ(this->System.Written(0).size(), 2002u);
}

/// Several that open and close: hidapi is begun and ended under nobody.
TEST_F(SpaceMouseHidTest, OpensWhileOthersOpenAndClose)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  this->System.Plug(1, Wireless, WholeDescriptor);
  std::atomic<int> found{ 0 };
  std::thread search(
    [&]
    {
      for (int n = 0; n < 50; ++n)
      {
        HidapiTransport first;
        found += first.Open().vendor != 0 ? 1 : 0;
      }
    });
  std::thread other(
    []
    {
      for (int n = 0; n < 50; ++n)
      {
        HidapiTransport transport("/dev/hidraw1");
        transport.Open();
      }
    });
  for (int n = 0; n < 50; ++n)
  {
    HidapiTransport transport("/dev/hidraw0");
    transport.Open();
  }
  search.join();
  other.join();
  EXPECT_EQ(found, 50);
}

/// For root nothing is forbidden: see main.
TEST_F(SpaceMouseHidTest, ForbiddenToThisUser)
{
  this->System.Plug(0, Compact, HalvesDescriptor);
  ASSERT_EQ(chmod(this->System.RealPath(0).c_str(), 0), 0);
  const auto found = FindDevices();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].mayOpen);
  EXPECT_NE(found[0].remedy.find("udev"), std::string::npos) << found[0].remedy;
  const DeviceError error = ErrorOf([&] { this->Driver.Open({}); });
  EXPECT_EQ(error.trouble, DeviceTrouble::Permission);
  const std::string sentence = error.what();
  EXPECT_NE(sentence.find("SpaceMouse Compact"), sentence.npos) << sentence;
  EXPECT_NE(sentence.find("udev"), sentence.npos) << sentence;

  this->System.Plug(1, Wireless, WholeDescriptor); // one that is allowed is taken
  this->Driver.Open({});
  this->Driver.Close();
  ASSERT_EQ(chmod(this->System.RealPath(0).c_str(), 0600), 0); // the rule is there now
  this->System.Unplug(1);
  this->Driver.Open({});
}

/// From root to nobody, as far as that is not so already.
bool BecomeNobody()
{
  if (geteuid() != 0)
    return true;
  constexpr id_t Nobody = 65534;
  // Linux hides /proc/self from whoever has changed who he is, until it is told not to.
  return setresgid(Nobody, Nobody, Nobody) == 0 && setresuid(Nobody, Nobody, Nobody) == 0 &&
         prctl(PR_SET_DUMPABLE, 1) == 0;
}

} // namespace

/// --as-nobody: as somebody who is not root. Without it root leaves out what is forbidden to
/// others.
int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  if (!FakeHidraw::Works())
  {
    std::fputs("this test runs under umockdev-wrapper (Debian: umockdev)\n", stderr);
    return 1;
  }
  if (argc > 1 && std::strcmp(argv[1], "--as-nobody") == 0)
  {
    if (!BecomeNobody())
    {
      std::perror("to become nobody");
      return 1;
    }
  }
  else if (geteuid() == 0)
    GTEST_FLAG_SET(filter, GTEST_FLAG_GET(filter) + "-*.ForbiddenToThisUser");
  return RUN_ALL_TESTS();
}
