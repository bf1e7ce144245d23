#pragma once
#include "Devices/OpentrackPacket.h"

#include <array>
#include <cstdint>
#include <optional>

namespace hasp
{

/// What came, by kind. Every packet counts in `packets`; the good ones in `good`.
struct OpentrackCounts
{
  std::uint64_t packets = 0;
  std::uint64_t good = 0;
  std::uint64_t tooShort = 0;
  std::uint64_t tooLong = 0;
  std::uint64_t notFinite = 0;
  std::uint64_t outOfRange = 0;
  std::uint64_t duplicated = 0; ///< the bytes of the one before, within half a millisecond
  std::uint64_t late = 0;       ///< good, but a tenth of a second or more after the good one before
  std::uint64_t flooding =
    0; ///< packets beyond 4000 in one second; good ones are used all the same
};

/// Decides about packets as they come: pure, in the time it is told, so that it is tested without a
/// socket. Takes no memory.
/// Threads: WORKER, the one that receives.
class OpentrackInbox
{
public:
  /// origin  where the head is in the room, mm, when opentrack says zero
  explicit OpentrackInbox(const glm::dvec3& origin) : Origin(origin) {}

  /// The pose of a packet that came at `timeS`; nothing if there is none to be had from it.
  std::optional<TimedHeadPose> Take(std::span<const std::byte> packet, double timeS) noexcept;

  const OpentrackCounts& Counts() const noexcept { return this->Seen; }

private:
  bool IsDuplicate(std::span<const std::byte> packet, double timeS) noexcept;
  void CountFlood(double timeS) noexcept;

  glm::dvec3 Origin;
  OpentrackCounts Seen;
  std::array<std::byte, OpentrackPacketBytes> Before{};
  double BeforeS = -1e300; ///< when that came
  double GoodS = 0.0;      ///< when the last good one came
  double SecondS = -1e300; ///< when the running second began
  std::uint64_t InSecond = 0;
};

} // namespace hasp
