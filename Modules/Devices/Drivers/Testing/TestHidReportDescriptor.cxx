#include "Devices/Drivers/Testing/FakeHid.h"

#include "Devices/Drivers/SpaceMouse/HidReportDescriptor.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace
{

using namespace hasp;
using namespace hasp::test;

const std::string Page = "0501", SixUsages = "093009310932093309340935", Input = "8102";

AxisRanges All(int least, int most)
{
  AxisRanges ranges;
  ranges.fill({ least, most });
  return ranges;
}
void ExpectRanges(const std::string& hex, const AxisRanges& ranges)
{
  const HidAxes axes = ReadHidAxes(FromHex(hex));
  EXPECT_EQ(axes.fault, nullptr) << hex << " " << axes.fault;
  EXPECT_EQ(axes.ranges, ranges) << hex;
}
void ExpectFault(const std::string& hex, std::string_view why)
{
  const HidAxes axes = ReadHidAxes(FromHex(hex));
  ASSERT_NE(axes.fault, nullptr) << hex;
  EXPECT_EQ(axes.fault, why) << hex;
  EXPECT_EQ(axes.ranges, All(-350, 350));
}

TEST(HidReportDescriptor, BothLayoutsOfRealDevices)
{
  for (const Bytes& descriptor : { HalvesDescriptor, WholeDescriptor })
  {
    const HidAxes axes = ReadHidAxes(descriptor);
    EXPECT_EQ(axes.fault, nullptr) << axes.fault;
    EXPECT_EQ(axes.ranges, All(-350, 350));
  }
}

TEST(HidReportDescriptor, RangesComeInItemsOfAllSizes)
{
  ExpectRanges(Page + "159c2564" + SixUsages + Input, All(-100, 100));
  ExpectRanges(Page + "160cfe26f401" + SixUsages + Input, All(-500, 500));
  ExpectRanges(Page + "1790eefeff2770110100" + SixUsages + Input, All(-70000, 70000));
  ExpectRanges(Page + "1590267f00" + SixUsages + Input, All(-112, 127));
}

TEST(HidReportDescriptor, EachAxisHasTheRangeThatHoldsAtItsInput)
{
  ExpectRanges(Page + "15f6250a093009310932" + Input + "15ec2514093309340935" + Input,
    { { { -10, 10 }, { -10, 10 }, { -10, 10 }, { -20, 20 }, { -20, 20 }, { -20, 20 } } });
  // A second Input of the same axes changes nothing: here with ranges of +-1.
  ExpectRanges(
    Page + "15f6250a" + SixUsages + Input + "15ff2501" + SixUsages + Input, All(-10, 10));
  // Nor do outputs and features.
  ExpectRanges(
    Page + "15ff2501" + SixUsages + "9102" + SixUsages + "b10215f6250a" + SixUsages + Input,
    All(-10, 10));
}

TEST(HidReportDescriptor, PushAndPopKeepRangesAndPage)
{
  ExpectRanges(Page + "15f6250aa4" + "0509150025017501" + "b4" + SixUsages + Input, All(-10, 10));
}

TEST(HidReportDescriptor, UsagesComeAsRangesAndWithTheirPage)
{
  ExpectRanges(Page + "15f6250a19302935" + Input, All(-10, 10));
  ExpectRanges(
    "050915f6250a0b300001000b310001000b320001001b330001002b35000100" + Input, All(-10, 10));
  // The same numbers on another page are buttons.
  ExpectFault("050915f6250a19302935" + Input, "it lacks an axis");
}

TEST(HidReportDescriptor, LongItemsAreSkipped)
{
  ExpectRanges(Page + "fe03f0a1a2a315f6250a" + SixUsages + "fe0000" + Input, All(-10, 10));
}

TEST(HidReportDescriptor, AUsageRangeWithoutEndIsSafe)
{
  ExpectFault("0501"
              "15f6250a"
              "1b00000000"
              "2bffffffff" +
                Input,
    "it lacks an axis");
}

TEST(HidReportDescriptor, MalformedOnesGiveTheUsualRangeAndSayWhy)
{
  const std::string good = Page + "15f6250a" + SixUsages + Input;
  ExpectFault("", "it lacks an axis");
  ExpectFault(good + "26", "an item is cut off");
  ExpectFault(good + "2601", "an item is cut off");
  ExpectFault(good + "27010000", "an item is cut off");
  ExpectFault(good + "fe", "an item is cut off");
  ExpectFault(good + "fe04f00102", "an item is cut off");
  ExpectFault(good + "b4", "it pops what was not pushed");
  ExpectFault(good + "a4", "it ends in the middle");
  ExpectFault(good + "a101", "it ends in the middle");
  ExpectFault(good + "c0", "it ends a collection that was not begun");
  std::string deep, pushes;
  for (int n = 0; n < 17; ++n)
  {
    deep += "a100";
    pushes += "a4";
  }
  ExpectFault(good + deep, "its collections are too deep");
  ExpectFault(good + pushes, "it pushes too deep");
  ExpectFault(Page + "15f6250a09300931093209330934" + Input, "it lacks an axis");
  ExpectFault(
    Page + "150a250f" + SixUsages + Input, "the range of an axis does not lie on both sides of 0");
  ExpectFault(
    Page + "15f625f0" + SixUsages + Input, "the range of an axis does not lie on both sides of 0");
}

/// Every beginning of a real one, every byte of it changed, and noise: never a range that is none.
TEST(HidReportDescriptor, RandomOnesAreSafe)
{
  std::mt19937 random(8);
  std::uniform_int_distribution<int> any(0, 255), kind(0, 3);
  const auto below = [&](std::size_t size)
  { return static_cast<std::size_t>(random()) % std::max<std::size_t>(size, 1); };
  int faults = 0, good = 0;
  for (int n = 0; n < 250'000; ++n)
  {
    Bytes bytes = n % 2 ? HalvesDescriptor : WholeDescriptor;
    switch (kind(random))
    {
      case 0: // noise
        bytes.resize(below(200));
        for (std::byte& byte : bytes)
          byte = static_cast<std::byte>(any(random));
        break;
      case 1: // cut off
        bytes.resize(below(bytes.size()));
        break;
      case 2: // some bytes are others
        for (std::size_t changes = 1 + below(4); changes > 0; --changes)
          bytes[below(bytes.size())] = static_cast<std::byte>(any(random));
        break;
      default: // a piece twice
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size())),
          HalvesDescriptor.begin(),
          HalvesDescriptor.begin() + static_cast<std::ptrdiff_t>(below(HalvesDescriptor.size())));
    }
    const HidAxes axes = ReadHidAxes(bytes);
    axes.fault ? ++faults : ++good;
    ASSERT_TRUE(!axes.fault || axes.ranges == All(-350, 350));
    for (const AxisRange& range : axes.ranges)
    {
      ASSERT_LT(range.least, 0);
      ASSERT_GT(range.most, 0);
    }
  }
  EXPECT_GT(faults, 10'000); // both ways were taken often
  EXPECT_GT(good, 10'000);
}

} // namespace
