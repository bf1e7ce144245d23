#include "Grid/FinitePose.h"
#include "HaplyBench.h"

#include <glm/geometric.hpp>

#include <random>

namespace
{

using End = HaplyScript::End;
using hasp::DeviceTrouble;
using hasp::HaplyDriver;

HaplyScript Ending(End end)
{
  HaplyScript script;
  script.end = end;
  return script;
}

HaplyScript Saying(std::function<std::optional<std::string>(int)> message)
{
  HaplyScript script;
  script.message = std::move(message);
  return script;
}

TEST(HaplyFaults, WithoutAServiceItIsAbsent)
{
  const DeafPort nobody;
  hasp::HaplySettings settings;
  settings.address = nobody.Address();
  HaplyDriver driver(settings);
  for (int again = 0; again < 3; ++again)
    ExpectTrouble(
      DeviceTrouble::Absent, "is the Haply Inverse Service running?", [&] { driver.Open({}); });
}

TEST(HaplyFaults, AServiceThatDoesNotAnswerIsAbsent)
{
  HaplyServiceUnderTest service;
  hasp::HaplySettings settings = PatientSettings(service);
  settings.opening = std::chrono::milliseconds(100);
  HaplyDriver driver(settings);
  for (const End end : { End::Silent, End::Drip, End::AtOnce, End::InHandshake, End::BeforeAll })
  {
    service.Play(Ending(end));
    ExpectTrouble(DeviceTrouble::Absent, "Haply Inverse Service", [&] { driver.Open({}); });
  }
}

/// On a machine under load the handshake alone may take all the time that there is, so that grows.
TEST(HaplyFaults, AServiceThatSaysNothingIsAbsent)
{
  HaplyServiceUnderTest service(Saying([](int) { return std::nullopt; }));
  hasp::HaplySettings settings = PatientSettings(service);
  std::string said;
  for (int ms = 50; ms < 60'000 && said.find("says nothing") == std::string::npos; ms *= 2)
  {
    settings.opening = std::chrono::milliseconds(ms);
    HaplyDriver driver(settings);
    try
    {
      driver.Open({});
      ADD_FAILURE();
    }
    catch (const hasp::DeviceError& error)
    {
      EXPECT_EQ(error.trouble, DeviceTrouble::Absent);
      said = error.what();
    }
  }
  EXPECT_NE(said.find("says nothing; restart the Haply Inverse Service"), std::string::npos)
    << said;
}

TEST(HaplyFaults, WhatIsAnotherServiceIsTold)
{
  HaplyServiceUnderTest service;
  HaplyDriver driver(PatientSettings(service));
  for (const End end : { End::NotFound, End::NotSpeaking, End::EndlessHeader })
  {
    service.Play(Ending(end));
    ExpectTrouble(DeviceTrouble::Protocol, "is no Haply Inverse Service", [&] { driver.Open({}); });
  }
}

TEST(HaplyFaults, AnInventoryThatCannotBeIsTold)
{
  const struct
  {
    std::string text;
    DeviceTrouble trouble;
    const char* says;
  } cases[] = {
    { "nonsense", DeviceTrouble::Protocol, "no JSON" },
    { R"({"inverse3":[]})", DeviceTrouble::Absent, "plugged in and switched on" },
    { "{}", DeviceTrouble::Absent, "plugged in and switched on" },
    { R"({"inverse3":[{"device_id":"049D"}]})", DeviceTrouble::Protocol, "state is missing" },
    { R"({"inverse3":[{"device_id":"049D","config":{"basis":{"permutation":"XZY"}},)"
      R"("state":{"cursor_position":{"x":0,"y":0,"z":0}}}]})",
      DeviceTrouble::Protocol, "set the basis back to XYZ" },
    { std::string(hasp::WebSocketClient::MostBytes + 1, ' '), DeviceTrouble::Absent,
      "larger than 1 MiB" },
  };
  HaplyServiceUnderTest service;
  HaplyDriver driver(PatientSettings(service));
  for (const auto& c : cases)
  {
    service.Play(Saying([&c](int) { return c.text; }));
    ExpectTrouble(c.trouble, c.says, [&] { driver.Open({}); });
    ExpectTrouble(DeviceTrouble::Gone, "not open", [&] { driver.Exchange({}, 0); });
  }
}

/// Time is passed in, so half a second of silence takes none.
TEST(HaplyFaults, SilenceIsNotFreshAndThenGone)
{
  HaplyServiceUnderTest service(Saying(
    [](int n) {
      return n > 0 ? std::nullopt : std::optional(InverseMessage({ 0.1, -0.12, 0.15 }));
    }));
  hasp::HaplySettings settings = PatientSettings(service);
  settings.answer = std::chrono::milliseconds(0);
  HaplyDriver driver(settings);
  driver.Open({});
  constexpr std::int64_t Start = 123'000'000'000;
  for (std::int64_t after = 0; after <= HaplyDriver::MostSilenceNs; after += 1'000'000)
  {
    const hasp::DriverSample sample = driver.Exchange({}, Start + after);
    EXPECT_FALSE(sample.fresh);
    EXPECT_NEAR(sample.pose.position.x, 100.0, 1e-9);
  }
  ExpectTrouble(DeviceTrouble::Gone, "says nothing any more",
    [&] { driver.Exchange({}, Start + HaplyDriver::MostSilenceNs + 1); });
}

/// What cannot be is dropped: poses stay, and after it comes what can.
TEST(HaplyFaults, MessagesThatCannotBeAreDropped)
{
  const std::string good = InverseMessage({ 0, -0.12, 0.15 });
  const std::string wrong[] = { "nonsense", "", "[]", good.substr(0, good.size() / 2),
    InverseMessage({ 3, 0, 0 }), R"({"inverse3":[7]})",
    R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":NaN,"y":0,"z":0}}}]})",
    R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0}}}]})" };
  HaplyServiceUnderTest service(Saying(
    [&](int n) -> std::optional<std::string>
    {
      return n % 10 == 0 ? InverseMessage({ 0.0001 * n, -0.12, 0.15 })
                         : wrong[n % std::size(wrong)];
    }));
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  double last = 0.0;
  for (int fresh = 0; fresh < 50;)
  {
    const hasp::DriverSample sample = driver.Exchange({}, 0);
    ASSERT_TRUE(hasp::IsFinite(sample.pose));
    EXPECT_EQ(sample.fresh, sample.pose.position.x > last);
    last = sample.pose.position.x;
    fresh += sample.fresh;
  }
}

TEST(HaplyFaults, TooManyOfThemInARowAreTheEnd)
{
  HaplyServiceUnderTest service(Saying(
    [](int n) {
      return std::optional<std::string>(n == 0 ? InverseMessage({ 0, -0.12, 0.15 }) : "[]");
    }));
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  ExpectTrouble(DeviceTrouble::Protocol, "50 times in a row",
    [&]
    {
      for (int n = 0; n < 100'000; ++n)
        EXPECT_FALSE(driver.Exchange({ { 1, 0, 0 }, {} }, 0).fresh);
    });
  driver.Close();
  service.AwaitEnds(1);
  if (service.Goodbyes() == 1) // else it had no turn for 80 ms
  {
    EXPECT_EQ(service.Forces().back(), glm::dvec3(0)) << "it still hears, so it is told";
  }
}

TEST(HaplyFaults, ADeviceThatIsUnpluggedIsGone)
{
  HaplyServiceUnderTest service(Saying(
    [](int n)
    {
      return std::optional<std::string>(n < 5 ? InverseMessage({ 0, 0, 0 }) : R"({"inverse3":[]})");
    }));
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  ExpectTrouble(DeviceTrouble::Gone, "was it unplugged?",
    [&]
    {
      for (;;)
        driver.Exchange({}, 0);
    });
}

TEST(HaplyFaults, AHugeMessageIsTheEnd)
{
  HaplyServiceUnderTest service(Saying(
    [](int n)
    {
      return n < 3 ? InverseMessage({ 0, 0, 0 })
                   : std::string(hasp::WebSocketClient::MostBytes + 1, ' ');
    }));
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  ExpectTrouble(DeviceTrouble::Gone, "larger than 1 MiB",
    [&]
    {
      for (;;)
        driver.Exchange({}, 0);
    });
  driver.Close();
}

/// RFC 6455 8.1: who says text that is no UTF-8 is not talked to any more.
TEST(HaplyFaults, TextThatIsNoneIsTheEnd)
{
  HaplyServiceUnderTest service(Saying(
    [](int n) {
      return std::optional<std::string>(n < 3 ? InverseMessage({ 0, 0, 0 }) : "\xff");
    }));
  HaplyDriver driver(PatientSettings(service));
  driver.Open({});
  ExpectTrouble(DeviceTrouble::Gone, "utf8",
    [&]
    {
      for (;;)
        driver.Exchange({}, 0);
    });
}

/// A thousand times the service goes, at any step and in any way; each time it is told so, nothing
/// hangs, and the next service is found.
TEST(HaplyFaults, AThousandDropsAreThousandErrors)
{
  HaplyServiceUnderTest service;
  HaplyDriver driver(PatientSettings(service));
  std::mt19937 random(3);
  const End ends[] = { End::AtOnce, End::InHandshake, End::BeforeAll, End::InMessage,
    End::AfterMessage };
  int opened = 0, refused = 0;
  for (int n = 0; n < 1000; ++n)
  {
    HaplyScript script;
    script.end = ends[random() % std::size(ends)];
    script.last = int(random() % 6);
    script.reset = random() % 2 == 0;
    service.Play(script);
    try
    {
      driver.Open({});
      ++opened;
      for (;;)
        ASSERT_TRUE(hasp::IsFinite(driver.Exchange({ { 1, 0, 0 }, {} }, 0).pose));
    }
    catch (const hasp::DeviceError& error)
    {
      const bool open = error.trouble == DeviceTrouble::Gone;
      EXPECT_TRUE(open || error.trouble == DeviceTrouble::Absent) << error.what();
      refused += !open;
    }
    driver.Close();
    service.AwaitEnds(n + 1);
  }
  EXPECT_EQ(opened + refused, 1000);
  EXPECT_GT(opened, 100);
  EXPECT_GT(refused, 100);
  service.Play({});
  driver.Open({});
  EXPECT_TRUE(NextFresh(driver).fresh);
}

} // namespace
