#include "Devices/Drivers/Testing/FakeHid.h"

#include "Devices/Drivers/SpaceMouse/SixDofAxes.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseReport.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace hasp;
using namespace hasp::test;
using Axes = std::array<std::int16_t, 6>;

TEST(SpaceMouseReport, HalvesComeOneAfterTheOther)
{
  SpaceMouseReports reports;
  EXPECT_EQ(reports.Take(Report(1, { 100, -200, 350 })), SpaceMouseReport::Push);
  EXPECT_EQ(reports.Take(Report(2, { -350, 5, 0 })), SpaceMouseReport::Turn);
  EXPECT_EQ(reports.axes, (Axes{ 100, -200, 350, -350, 5, 0 }));
  EXPECT_EQ(reports.Take(Report(1, { 0, 0, 0 })), SpaceMouseReport::Push);
  EXPECT_EQ(reports.axes, (Axes{ 0, 0, 0, -350, 5, 0 }));
  EXPECT_EQ(reports.good, 3u);
}

TEST(SpaceMouseReport, WholeComesAtOnce)
{
  SpaceMouseReports reports;
  EXPECT_EQ(
    reports.Take(Report(1, { 1, -2, 3, -32768, 32767, -6 })), SpaceMouseReport::PushAndTurn);
  EXPECT_EQ(reports.axes, (Axes{ 1, -2, 3, -32768, 32767, -6 }));
}

TEST(SpaceMouseReport, ButtonsAndBattery)
{
  SpaceMouseReports reports;
  for (std::size_t size = 3; size <= 7; ++size)
  {
    const std::uint64_t bits = 0x8765'4321'0fedu & ((std::uint64_t{ 1 } << 8 * (size - 1)) - 1);
    EXPECT_EQ(reports.Take(ButtonReport(bits, size)), SpaceMouseReport::Buttons);
    EXPECT_EQ(reports.buttonBits, bits) << size;
  }
  EXPECT_FALSE(reports.batteryPercent);
  EXPECT_EQ(reports.Take(FromHex("176400")), SpaceMouseReport::Battery);
  EXPECT_EQ(reports.batteryPercent, 100);
  EXPECT_EQ(reports.Take(FromHex("170001")), SpaceMouseReport::Battery);
  EXPECT_EQ(reports.batteryPercent, 0);
}

TEST(SpaceMouseReport, WrongOnesAreCountedAndChangeNothing)
{
  SpaceMouseReports reports;
  reports.Take(Report(1, { 1, 2, 3, 4, 5, 6 }));
  reports.Take(FromHex("0301020304"));
  reports.Take(FromHex("173200"));
  const SpaceMouseReports before = reports;
  std::uint64_t wrong = 0;
  for (int id = 0; id < 256; ++id)
    for (std::size_t size = 0; size <= 64; ++size)
    {
      const bool right = (id == 1 && (size == 7 || size == 13)) || (id == 2 && size == 7) ||
                         (id == 3 && size >= 3 && size <= 7) || (id == 0x17 && size == 3);
      if (right)
        continue;
      Bytes bytes(size, std::byte{ 0x11 });
      if (size > 0)
        bytes[0] = static_cast<std::byte>(id);
      EXPECT_EQ(reports.Take(bytes), SpaceMouseReport::Wrong) << id << " " << size;
      EXPECT_EQ(reports.wrong, ++wrong);
    }
  EXPECT_EQ(reports.Take(FromHex("176500")), SpaceMouseReport::Wrong); // 101 %
  EXPECT_EQ(reports.axes, before.axes);
  EXPECT_EQ(reports.buttonBits, before.buttonBits);
  EXPECT_EQ(reports.batteryPercent, before.batteryPercent);
  EXPECT_EQ(reports.good, before.good);
}

TEST(SpaceMouseReport, AMillionRandomOnesAndThenAGoodOneIsUnderstood)
{
  std::mt19937 random(20);
  std::uniform_int_distribution<int> any(0, 255), size(0, 64), id(0, 3);
  constexpr int usual[] = { 1, 2, 3, 0x17 };
  constexpr int Many = 1'000'000;
  SpaceMouseReports reports;
  Bytes bytes;
  int axesSeen = 0;
  for (int n = 0; n < Many; ++n)
  {
    bytes.resize(n % 2 ? size(random) : 3 + size(random) % 11);
    for (std::byte& byte : bytes)
      byte = static_cast<std::byte>(any(random));
    if (!bytes.empty() && n % 4)
      bytes[0] = static_cast<std::byte>(usual[id(random)]);
    const SpaceMouseReport said = reports.Take(bytes);
    axesSeen += said == SpaceMouseReport::Push || said == SpaceMouseReport::PushAndTurn;
    const glm::dvec3 push = DeviceDeflections(
      std::span<const std::int16_t, 6>(reports.axes), AxisRanges{}, SpaceMouseAxes, 0);
    ASSERT_LE(glm::length(push), std::sqrt(3.0) + 1e-12); // NaN is not
  }
  EXPECT_GT(axesSeen, Many / 100); // else it tested nothing
  EXPECT_EQ(reports.good + reports.wrong, static_cast<std::uint64_t>(Many));
  EXPECT_EQ(reports.Take(Report(1, { 1, 2, 3, 4, 5, 6 })), SpaceMouseReport::PushAndTurn);
  EXPECT_EQ(reports.axes, (Axes{ 1, 2, 3, 4, 5, 6 }));
}

// ---- axes

constexpr AxisRanges Hundred{ { { -100, 100 }, { -100, 100 }, { -100, 100 }, { -100, 100 },
  { -100, 100 }, { -100, 100 } } };

struct SignCase
{
  int number;
  glm::dvec3 push, turn; ///< what a count of +100 of 100 means
};

void ExpectSigns(const SixDofAxes& axes, const std::array<SignCase, 6>& cases)
{
  for (const SignCase& one : cases)
  {
    std::array<int, 6> numbers{};
    numbers[static_cast<std::size_t>(one.number)] = 100;
    const std::span<const int, 6> all(numbers);
    EXPECT_EQ(DeviceDeflections(all, Hundred, axes, 0), one.push) << one.number;
    EXPECT_EQ(DeviceDeflections(all, Hundred, axes, 3), one.turn) << one.number;
    numbers[static_cast<std::size_t>(one.number)] = -100;
    EXPECT_EQ(DeviceDeflections(all, Hundred, axes, 0), -one.push) << one.number;
    EXPECT_EQ(DeviceDeflections(all, Hundred, axes, 3), -one.turn) << one.number;
  }
}

/// The device: x right, y to the user, z down. Hasp: x right, y up, z to the user.
TEST(SixDofAxes, SignOfEachAxisOfADevice)
{
  ExpectSigns(SpaceMouseAxes,
    { { { 0, { 1, 0, 0 }, {} },     // pushed right
      { 1, { 0, 0, 1 }, {} },       // pulled to the user
      { 2, { 0, -1, 0 }, {} },      // pushed down
      { 3, {}, { 1, 0, 0 } },       // tilted to the user
      { 4, {}, { 0, 0, 1 } },       // tilted left: about the axis to the user, from x to y
      { 5, {}, { 0, -1, 0 } } } }); // twisted clockwise, seen from above
}

/// The daemon: x right, y up, z away from the user.
TEST(SixDofAxes, SignOfEachAxisOfTheDaemon)
{
  ExpectSigns(
    SpacenavAxes, { { { 0, { 1, 0, 0 }, {} }, { 1, { 0, 1, 0 }, {} }, { 2, { 0, 0, -1 }, {} },
                    { 3, {}, { 1, 0, 0 } }, { 4, {}, { 0, 1, 0 } }, { 5, {}, { 0, 0, -1 } } } });
}

/// A table of axes must not mirror: the turned axes of pushes are those of turns.
TEST(SixDofAxes, BothTablesTurnAsTheyPushAndKeepHandedness)
{
  for (const SixDofAxes& axes : { SpaceMouseAxes, SpacenavAxes })
    for (std::size_t n = 0; n < 3; ++n)
    {
      EXPECT_EQ(axes[n].number + 3, axes[n + 3].number);
      EXPECT_EQ(axes[n].sign, axes[n + 3].sign);
    }
  const auto column = [](int number)
  {
    std::array<int, 6> numbers{};
    numbers[static_cast<std::size_t>(number)] = 100;
    return DeviceDeflections(std::span<const int, 6>(numbers), Hundred, SpaceMouseAxes, 0);
  };
  EXPECT_EQ(glm::cross(column(0), column(1)), column(2)); // HID axes are right-handed too
}

TEST(SixDofAxes, OvershootIsFullDeflection)
{
  constexpr AxisRange range{ -350, 350 };
  EXPECT_EQ(Deflection(0, range), 0.0);
  EXPECT_EQ(Deflection(175, range), 0.5);
  EXPECT_EQ(Deflection(-175, range), -0.5);
  EXPECT_EQ(Deflection(350, range), 1.0);
  for (const int beyond : { 351, 500, 32767, std::numeric_limits<int>::max() })
  {
    EXPECT_EQ(Deflection(beyond, range), 1.0) << beyond;
    EXPECT_EQ(Deflection(-beyond, range), -1.0) << beyond;
  }
  EXPECT_EQ(Deflection(std::numeric_limits<int>::min(), range), -1.0);
  EXPECT_EQ(Deflection(50, { -200, 100 }), 0.5);
  EXPECT_EQ(Deflection(-50, { -200, 100 }), -0.25);
  EXPECT_EQ(Deflection(50, { 0, 0 }), 0.0); // no such side: nothing, and no division by 0
  EXPECT_EQ(Deflection(50, { -9, -3 }), 0.0);
}

} // namespace
