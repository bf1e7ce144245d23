#include "Grid/Progress.h"
#include "HaplyBench.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace
{

using hasp::DeviceTrouble;
using hasp::HaplyDriver;

TEST(HaplyDriver, ItsProfileIsLegalAndAsTheGripSays)
{
  const HaplyDriver with;
  hasp::ValidateDeviceProfile(with.Profile());
  EXPECT_EQ(with.Profile().poseAxes, 6);
  EXPECT_EQ(with.Profile().forceAxes, 3);
  hasp::HaplySettings settings;
  settings.grip = false;
  const HaplyDriver without(settings);
  hasp::ValidateDeviceProfile(without.Profile());
  EXPECT_EQ(without.Profile().poseAxes, 3);
  EXPECT_EQ(without.Profile().buttons, 0);
}

TEST(HaplyDriver, OtherMachinesAreRefusedUnlessAllowed)
{
  hasp::HaplySettings settings;
  for (const char* remote : { "ws://192.168.1.7:10001", "ws://[2001:db8::1]:10001" })
  {
    settings.address = remote;
    settings.allowRemote = false;
    ExpectTrouble(DeviceTrouble::Address, "neither secret nor signed",
      [&] { const HaplyDriver driver(settings); });
    settings.allowRemote = true;
    EXPECT_NO_THROW(const HaplyDriver driver(settings));
  }
  settings.address = "ws://example.org:10001"; // which would have to be looked up
  ExpectTrouble(DeviceTrouble::Address, "in digits", [&] { const HaplyDriver driver(settings); });
}

TEST(HaplyDriver, SettingsThatCannotBeAreRefused)
{
  const auto refused = [](auto change, const char* says)
  {
    hasp::HaplySettings settings;
    change(settings);
    ExpectTrouble(DeviceTrouble::Address, says, [&] { const HaplyDriver driver(settings); });
  };
  refused([](auto& s) { s.address = "localhost"; }, "must begin with ws://");
  refused([](auto& s) { s.centreMm.y = NAN; }, "centreMm is nan");
  refused([](auto& s) { s.answer = std::chrono::milliseconds(21); }, "answer in ms is 21");
  refused([](auto& s) { s.opening = std::chrono::milliseconds(0); }, "opening in ms is 0");
}

TEST(HaplyDriver, PosesComeAndForcesGo)
{
  HaplyServiceUnderTest service;
  HaplyDriver driver(PatientSettings(service));
  std::vector<std::string> said;
  hasp::DriverOpening how;
  how.says = [&](const std::string& text) { said.push_back(text); };
  driver.Open(how);
  EXPECT_EQ(said.size(), 2u);
  const hasp::DriverSample first = NextFresh(driver, { { 1, 2, 3 }, { 100, 100, 100 } });
  EXPECT_TRUE(first.homed);
  EXPECT_EQ(first.buttons, 2u);
  EXPECT_NEAR(glm::length(first.pose.orientation), 1.0, 1e-12);
  EXPECT_NEAR(first.pose.position.y, 0.0, 1e-12) << "0.15 m above the base is the middle";
  EXPECT_NEAR(first.pose.position.z, 0.0, 1e-12) << "0.12 m before it, too";
  EXPECT_GE(first.pose.position.x, 1.0);
  for (int n = 0; n < 200; ++n)
    EXPECT_GT(NextFresh(driver, { { 0, 100, 0 }, {} }).pose.position.x, 1.0);
  EXPECT_EQ(driver.Advice(), "");

  const auto forces = service.Forces();
  ASSERT_GE(forces.size(), 200u);
  EXPECT_EQ(forces.front(), glm::dvec3(1, -3, 2));
  EXPECT_EQ(service.Strange(), 0);
  EXPECT_EQ(service.Ids().front(), "049D");
  for (std::size_t n = 0; n < forces.size(); ++n)
    EXPECT_LE(glm::length(forces[n]), 10.0 + 1e-12) << "the profile's peak";
}

/// Each way of ending it: the last thing that the service hears is zero, and then goodbye. Where it
/// gets no turn for 80 ms it is cut without, so on a machine under load some do not count.
TEST(HaplyDriver, ClosingZeroesTheForce)
{
  HaplyServiceUnderTest service;
  int heard[2] = {};
  for (int n = 1; n <= 1000 && (heard[0] < 10 || heard[1] < 10); ++n)
  {
    const int before = service.Goodbyes();
    const bool itself = n % 2 == 0;
    {
      HaplyDriver driver(PatientSettings(service));
      driver.Open({});
      NextFresh(driver, { { 1, 1, 1 }, {} });
      if (!itself)
        driver.Close();
    }
    service.AwaitEnds(n);
    if (service.Goodbyes() == before)
      continue;
    EXPECT_EQ(service.Forces().back(), glm::dvec3(0));
    ++heard[itself];
  }
  EXPECT_GE(heard[0], 10);
  EXPECT_GE(heard[1], 10);
}

TEST(HaplyDriver, MayBeOpenedAgainAndAgain)
{
  HaplyServiceUnderTest service;
  HaplyDriver driver(PatientSettings(service));
  driver.Close(); // nothing
  for (int n = 1; n <= 50; ++n)
  {
    driver.Open({}); // closes the one before
    EXPECT_TRUE(NextFresh(driver).fresh);
    if (n % 3 == 0)
    {
      driver.Close();
      ExpectTrouble(DeviceTrouble::Gone, "not open", [&] { driver.Exchange({}, 0); });
    }
  }
}

TEST(HaplyDriver, TheTurnStaysWhileTheGripIsNotHeardOf)
{
  HaplyScript script;
  script.message = [](int n)
  {
    const std::string all = InverseMessage({ 0, 0, 0 });
    return n == 0 || n > 10 ? all.substr(0, all.find(",\"wireless")) + "}" : all;
  };
  HaplyServiceUnderTest service(script);
  // JSON's keys are in the order of the alphabet: nothing but the grip stands behind session_id.
  ASSERT_TRUE(hasp::ReadHaplyState(*script.message(0)));
  ASSERT_FALSE(hasp::ReadHaplyState(*script.message(0))->orientation);
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  EXPECT_NE(driver.Advice().find("VerseGrip"), std::string::npos);
  const hasp::DriverSample with = NextFresh(driver);
  EXPECT_NE(with.pose.orientation, glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(driver.Advice(), "");
  hasp::DriverSample without = with;
  while (without.buttons != 0)
  {
    without = NextFresh(driver);
    EXPECT_EQ(without.pose.orientation, with.pose.orientation);
  }
  EXPECT_NE(driver.Advice().find("VerseGrip"), std::string::npos);

  hasp::HaplySettings settings = PatientSettings(service);
  settings.grip = false;
  HaplyDriver position(settings);
  driver.Close();
  position.Open({});
  for (int n = 0; n < 20; ++n)
  {
    const hasp::DriverSample sample = NextFresh(position);
    EXPECT_EQ(sample.pose.orientation, glm::dquat(1, 0, 0, 0));
    EXPECT_EQ(sample.buttons, 0u);
  }
  EXPECT_EQ(position.Advice(), "");
}

TEST(HaplyDriver, IsNotHomedWhileItIsNotCalibrated)
{
  HaplyScript script;
  script.message = [](int n)
  {
    std::string text = InverseMessage({ 0, 0, 0 });
    const std::string yes = "\"calibrated\":true";
    if (n <= 5)
      text.replace(text.find(yes), yes.size(), "\"calibrated\":false");
    else if (n > 10) // no word of it
      text.replace(text.find(yes), yes.size(), "\"calibration\":7");
    return text;
  };
  HaplyServiceUnderTest service(script);
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  EXPECT_FALSE(NextFresh(driver).homed);
  EXPECT_NE(driver.Advice().find("holder"), std::string::npos);
  for (bool homed = false; !homed;)
    homed = NextFresh(driver).homed;
  for (int n = 0; n < 20; ++n)
    EXPECT_TRUE(NextFresh(driver).homed);
  EXPECT_EQ(driver.Advice(), "");
}

TEST(HaplyDriver, CountsFromTheMiddleWhereTheServiceDoes)
{
  HaplyScript script;
  script.message = [](int)
  {
    std::string text = InverseMessage({ 0.01, 0.02, 0.03 });
    return text.insert(text.find("\"device_id\":\"049D\""),
      R"("config":{"preset":"arm_front_centered","basis":{"permutation":"XYZ"}},)");
  };
  HaplyServiceUnderTest service(script);
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  EXPECT_EQ(NextFresh(driver).pose.position, glm::dvec3(10, 30, -20));
}

TEST(HaplyDriver, TakesTheInverse3ThatIsNamed)
{
  HaplyServiceUnderTest service;
  hasp::HaplySettings settings = PatientSettings(service);
  settings.deviceId = "049D";
  HaplyDriver(settings).Open({});
  settings.deviceId = "0000";
  ExpectTrouble(DeviceTrouble::Absent, "no such device", [&] { HaplyDriver(settings).Open({}); });
}

TEST(HaplyDriver, LeavesWhenItIsAsked)
{
  HaplyScript script;
  script.end = HaplyScript::End::Silent;
  HaplyServiceUnderTest service(script);
  HaplyDriver driver(PatientSettings(service));
  for (const int after : { 0, 1, 5 })
    for (const bool shakesHands : { false, true })
    {
      HaplyScript next;
      next.end = shakesHands ? HaplyScript::End::Never : HaplyScript::End::Silent;
      next.message = [](int) { return std::nullopt; };
      service.Play(next);
      int asked = 0;
      hasp::DriverOpening how;
      how.cancelled = [&] { return asked++ >= after; };
      EXPECT_THROW(driver.Open(how), hasp::Cancelled);
      ExpectTrouble(DeviceTrouble::Gone, "not open", [&] { driver.Exchange({}, 0); });
    }
}

} // namespace
