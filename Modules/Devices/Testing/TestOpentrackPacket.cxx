#include "Devices/OpentrackInbox.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// As a little-endian program writes them: opentrack's own way.
std::vector<std::byte> Packet(std::array<double, 6> values)
{
  std::vector<std::byte> bytes(sizeof values);
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

hasp::OpentrackFault FaultOf(const std::vector<std::byte>& bytes)
{
  return hasp::ParseOpentrackPacket(bytes).fault;
}

TEST(OpentrackPacket, WhatIsNoneIsRefused)
{
  using Fault = hasp::OpentrackFault;
  for (std::size_t size = 0; size < 200; ++size)
    EXPECT_EQ(FaultOf(std::vector<std::byte>(size)), size < 48   ? Fault::Short
                                                     : size > 48 ? Fault::Long
                                                                 : Fault::None)
      << size;
  for (int n = 0; n < 6; ++n)
    for (const double wrong : { NaN, -NaN, Infinity, -Infinity, 1e300, -1e300,
           n < 3 ? 1000.1 : 360.1, std::numeric_limits<double>::max() })
    {
      std::array<double, 6> values{};
      values[n] = wrong;
      EXPECT_EQ(
        FaultOf(Packet(values)), std::isfinite(wrong) ? Fault::OutOfRange : Fault::NotFinite)
        << n << " " << wrong;
    }
  EXPECT_EQ(FaultOf(Packet({ 5e-324, -0.0, -1000, 360, -360, 1e-300 })), Fault::None);
}

/// The table of the header, line by line, by where the head, its nose and its right ear go.
TEST(OpentrackPacket, EachNumberMovesTheHeadAsTheTableSays)
{
  const glm::dvec3 nose(0, 0, -1), ear(1, 0, 0);
  const auto pose = [](int n, double value)
  {
    std::array<double, 6> values{};
    values[n] = value;
    return hasp::ParseOpentrackPacket(Packet(values)).pose;
  };
  EXPECT_EQ(pose(0, 2).position, glm::dvec3(-20, 0, 0));
  EXPECT_EQ(pose(1, 2).position, glm::dvec3(0, 20, 0));
  EXPECT_EQ(pose(2, 2).position, glm::dvec3(0, 0, 20));
  EXPECT_NEAR((pose(3, 30).orientation * nose).x, 0.5, 1e-15) << "yaw: to his right";
  EXPECT_NEAR((pose(4, 30).orientation * nose).y, 0.5, 1e-15) << "pitch: up";
  EXPECT_NEAR((pose(5, 30).orientation * ear).y, 0.5, 1e-15) << "roll: to his left";
}

TEST(OpentrackPacket, WhatIsMadeIsReadBack)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> mm(-3000, 3000), turn(-1.5, 1.5);
  for (int n = 0; n < 1000; ++n)
  {
    const hasp::HeadPose pose{ { mm(random), mm(random), mm(random) },
      hasp::HeadOrientation(2 * turn(random), turn(random), 2 * turn(random)) };
    const auto again = hasp::ParseOpentrackPacket(hasp::MakeOpentrackPacket(pose));
    ASSERT_EQ(again.fault, hasp::OpentrackFault::None);
    EXPECT_LT(glm::length(again.pose.position - pose.position), 1e-9);
    // Pitch by an arc sine up to 86 degrees: rounding grows 14 times there.
    EXPECT_NEAR(std::abs(glm::dot(again.pose.orientation, pose.orientation)), 1.0, 1e-12);
  }
}

TEST(OpentrackInbox, FaultyPacketsAreCountedByKindAndGiveNoPose)
{
  hasp::OpentrackInbox inbox({ 0, 0, 600 });
  EXPECT_FALSE(inbox.Take({}, 0.0));
  EXPECT_FALSE(inbox.Take(std::vector<std::byte>(47), 0.01));
  EXPECT_FALSE(inbox.Take(std::vector<std::byte>(49), 0.02));
  EXPECT_FALSE(inbox.Take(Packet({ NaN, 0, 0, 0, 0, 0 }), 0.03));
  EXPECT_FALSE(inbox.Take(Packet({ 0, 0, 0, 0, 1e9, 0 }), 0.04));
  EXPECT_FALSE(inbox.Take(Packet({ 0, 0, 960, 0, 0, 0 }), 0.05)) << "with its origin beyond 10 m";
  const auto pose = inbox.Take(Packet({ 1, 0, 0, 0, 0, 0 }), 0.06);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->timeS, 0.06);
  EXPECT_EQ(pose->pose.position, glm::dvec3(-10, 0, 600));
  const hasp::OpentrackCounts& c = inbox.Counts();
  EXPECT_EQ(c.packets, 7u);
  EXPECT_EQ(c.good, 1u);
  EXPECT_EQ(c.tooShort, 2u);
  EXPECT_EQ(c.tooLong, 1u);
  EXPECT_EQ(c.notFinite, 1u);
  EXPECT_EQ(c.outOfRange, 2u);
  EXPECT_EQ(c.duplicated + c.late + c.flooding, 0u);
}

TEST(OpentrackInbox, DoubledPacketsAreNotNewsButAStillHeadIs)
{
  hasp::OpentrackInbox inbox({ 0, 0, 600 });
  const auto packet = Packet({ 1, 2, 3, 4, 5, 6 });
  EXPECT_TRUE(inbox.Take(packet, 1.0));
  EXPECT_FALSE(inbox.Take(packet, 1.0001));
  EXPECT_EQ(inbox.Counts().duplicated, 1u);
  const auto still = inbox.Take(packet, 1.004);
  ASSERT_TRUE(still);
  EXPECT_EQ(still->timeS, 1.004);
  EXPECT_EQ(inbox.Counts().good, 2u);
}

TEST(OpentrackInbox, GapsAndFloodsAreCounted)
{
  hasp::OpentrackInbox inbox({ 0, 0, 600 });
  EXPECT_TRUE(inbox.Take(Packet({ 1, 0, 0, 0, 0, 0 }), 1.0));
  EXPECT_TRUE(inbox.Take(Packet({ 2, 0, 0, 0, 0, 0 }), 1.09));
  EXPECT_EQ(inbox.Counts().late, 0u);
  EXPECT_TRUE(inbox.Take(Packet({ 3, 0, 0, 0, 0, 0 }), 1.2));
  EXPECT_EQ(inbox.Counts().late, 1u);
  for (int n = 0; n < 3000; ++n) // 1 kHz for three seconds is no flood
    inbox.Take(Packet({ 0.001 * n, 0, 0, 0, 0, 0 }), 2.0 + 0.001 * n);
  EXPECT_EQ(inbox.Counts().flooding, 0u);
  for (int n = 0; n < 10'000; ++n)
    EXPECT_TRUE(inbox.Take(Packet({ 0.01 * n, 1, 0, 0, 0, 0 }), 10.0 + 0.00005 * n));
  EXPECT_EQ(inbox.Counts().flooding, 6000u);
  EXPECT_EQ(inbox.Counts().duplicated, 0u);
}

/// Bytes of any kind: no pose comes out that is none.
TEST(OpentrackInbox, WhatEverComesAPoseIsAPose)
{
  std::mt19937_64 random(11);
  hasp::OpentrackInbox inbox({ 0, 0, 600 });
  std::uint64_t good = 0;
  for (int n = 0; n < 100'000; ++n)
  {
    std::array<std::byte, 64> bytes{};
    const std::size_t size = random() % 4 ? 48 : random() % bytes.size();
    for (std::byte& b : bytes)
      b = static_cast<std::byte>(random() & (random() % 3 ? 0xFF : 0x40));
    if (const auto pose = inbox.Take(std::span(bytes).first(size), n * 0.001))
      good += hasp::FaultOf(pose->pose) == hasp::HeadPoseFault::None;
  }
  EXPECT_EQ(good, inbox.Counts().good);
  EXPECT_GT(good, 10u) << "or the test proves nothing";
}

} // namespace
