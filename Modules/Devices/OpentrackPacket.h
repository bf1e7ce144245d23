#pragma once
#include "Devices/HeadPose.h"

#include <array>
#include <cstddef>
#include <span>

/// What opentrack's output "UDP over network" sends: 48 bytes, six little-endian doubles, neither
/// header nor number nor time.
///
///   bytes  | opentrack, unit | positive when the user …        | room, HeadPose
///   0 - 7  | X, cm           | moves to his left               | position.x = -10 X
///   8 - 15 | Y, cm           | moves up                        | position.y = +10 Y
///   16 - 23| Z, cm           | moves away from the screen      | position.z = +10 Z
///   24 - 31| yaw, degrees    | turns to his right              | -yaw about y, first
///   32 - 39| pitch, degrees  | looks up                        | +pitch about x, then
///   40 - 47| roll, degrees   | tilts to his left               | +roll about z, last
///
/// opentrack documents order and units (its issues 420, 881, 1203) and no signs. These are those of
/// its sources, where its trackers neuralnet and SteamVR agree; order of turns as in its
/// compat/euler.cpp. A profile of opentrack may turn any axis round (Options, Output): then the
/// view moves the wrong way, and it is turned back there. Zero is where the user pressed "center".
namespace hasp
{

constexpr std::size_t OpentrackPacketBytes = 48;

enum class OpentrackFault
{
  None,
  Short,     ///< fewer than 48 bytes
  Long,      ///< more
  NotFinite, ///< NaN or infinite
  OutOfRange ///< more than 1000 cm or 360 degrees
};

struct OpentrackPacket
{
  OpentrackFault fault = OpentrackFault::None;
  HeadPose pose; ///< relative to opentrack's centre; means something if there is no fault
};

/// Reads one packet. Never throws, takes no memory. Any thread.
OpentrackPacket ParseOpentrackPacket(std::span<const std::byte> bytes) noexcept;

/// The packet opentrack would send for this pose, relative to its centre. For tests and to send
/// poses to another program. Pitch in [-90, 90] degrees.
std::array<std::byte, OpentrackPacketBytes> MakeOpentrackPacket(const HeadPose& pose) noexcept;

} // namespace hasp
