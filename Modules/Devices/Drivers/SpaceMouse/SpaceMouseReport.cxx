#include "Devices/Drivers/SpaceMouse/SpaceMouseReport.h"

namespace hasp
{

namespace
{
constexpr std::size_t Half = 7, Whole = 13, ShortestButtons = 3, LongestButtons = 7, Battery = 3;

std::uint8_t Byte(std::span<const std::byte> report, std::size_t n) noexcept
{
  return std::to_integer<std::uint8_t>(report[n]);
}

void TakeAxes(std::span<const std::byte> report, std::span<std::int16_t> axes) noexcept
{
  for (std::size_t n = 0; n < axes.size(); ++n)
    axes[n] = static_cast<std::int16_t>(
      static_cast<std::uint16_t>(Byte(report, 1 + 2 * n) | Byte(report, 2 + 2 * n) << 8));
}
} // namespace

SpaceMouseReport SpaceMouseReports::Take(std::span<const std::byte> report) noexcept
{
  const std::size_t size = report.size();
  const std::span all(this->axes);
  ++this->good;
  switch (size > 0 ? Byte(report, 0) : 0)
  {
    case 1:
      if (size == Half)
      {
        TakeAxes(report, all.first(3));
        return SpaceMouseReport::Push;
      }
      if (size == Whole)
      {
        TakeAxes(report, all);
        return SpaceMouseReport::PushAndTurn;
      }
      break;
    case 2:
      if (size == Half)
      {
        TakeAxes(report, all.last(3));
        return SpaceMouseReport::Turn;
      }
      break;
    case 3:
      if (size >= ShortestButtons && size <= LongestButtons)
      {
        this->buttonBits = 0;
        for (std::size_t n = 1; n < size; ++n)
          this->buttonBits |= std::uint64_t{ Byte(report, n) } << 8 * (n - 1);
        return SpaceMouseReport::Buttons;
      }
      break;
    case 0x17:
      if (size == Battery && Byte(report, 1) <= 100)
      {
        this->batteryPercent = Byte(report, 1);
        return SpaceMouseReport::Battery;
      }
      break;
    default:
      break;
  }
  --this->good;
  ++this->wrong;
  return SpaceMouseReport::Wrong;
}

} // namespace hasp
