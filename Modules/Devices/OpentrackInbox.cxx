#include "Devices/OpentrackInbox.h"

#include <algorithm>

namespace hasp
{

namespace
{
// opentrack sends every 4 ms, the fastest trackers every ms: what is twice there sooner was doubled
// on its way. The same bytes later are a head that keeps still.
constexpr double DuplicateWithinS = 0.0005;
constexpr double LateAfterS = 0.1;
constexpr std::uint64_t FloodPerS = 4000;
} // namespace

std::optional<TimedHeadPose> OpentrackInbox::Take(
  std::span<const std::byte> packet, double timeS) noexcept
{
  ++this->Seen.packets;
  this->CountFlood(timeS);
  OpentrackPacket parsed = ParseOpentrackPacket(packet);
  parsed.pose.position += this->Origin;
  if (parsed.fault == OpentrackFault::None && FaultOf(parsed.pose) != HeadPoseFault::None)
    parsed.fault = OpentrackFault::OutOfRange;
  switch (parsed.fault)
  {
    case OpentrackFault::None:
      break;
    case OpentrackFault::Short:
      ++this->Seen.tooShort;
      return std::nullopt;
    case OpentrackFault::Long:
      ++this->Seen.tooLong;
      return std::nullopt;
    case OpentrackFault::NotFinite:
      ++this->Seen.notFinite;
      return std::nullopt;
    case OpentrackFault::OutOfRange:
      ++this->Seen.outOfRange;
      return std::nullopt;
  }
  if (this->IsDuplicate(packet, timeS))
  {
    ++this->Seen.duplicated;
    return std::nullopt;
  }
  if (this->Seen.good > 0 && timeS - this->GoodS >= LateAfterS)
    ++this->Seen.late;
  ++this->Seen.good;
  this->GoodS = timeS;
  return TimedHeadPose{ timeS, parsed.pose };
}

bool OpentrackInbox::IsDuplicate(std::span<const std::byte> packet, double timeS) noexcept
{
  if (timeS - this->BeforeS < DuplicateWithinS && std::ranges::equal(packet, this->Before))
    return true;
  std::ranges::copy(packet, this->Before.begin());
  this->BeforeS = timeS;
  return false;
}

void OpentrackInbox::CountFlood(double timeS) noexcept
{
  if (timeS - this->SecondS >= 1.0)
  {
    this->SecondS = timeS;
    this->InSecond = 0;
  }
  this->Seen.flooding += ++this->InSecond > FloodPerS;
}

} // namespace hasp
