#include "Devices/Drivers/Haply/HaplyMessages.h"
#include "Grid/FinitePose.h"
#include "HaplyServiceUnderTest.h"

#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using Json = nlohmann::json;

std::string Refusal(const std::string& text)
{
  try
  {
    hasp::ReadHaplyState(text);
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

std::string Inverse3(const std::string& device)
{
  return R"({"inverse3":[)" + device + "]}";
}
std::string At(const std::string& position)
{
  return Inverse3(R"({"device_id":"1","state":{"cursor_position":)" + position + "}}");
}
std::string Grip(const std::string& state, const std::string& kind = "wireless_verse_grip")
{
  return R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":0,"y":0,"z":0}}}],")" +
         kind + R"(":[{"state":)" + state + "}]}";
}

TEST(HaplyMessages, AStateIsReadInDeviceAxes)
{
  const auto state = hasp::ReadHaplyState(InverseMessage({ 0.1, 0.2, 0.3 }));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->deviceId, "049D");
  // Right, forward, up: our z points to the user, so forward is -z.
  EXPECT_EQ(state->positionMm, glm::dvec3(100, 300, -200));
  ASSERT_TRUE(state->orientation);
  EXPECT_NEAR(glm::dot(*state->orientation, glm::dquat(0, 0, 0.8, -0.6)), 1.0, 1e-15);
  EXPECT_EQ(state->buttons, 2u);
  EXPECT_EQ(state->calibrated, true);
  EXPECT_FALSE(state->centred || state->turnedAxes);
}

/// A turn and the vectors it turns go through the same change of axes.
TEST(HaplyMessages, TurnsFollowTheAxes)
{
  const auto ours = [](const glm::dvec3& v) { return glm::dvec3(v.x, v.z, -v.y); };
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int n = 0; n < 100; ++n)
  {
    const glm::dquat q =
      glm::normalize(glm::dquat(any(random), any(random), any(random), any(random)));
    const glm::dvec3 v(any(random), any(random), any(random));
    const Json turn = { { "w", q.w }, { "x", q.x }, { "y", q.y }, { "z", q.z } };
    const auto state = hasp::ReadHaplyState(Grip(R"({"orientation":)" + turn.dump() + "}"));
    ASSERT_TRUE(state && state->orientation);
    EXPECT_LT(glm::length(*state->orientation * ours(v) - ours(q * v)), 1e-13);
  }
}

TEST(HaplyMessages, AForceIsWrittenInTheServicesAxes)
{
  const Json json = Json::parse(hasp::WriteHaplyForce("04\"9D", { 1.0, 2.0, -3.0 }));
  EXPECT_EQ(json, Json::parse(R"({"inverse3":[{"device_id":"04\"9D","commands":
      {"set_cursor_force":{"values":{"x":1.0,"y":3.0,"z":2.0}}}}]})"));
  EXPECT_THROW(hasp::WriteHaplyForce("1", { NAN, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(hasp::WriteHaplyForce("1", { 0, INFINITY, 0 }), std::invalid_argument);
  EXPECT_THROW(hasp::WriteHaplyForce("\xff", {}), std::invalid_argument);
}

TEST(HaplyMessages, WithoutAGripThereIsNoTurnAndNoButton)
{
  for (const std::string& text :
    { At(R"({"x":0,"y":0,"z":0})"), Grip(R"({"orientation":{"w":0,"x":0,"y":0,"z":0}})"),
      std::string(R"({"wireless_verse_grip":[],"verse_grip":null,)") +
        At(R"({"x":0,"y":0,"z":0})").substr(1) })
  {
    const auto state = hasp::ReadHaplyState(text);
    ASSERT_TRUE(state) << text;
    EXPECT_FALSE(state->orientation) << text;
    EXPECT_EQ(state->buttons, 0u) << text;
  }
}

TEST(HaplyMessages, AWiredGripHasOneButton)
{
  const auto state = hasp::ReadHaplyState(
    Grip(R"({"orientation":{"w":1,"x":0,"y":0,"z":0},"button":true,"hall":0})", "verse_grip"));
  ASSERT_TRUE(state && state->orientation);
  EXPECT_EQ(*state->orientation, glm::dquat(1, 0, 0, 0));
  EXPECT_EQ(state->buttons, 1u);
}

TEST(HaplyMessages, TheDeviceThatIsMeantIsFound)
{
  const std::string text =
    R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1,"y":0,"z":0}}},)"
    R"({"device_id":"B","state":{"cursor_position":{"x":0.5,"y":0,"z":0}}}]})";
  EXPECT_EQ(hasp::ReadHaplyState(text)->deviceId, "A");
  EXPECT_EQ(hasp::ReadHaplyState(text, "B")->positionMm.x, 500.0);
  EXPECT_FALSE(hasp::ReadHaplyState(text, "C"));
  EXPECT_FALSE(hasp::ReadHaplyState("{}"));
  EXPECT_FALSE(hasp::ReadHaplyState(R"({"inverse3":[]})"));
  EXPECT_FALSE(hasp::ReadHaplyState(R"({"inverse3":null,"x":1})"));
}

TEST(HaplyMessages, WhereAndHowTheServiceCountsIsRead)
{
  const auto with = [](const std::string& config)
  {
    return *hasp::ReadHaplyState(
      Inverse3(R"({"device_id":"1","state":{"cursor_position":{"x":0,"y":0,"z":0}},"config":)" +
               config + "}"));
  };
  EXPECT_TRUE(with(R"({"preset":"arm_front_centered"})").centred);
  EXPECT_FALSE(with(R"({"preset":"defaults"})").centred);
  EXPECT_TRUE(with(R"({"basis":{"permutation":"XZY"}})").turnedAxes);
  EXPECT_FALSE(with(R"({"basis":{"permutation":"XYZ"}})").turnedAxes);
  EXPECT_FALSE(with(R"({"basis":7,"preset":[]})").turnedAxes);
}

TEST(HaplyMessages, WhatCannotBeIsRefusedWithTheReason)
{
  const struct
  {
    std::string text;
    const char* says;
  } cases[] = {
    { "", "no JSON" },
    { "nonsense", "no JSON" },
    { "{", "no JSON" },
    { "\xff\xfe", "no JSON" },
    { At(R"({"x":NaN,"y":0,"z":0})"), "no JSON" },
    { At(R"({"x":1e999,"y":0,"z":0})"), "no JSON" },
    { std::string(100'000, '['), "no JSON" },
    { "[]", "no object" },
    { "7", "no object" },
    { R"({"inverse3":{}})", "inverse3 is no list" },
    { Inverse3("7"), "device_id is missing" },
    { Inverse3("{}"), "device_id is missing" },
    { Inverse3(R"({"device_id":7})"), "device_id is missing, or is no text" },
    { Inverse3(R"({"device_id":""})"), "device_id has 0 bytes" },
    { Inverse3(R"({"device_id":")" + std::string(65, 'x') + R"("})"), "device_id has 65 bytes" },
    { Inverse3(R"({"device_id":"1"})"), "state is missing" },
    { Inverse3(R"({"device_id":"1","state":[]})"), "state is missing" },
    { Inverse3(R"({"device_id":"1","state":{}})"), "cursor_position is missing" },
    { At(R"({"x":0,"y":0})"), "cursor_position.z is missing" },
    { At(R"({"x":"0","y":0,"z":0})"), "cursor_position.x is missing, or is no number" },
    { At(R"({"x":true,"y":0,"z":0})"), "cursor_position.x is missing, or is no number" },
    { At(R"({"x":0,"y":null,"z":0})"), "cursor_position.y" },
    { At(R"({"x":0,"y":0,"z":2.001})"), "further than 2 m" },
    { At(R"({"x":1e308,"y":1e308,"z":0})"), "further than 2 m" },
    { Inverse3(R"({"device_id":"1","state":{"cursor_position":{"x":0,"y":0,"z":0}},)"
               R"("status":{"calibrated":1}})"),
      "calibrated is neither" },
    { Grip("7"), "state is missing" },
    { Grip("{}"), "orientation is missing" },
    { Grip(R"({"orientation":{"w":1,"x":0,"y":0}})"), "orientation.z is missing" },
    { Grip(R"({"orientation":{"w":2,"x":0,"y":0,"z":0}})"), "no unit quaternion" },
    { Grip(R"({"orientation":{"w":1e308,"x":1e308,"y":0,"z":0}})"), "no unit quaternion" },
    { Grip(R"({"orientation":{"w":1,"x":0,"y":0,"z":0},"buttons":{"a":1}})"), "a is neither" },
    { Grip(R"({"orientation":{"w":1,"x":0,"y":0,"z":0},"button":"on"})", "verse_grip"),
      "button is neither" },
  };
  for (const auto& c : cases)
    EXPECT_NE(Refusal(c.text).find(c.says), std::string::npos) << c.says << "\n"
                                                               << c.text.substr(0, 200) << "\n"
                                                               << Refusal(c.text);
}

/// What the service may say of everything else, and what we hold of it whatever comes.
void ExpectSane(const std::string& text)
{
  try
  {
    const auto state = hasp::ReadHaplyState(text);
    if (!state)
      return;
    EXPECT_LE(glm::length(state->positionMm), 2000.0) << text;
    EXPECT_LE(state->buttons, 7u) << text;
    EXPECT_FALSE(state->deviceId.empty()) << text;
    EXPECT_LE(state->deviceId.size(), 64u) << text;
    if (state->orientation)
    {
      EXPECT_NEAR(glm::length(*state->orientation), 1.0, 1e-12) << text;
    }
    hasp::WriteHaplyForce(state->deviceId, glm::dvec3(0.0));
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_LT(std::string(error.what()).size(), 100u);
  }
}

TEST(HaplyMessages, BytesThatWereTouchedDoNoHarm)
{
  const std::string whole = InverseMessage({ 0.1, -0.12, 0.15 });
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) { return random() % n; };
  for (int n = 0; n < 60'000; ++n)
  {
    std::string text = whole;
    for (auto touches = 1 + below(4); touches > 0 && !text.empty(); --touches)
      switch (below(4))
      {
        case 0:
          text[below(text.size())] = char(below(256));
          break;
        case 1:
          text.erase(below(text.size()), 1 + below(8));
          break;
        case 2:
          text.insert(below(text.size()), 1, "{}[]\",:0-eE.ntf\\\0"[below(17)]);
          break;
        default:
          text.resize(below(4) ? text.size() : below(text.size()));
      }
    ExpectSane(text);
  }
}

TEST(HaplyMessages, ValuesThatWereExchangedDoNoHarm)
{
  const Json whole = Json::parse(InverseMessage({ 0.1, -0.12, 0.15 },
    R"("verse_grip":[{"state":{"button":true,"orientation":{"w":1,"x":0,"y":0,"z":0}}}])"));
  std::vector<Json::json_pointer> places;
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items())
    for (Json::json_pointer place(path); !place.empty(); place.pop_back())
      places.push_back(place);
  const Json values[] = { nullptr, true, false, 0, 1, -1, 1e308, -1e-308, 18446744073709551615u, "",
    "x", "049D", Json::array(), Json::object(), Json::array({ 0 }), Json::array({ Json::object() }),
    { { "state", nullptr } }, { { "x", 0 } }, { { "device_id", "1" } } };
  std::mt19937 random(12);
  for (int n = 0; n < 60'000; ++n)
  {
    Json json = whole;
    for (auto touches = 1 + random() % 3; touches > 0; --touches)
    {
      const auto& place = places[random() % places.size()];
      const Json& value = values[random() % std::size(values)];
      try
      {
        json.at(place) = value;
      }
      catch (const Json::exception&) // an earlier touch has taken that place
      {
      }
    }
    ExpectSane(json.dump());
  }
}

} // namespace
