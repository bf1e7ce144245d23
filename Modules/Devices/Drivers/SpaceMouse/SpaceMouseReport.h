#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// What 3Dconnexion devices send over HID: little-endian reports that begin with their id.
///
///   id   | bytes with id | content
///   1    | 7             | x y z, 16 bits each with sign: the older layout, and the Compact
///   2    | 7             | rx ry rz
///   1    | 13            | x y z rx ry rz: the newer layout
///   3    | 3 - 7         | a bit a button, from the lowest of the first byte
///   0x17 | 3             | battery, percent; a byte that is not read
///
/// Which layout a device speaks its reports' length says, not its product number. Newer firmware of
/// the Enterprise also numbers its keys in a report 1c, which is skipped: what it says of keys that
/// no list knows is not heard. (spacenavd 1.3.1, PySpaceMouse, captures of AndunHH/spacemouse; not
/// verified with a device in hand.)
namespace hasp
{

enum class SpaceMouseReport
{
  Wrong, ///< no report of theirs
  Push,
  Turn,
  PushAndTurn,
  Buttons,
  Battery
};

/// What a device has said so far. A plain value.
struct SpaceMouseReports
{
  std::array<std::int16_t, 6> axes{}; ///< x y z rx ry rz as sent: see SixDofAxes.h
  std::uint64_t buttonBits = 0;       ///< see SpaceMouseModel
  std::optional<int> batteryPercent;  ///< in [0, 100]
  std::uint64_t good = 0, wrong = 0;  ///< reports

  /// Takes one report in; a wrong one is counted and changes nothing else. Never throws, takes no
  /// memory.
  SpaceMouseReport Take(std::span<const std::byte> report) noexcept;
};

/// The output report that switches the light of the cap.
constexpr std::array<std::byte, 2> SpaceMouseLight(bool on) noexcept
{
  return { std::byte{ 4 }, on ? std::byte{ 1 } : std::byte{ 0 } };
}

} // namespace hasp
