// A SpaceMouse that the kernel believes in: HID core, hidraw, hidapi and the driver.
#include "UhidSpaceMouse.h"
#include "Waiting.h"

#include "Devices/Drivers/DeviceSearch.h"
#include "Devices/Drivers/SpaceMouse/HidapiTransport.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseDriver.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseHid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <optional>

namespace
{

using namespace hasp;
using namespace hasp::test;

constexpr std::int64_t Ms = 1'000'000;
constexpr int Full = 350;

class GuestSpaceMouse : public ::testing::Test
{
protected:
  void Plug()
  {
    this->Mouse.emplace();
    ASSERT_TRUE(Becomes([] { return FindDevices().size() == 1; }));
  }
  void Unplug()
  {
    this->Mouse.reset();
    ASSERT_TRUE(Becomes([] { return FindDevices().empty(); }));
  }
  /// A report that says so arrives only when the kernel is done with the new device.
  bool Hears(int button)
  {
    return Becomes(
      [&]
      {
        this->Mouse->Say(ButtonReport(std::uint64_t{ 1 } << button, 3));
        return this->At(0).buttons == 1u << button;
      });
  }
  DriverSample At(std::int64_t ms) { return this->Driver.Exchange({}, ms * Ms); }

  std::optional<UhidSpaceMouse> Mouse;
  SpaceMouseDriver Driver{ std::make_unique<SpaceMouseHid>(std::make_unique<HidapiTransport>()),
    { .waitMs = 4, .followS = 0.0 } };
};

TEST_F(GuestSpaceMouse, IsFoundAsTheKernelShowsIt)
{
  EXPECT_TRUE(FindDevices().empty());
  this->Plug();
  const FoundDevice found = FindDevices().at(0);
  EXPECT_TRUE(found.mayOpen);
  HidapiTransport transport;
  const HidCollection collection = transport.Open();
  EXPECT_EQ("spacemouse:" + collection.path.substr(std::strlen("/dev/")), found.address);
  EXPECT_EQ(collection.vendor, 0x256f);
  EXPECT_EQ(collection.product, 0xc62e);
  EXPECT_EQ(collection.usagePage, 1);
  EXPECT_EQ(collection.usage, 8);
  const HidAxes axes = ReadHidAxes(transport.ReportDescriptor());
  EXPECT_EQ(axes.fault, nullptr);
  EXPECT_EQ(axes.ranges[5], (AxisRange{ -Full, Full }));
}

TEST_F(GuestSpaceMouse, PosesAreThoseOfTheReports)
{
  this->Plug();
  this->Driver.Open({});
  ASSERT_TRUE(this->Hears(1));
  const double startMm = this->At(0).pose.position.x;
  // A report lies in the node's queue before the driver looks, so not one may be missing.
  double wantedMm = startMm;
  constexpr int each = 8;
  int before = 0;
  for (int n = 1; n <= 400; ++n)
  {
    const int now = static_cast<int>(std::lround(Full * std::sin(0.05 * n)));
    this->Mouse->Say(Report(1, { now, 0, 0, 0, 0, 0 }));
    wantedMm += 60.0 * before / Full * 0.001 * each;
    before = now;
    ASSERT_NEAR(this->At(each * n).pose.position.x, wantedMm, 1e-9) << n;
  }
  this->Mouse->Say(ButtonReport(0, 3));
  this->Mouse->Say(FromHex("175000"));
  EXPECT_EQ(this->At(0).buttons, 0u);
  EXPECT_EQ(this->Driver.BatteryPercent(), 80);
  EXPECT_EQ(this->Driver.WrongCount(), 0u);
}

TEST_F(GuestSpaceMouse, TheLightArrivesAtTheDevice)
{
  this->Plug();
  this->Driver.Open({});
  const std::vector<Bytes> on{ FromHex("0401") }, both{ FromHex("0401"), FromHex("0400") };
  EXPECT_TRUE(Becomes([&] { return this->Mouse->Written() == on; }));
  this->Driver.Close();
  EXPECT_TRUE(Becomes([&] { return this->Mouse->Written() == both; }));
}

TEST_F(GuestSpaceMouse, UnpluggedItIsGoneAndComesBack)
{
  for (int n = 0; n < 5; ++n)
  {
    this->Plug();
    this->Driver.Open({});
    ASSERT_TRUE(this->Hears(n % 2));
    std::jthread hand([&] { this->Mouse.reset(); });
    try
    {
      EXPECT_FALSE(Becomes([&] { return this->At(0), false; })) << "it did not end";
      ADD_FAILURE() << "the driver did not notice";
    }
    catch (const DeviceError& error)
    {
      EXPECT_EQ(error.trouble, DeviceTrouble::Gone) << error.what();
    }
    hand.join();
    this->Driver.Close();
    this->Unplug();
    try
    {
      this->Driver.Open({});
      ADD_FAILURE() << "there is none";
    }
    catch (const DeviceError& error)
    {
      EXPECT_EQ(error.trouble, DeviceTrouble::Absent) << error.what();
    }
  }
}

} // namespace
