#include "Devices/Drivers/Falcon/FalconPacket.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace hasp;

namespace
{
FalconAnswer RandomAnswer(std::mt19937& random)
{
  std::uniform_int_distribution<int> count(-32768, 32767);
  return { { count(random), count(random), count(random) },
    static_cast<std::uint8_t>(random() % 16), static_cast<std::uint8_t>(random() % 8) };
}
std::vector<FalconAnswer> TakeAll(FalconFraming& framing, std::span<const std::uint8_t> bytes)
{
  std::vector<FalconAnswer> answers;
  for (const std::uint8_t byte : bytes)
    if (const auto packet = framing.Take(byte))
      answers.push_back(DecodeAnswer(*packet).value());
  return answers;
}
} // namespace

TEST(FalconPacket, IsWhatTheProtocolSays)
{
  const auto packet = Encode(FalconCommand{ { 0x0123, -1, -4095 }, FalconCommand::Blue, true });
  const FalconPacket expected{ '<', 'D', 'C', 'B', 'A', 'P', 'P', 'P', 'P', 'B', 'A', 'A', 'P',
    0x41 + 0x04 + 0x01, 'A', '>' };
  EXPECT_EQ(packet, expected);
  // Byte 13 of an answer goes beyond 'P': three bits of homing above four of buttons.
  EXPECT_EQ(Encode(FalconAnswer{ {}, 15, 7 })[13], 0x41 + 0x7f);
}

TEST(FalconPacket, GoesThereAndBack)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> motor(-4095, 4095);
  for (int n = 0; n < 20'000; ++n)
  {
    const FalconCommand command{ { motor(random), motor(random), motor(random) },
      static_cast<std::uint8_t>(random() & 0xe), random() % 2 == 0 };
    EXPECT_EQ(DecodeCommand(Encode(command)), command);
    const auto answer = RandomAnswer(random);
    EXPECT_EQ(DecodeAnswer(Encode(answer)), answer);
  }
  // Beyond the range nothing else is touched.
  const auto cut = DecodeCommand(Encode(FalconCommand{ { 1'000'000, -1'000'000, 5 }, 0xff, true }));
  EXPECT_EQ(cut, (FalconCommand{ { 4095, -4095, 5 }, 0x0e, true }));
}

TEST(FalconPacket, MotorsKeepTheDirection)
{
  std::mt19937 random(2);
  std::normal_distribution<double> any;
  for (int n = 0; n < 20'000; ++n)
  {
    const glm::dvec3 wanted =
      glm::dvec3{ any(random), any(random), any(random) } * std::pow(10.0, 1.0 + n % 290);
    const auto motors = ToMotors(wanted);
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(wanted[i]));
    const double share = std::min(1.0, 4095.0 / largest);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_LE(std::abs(motors[i]), 4095);
      EXPECT_NEAR(motors[i], wanted[i] * share, 0.5 + 1e-9); // rounded, no more
    }
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  constexpr double huge = std::numeric_limits<double>::max();
  const std::array<int, 3> none{};
  EXPECT_EQ(ToMotors({ nan, 1, 1 }), none);
  EXPECT_EQ(ToMotors({ 1, inf, 1 }), none);
  EXPECT_EQ(ToMotors({ 1, 1, -inf }), none);
  EXPECT_EQ(ToMotors({ tiny, -tiny, tiny }), none);
  EXPECT_EQ(ToMotors({ huge, -huge, 0 }), (std::array<int, 3>{ 4095, -4095, 0 }));
}

TEST(FalconFraming, FindsItsWayBack)
{
  std::mt19937 random(3);
  FalconFraming framing;
  const auto good = RandomAnswer(random);
  const auto packet = Encode(good);

  EXPECT_EQ(TakeAll(framing, packet), std::vector{ good });
  // Cut anywhere: the next one is not lost.
  for (std::size_t length = 0; length < packet.size(); ++length)
  {
    EXPECT_TRUE(TakeAll(framing, std::span(packet).first(length)).empty());
    EXPECT_EQ(TakeAll(framing, packet), std::vector{ good }) << length;
  }
  // Begun anywhere.
  for (std::size_t from = 1; from < packet.size(); ++from)
  {
    EXPECT_TRUE(TakeAll(framing, std::span(packet).subspan(from)).empty());
    EXPECT_EQ(TakeAll(framing, packet), std::vector{ good }) << from;
  }
  // One byte more, anywhere.
  for (std::size_t at = 0; at <= packet.size(); ++at)
    for (const std::uint8_t extra : { '<', '>', 'A', '\0' })
    {
      std::vector<std::uint8_t> bytes(packet.begin(), packet.end());
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), extra);
      bytes.insert(bytes.end(), packet.begin(), packet.end());
      const auto answers = TakeAll(framing, bytes);
      ASSERT_FALSE(answers.empty());
      EXPECT_EQ(answers.back(), good);
    }
}

TEST(FalconFraming, CountsWhatItDrops)
{
  FalconFraming framing;
  const auto packet = Encode(FalconAnswer{});
  TakeAll(framing, packet);
  EXPECT_EQ(framing.Dropped(), 0u);
  EXPECT_EQ(framing.Resyncs(), 0u);
  TakeAll(framing, std::span(packet).first(5));
  TakeAll(framing, packet);
  EXPECT_EQ(framing.Dropped(), 5u);
  EXPECT_EQ(framing.Resyncs(), 1u);
  const std::vector<std::uint8_t> noise(100, 0x00);
  TakeAll(framing, noise);
  EXPECT_EQ(framing.Dropped(), 105u);
  EXPECT_EQ(framing.Resyncs(), 2u);
  TakeAll(framing, packet);
  EXPECT_EQ(framing.Dropped(), 105u);
}

// 1.2 million pieces: whole packets, pieces of them, with bytes changed, repeated, left out, and
// noise. Nothing but packets comes out, and the first good one afterwards does.
TEST(FalconFraming, AMillionDamagedPacketsDoItNoHarm)
{
  std::mt19937 random(4);
  FalconFraming framing;
  std::uint64_t fed = 0, taken = 0;
  for (int n = 0; n < 1'200'000; ++n)
  {
    auto packet = Encode(RandomAnswer(random));
    std::size_t from = 0, to = packet.size();
    switch (random() % 6)
    {
      case 0:
        from = random() % packet.size();
        break;
      case 1:
        to = random() % packet.size();
        break;
      case 2:
        packet[random() % packet.size()] = static_cast<std::uint8_t>(random());
        break;
      case 3:
        packet[random() % packet.size()] = random() % 2 ? '<' : '>';
        break;
      case 4:
        for (auto& byte : packet)
          byte = static_cast<std::uint8_t>(random());
        break;
      default:
        break;
    }
    for (std::size_t i = from; i < to; ++i, ++fed)
      if (const auto whole = framing.Take(packet[i]))
      {
        ++taken;
        ASSERT_TRUE(DecodeAnswer(*whole));
        ASSERT_TRUE(DecodeCommand(*whole));
      }
    if (n % 1000 == 999)
    {
      const auto good = RandomAnswer(random);
      const auto answers = TakeAll(framing, Encode(good));
      ASSERT_EQ(answers.size(), 1u);
      ASSERT_EQ(answers.back(), good);
      fed += 16;
      ++taken;
    }
  }
  // No byte is made up, none is lost without being counted.
  EXPECT_EQ(fed, 16 * taken + framing.Dropped());
  std::printf("fed %llu bytes, %llu packets, %llu dropped\n", static_cast<unsigned long long>(fed),
    static_cast<unsigned long long>(taken), static_cast<unsigned long long>(framing.Dropped()));
}

TEST(FtdiPayload, LeavesOutTheStatusOfEachPacket)
{
  for (std::size_t size = 0; size <= 512; ++size)
  {
    std::vector<std::uint8_t> transfer(size), expected;
    for (std::size_t i = 0; i < size; ++i)
    {
      transfer[i] = static_cast<std::uint8_t>(i % 64 < 2 ? 0xee : i);
      if (i % 64 >= 2)
        expected.push_back(static_cast<std::uint8_t>(i));
    }
    const auto payload = FtdiPayload(transfer);
    EXPECT_EQ(std::vector<std::uint8_t>(payload.begin(), payload.end()), expected) << size;
  }
}
