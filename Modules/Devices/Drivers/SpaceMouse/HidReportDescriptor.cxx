#include "Devices/Drivers/SpaceMouse/HidReportDescriptor.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hasp
{

namespace
{
constexpr std::size_t Deepest = 16;
constexpr std::size_t MostUsages = 64; // of one Input item; further ones name no axis
constexpr std::uint32_t FirstAxis = 0x0001'0030, LastAxis = 0x0001'0035; // page and usage: X … Rz

// An item's tag and type, its size taken away.
enum Item : std::uint8_t
{
  Input = 0x80,
  Output = 0x90,
  Collection = 0xa0,
  Feature = 0xb0,
  EndCollection = 0xc0,
  UsagePage = 0x04,
  LogicalMinimum = 0x14,
  LogicalMaximum = 0x24,
  Push = 0xa4,
  Pop = 0xb4,
  Usage = 0x08,
  UsageMinimum = 0x18,
  UsageMaximum = 0x28
};
constexpr std::uint8_t LongItem = 0xfe;

struct Number
{
  std::uint32_t plain = 0;
  std::int32_t withSign = 0;
  std::size_t bytes = 0;
};

Number ReadNumber(std::span<const std::byte> bytes) noexcept
{
  Number number{ 0, 0, bytes.size() };
  for (std::size_t n = 0; n < bytes.size(); ++n)
    number.plain |= std::to_integer<std::uint32_t>(bytes[n]) << 8 * n;
  const int above = 32 - 8 * static_cast<int>(bytes.size());
  number.withSign = bytes.empty() ? 0 : static_cast<std::int32_t>(number.plain << above) >> above;
  return number;
}

class Reader
{
public:
  /// Null, or what is wrong.
  const char* Take(std::uint8_t item, const Number& number) noexcept
  {
    switch (item)
    {
      case UsagePage:
        this->Now.page = number.plain & 0xffff;
        break;
      case LogicalMinimum:
        this->Now.least = number.withSign;
        break;
      case LogicalMaximum:
        this->Now.most = number;
        break;
      case Push:
        if (this->Pushed == Deepest)
          return "it pushes too deep";
        this->Stack[this->Pushed++] = this->Now;
        break;
      case Pop:
        if (this->Pushed == 0)
          return "it pops what was not pushed";
        this->Now = this->Stack[--this->Pushed];
        break;
      case Usage:
        this->AddUsage(this->WithPage(number));
        break;
      case UsageMinimum:
        this->FirstOfMany = this->WithPage(number);
        break;
      case UsageMaximum:
        for (std::uint64_t u = this->FirstOfMany;
             u <= this->WithPage(number) && this->Usages < MostUsages; ++u)
          this->AddUsage(static_cast<std::uint32_t>(u));
        break;
      case Collection:
        if (this->Open++ == Deepest)
          return "its collections are too deep";
        this->Usages = 0;
        break;
      case EndCollection:
        if (this->Open == 0)
          return "it ends a collection that was not begun";
        --this->Open;
        this->Usages = 0;
        break;
      case Input:
        this->TakeAxes();
        this->Usages = 0;
        break;
      case Output:
      case Feature:
        this->Usages = 0;
        break;
      default: // what has no say in ranges
        break;
    }
    return nullptr;
  }

  const char* End(AxisRanges& ranges) const noexcept
  {
    if (this->Open > 0 || this->Pushed > 0)
      return "it ends in the middle";
    if (std::ranges::count(this->Seen, true) != 6)
      return "it lacks an axis";
    for (const AxisRange& range : this->Ranges)
      if (range.least >= 0 || range.most <= 0)
        return "the range of an axis does not lie on both sides of 0";
    ranges = this->Ranges;
    return nullptr;
  }

private:
  struct Globals
  {
    std::uint32_t page = 0;
    std::int32_t least = 0;
    Number most;
  };

  /// A usage of four bytes brings its page along.
  std::uint32_t WithPage(const Number& usage) const noexcept
  {
    return usage.bytes == 4 ? usage.plain : this->Now.page << 16 | usage.plain;
  }
  void AddUsage(std::uint32_t usage) noexcept
  {
    if (this->Usages < MostUsages)
      this->UsageList[this->Usages++] = usage;
  }
  void TakeAxes() noexcept
  {
    // The maximum has a sign where the minimum is below 0 (HID 1.11, 5.8).
    const AxisRange range{ this->Now.least, this->Now.most.withSign };
    for (std::size_t n = 0; n < this->Usages; ++n)
    {
      const std::uint32_t usage = this->UsageList[n];
      if (usage < FirstAxis || usage > LastAxis || this->Seen[usage - FirstAxis])
        continue;
      this->Seen[usage - FirstAxis] = true;
      this->Ranges[usage - FirstAxis] = range;
    }
  }

  Globals Now;
  std::array<Globals, Deepest> Stack{};
  std::size_t Pushed = 0, Open = 0, Usages = 0;
  std::array<std::uint32_t, MostUsages> UsageList{};
  std::uint32_t FirstOfMany = 0;
  AxisRanges Ranges{};
  std::array<bool, 6> Seen{};
};
} // namespace

HidAxes ReadHidAxes(std::span<const std::byte> descriptor) noexcept
{
  constexpr const char* CutOff = "an item is cut off";
  Reader reader;
  HidAxes axes;
  while (!descriptor.empty())
  {
    const auto prefix = std::to_integer<std::uint8_t>(descriptor[0]);
    if (prefix == LongItem) // prefix, size, tag, data
    {
      if (descriptor.size() < 3 ||
          descriptor.size() < 3 + std::to_integer<std::size_t>(descriptor[1]))
        return { {}, CutOff };
      descriptor = descriptor.subspan(3 + std::to_integer<std::size_t>(descriptor[1]));
      continue;
    }
    const std::size_t size = (prefix & 3u) == 3u ? 4 : prefix & 3u;
    if (descriptor.size() < 1 + size)
      return { {}, CutOff };
    const auto item = static_cast<std::uint8_t>(prefix & ~3u);
    if (const char* const fault = reader.Take(item, ReadNumber(descriptor.subspan(1, size))))
      return { {}, fault };
    descriptor = descriptor.subspan(1 + size);
  }
  axes.fault = reader.End(axes.ranges);
  return axes;
}

} // namespace hasp
