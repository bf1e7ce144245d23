// A Falcon that the kernel believes in: USB core, usbfs, libusb and the driver.
#include "GadgetFalcon.h"
#include "GuestFalconBench.h"

#include "Devices/Drivers/DeviceSearch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::test;

class GuestFalcon : public GuestFalconBench
{
protected:
  GuestFalcon() { EXPECT_TRUE(Becomes(ItIsThere)) << "the kernel did not bring it"; }
  /// Found, and done with by the kernel.
  static bool ItIsThere()
  {
    const auto found = FindDevices();
    if (found.size() != 1 || !found[0].mayOpen)
      return false;
    try
    {
      LibusbTransport().Open();
      return true;
    }
    catch (const DeviceError&)
    {
      return false;
    }
  }
  static bool NoneIsThere() { return FindDevices().empty(); }

  /// Opens, and sees that the driver says what state it is in until it is homed.
  void OpenAndHome(FalconDriver& driver)
  {
    driver.Open({});
    // The hand does its part only when it is told to: with the homing bit.
    EXPECT_FALSE(this->Fresh(driver).homed);
    EXPECT_FALSE(driver.Advice().empty());
    this->Cable.With([](FalconModel& model) { model.PullOutAndPushIn(); });
    EXPECT_TRUE(Becomes([&] { return this->Fresh(driver).homed; }));
  }

  GadgetFalcon Cable;
};

DeviceTrouble TroubleOf(const std::function<void()>& does)
{
  try
  {
    does();
  }
  catch (const DeviceError& error)
  {
    std::printf("guest: it says: %s\n", error.what());
    return error.trouble;
  }
  ADD_FAILURE() << "no trouble";
  return DeviceTrouble::NotBuilt;
}

TEST_F(GuestFalcon, IsOfOneProgramAtATime)
{
  const std::string address = FindDevices().at(0).address;
  LibusbTransport first(address.substr(address.find(':') + 1)), second;
  first.Open();
  EXPECT_EQ(TroubleOf([&] { second.Open(); }), DeviceTrouble::Busy);
  first.Close();
  second.Open();
}

TEST_F(GuestFalcon, ARequestThatItRefusesIsProtocol)
{
  LibusbTransport usb;
  usb.Open();
  EXPECT_EQ(TroubleOf([&] { usb.Control(77, 0); }), DeviceTrouble::Protocol);
  usb.Control(0, 1); // and goes on
}

TEST_F(GuestFalcon, BootsHomesAndPushes)
{
  auto driver = this->Driver();
  const auto start = std::chrono::steady_clock::now();
  this->OpenAndHome(driver);
  std::printf("guest: booted and homed in %.2f s\n", SecondsSince(start));

  const auto exchanges = std::chrono::steady_clock::now();
  for (int n = 0; n < 150; ++n)
  {
    const glm::dvec3 place{ 30 * std::sin(0.1 * n), 25 * std::cos(0.17 * n),
      20 * std::sin(0.2 * n) };
    this->Cable.With([&](FalconModel& model) { model.MoveTo(place); });
    // A count of the encoders is less than 0.1 mm at the grip.
    ASSERT_LT(glm::distance(this->Fresh(driver).pose.position, place), 0.1) << n;
    const glm::dvec3 force{ 2 * std::cos(0.3 * n), 1.0, -2 * std::sin(0.5 * n) };
    this->Fresh(driver, force);
    // A number of the motors is 0.01 N or less.
    this->Cable.With([&](FalconModel& model)
      { EXPECT_LT(glm::distance(model.ForceN(5'000.0), force), 0.02) << n; });
  }
  this->Report("dummy_hcd", driver, SecondsSince(exchanges));

  driver.Close();
  EXPECT_TRUE(Becomes(
    [&]
    {
      bool quiet = false;
      this->Cable.With([&](FalconModel& model) { quiet = model.PushesNobody(); });
      return quiet;
    }))
    << "motors stay on";
  // It runs on, and is not loaded once more.
  driver.Open({ .setUp = false });
  EXPECT_TRUE(this->Fresh(driver).homed);
}

TEST_F(GuestFalcon, AWrongEchoIsTriedAgain)
{
  this->Cable.With(
    [](FalconModel& model)
    {
      model.faults.wrongEchoAt = 4'000;
      model.faults.wrongEchoes = 1;
    });
  auto driver = this->Driver();
  this->OpenAndHome(driver);
  this->Cable.With([](FalconModel& model) { EXPECT_EQ(model.faults.wrongEchoes, 0); });
}

TEST_F(GuestFalcon, UnpluggedInMidExchangeItIsGoneAndComesBack)
{
  auto driver = this->Driver();
  this->OpenAndHome(driver);
  for (int n = 0; n < 5; ++n)
  {
    this->Cable.UnplugAfter(FalconPacket{}.size() * (7 + 3 * n));
    const auto until = [&] {
      EXPECT_FALSE(Becomes([&] { return driver.Exchange({ { 1, 0, 0 }, {} }, 0), false; }));
    };
    EXPECT_EQ(TroubleOf(until), DeviceTrouble::Gone);
    driver.Close();
    ASSERT_TRUE(Becomes(NoneIsThere));
    EXPECT_EQ(TroubleOf([&] { driver.Open({}); }), DeviceTrouble::Absent);

    this->Cable.Plug();
    ASSERT_TRUE(Becomes(ItIsThere));
    driver.Open({});
    // Its power was never off.
    EXPECT_TRUE(Becomes([&] { return this->Fresh(driver).homed; }));
  }
}

TEST_F(GuestFalcon, UnpluggedWhileItIsLoadedItIsGone)
{
  auto driver = this->Driver();
  this->Cable.UnplugAfter(5'000);
  // The next try opens it anew: there is none, or the kernel is just about to say so.
  const DeviceTrouble trouble = TroubleOf([&] { driver.Open({}); });
  EXPECT_TRUE(trouble == DeviceTrouble::Absent || trouble == DeviceTrouble::Gone);
  ASSERT_TRUE(Becomes(NoneIsThere));
  this->Cable.Plug();
  ASSERT_TRUE(Becomes(ItIsThere));
  this->OpenAndHome(driver);
}

} // namespace
