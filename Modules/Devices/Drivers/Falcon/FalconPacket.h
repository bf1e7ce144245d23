#pragma once
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

/// What a Falcon with its firmware running says and is told: 16 bytes each way, one answer for one
/// command. Byte 0 is '<', byte 15 '>', all between are 0x41 + a nibble: three signed numbers of 16
/// bits at 1, 5 and 9, low nibble first, and flags at 13. Source: libnifalcon (BSD), as its code
/// does it. Any thread; no memory; nothing throws.
namespace hasp
{

using FalconPacket = std::array<std::uint8_t, 16>;

constexpr int FalconMostMotor = 4095;

/// To the device.
struct FalconCommand
{
  /// The three colours of its ring, as libnifalcon names the bits: its header and its comment
  /// differ, so which bit is which colour is not certain.
  enum Light : std::uint8_t
  {
    Green = 0x02,
    Blue = 0x04,
    Red = 0x08
  };
  std::array<int, 3> motors{}; ///< [-4095, 4095]
  std::uint8_t lights = 0;     ///< Light
  /// Ask for the counts' zero to be found. Kept set: what the firmware does when it falls is not
  /// known.
  bool homing = true;

  bool operator==(const FalconCommand&) const = default;
};

/// From the device.
struct FalconAnswer
{
  std::array<int, 3> counts{}; ///< of the encoders, [-32768, 32767]
  std::uint8_t buttons = 0;    ///< of the grip: 1 right (plus), 2 front, 4 centre, 8 left (minus)
  std::uint8_t homed = 0;      ///< bit n: the zero of encoder n is found

  bool AllHomed() const { return this->homed == 7; }
  bool operator==(const FalconAnswer&) const = default;
};

/// Numbers beyond their range are cut to it.
FalconPacket Encode(const FalconCommand& command) noexcept;
FalconPacket Encode(const FalconAnswer& answer) noexcept;

/// nullopt: it is none. Byte 14 may be anything that is not a mark.
std::optional<FalconCommand> DecodeCommand(const FalconPacket& packet) noexcept;
std::optional<FalconAnswer> DecodeAnswer(const FalconPacket& packet) noexcept;

/// The nearest motor numbers. If one is beyond +-4095, all three are made smaller by one factor, so
/// that the force is weaker and its direction the same (but for rounding). All zero where one is
/// not finite.
std::array<int, 3> ToMotors(const glm::dvec3& wanted) noexcept;

/// Finds packets in a stream of bytes that may begin anywhere and lack or repeat any.
class FalconFraming
{
public:
  /// The packet that this byte completes: its marks are there and its numbers are numbers.
  std::optional<FalconPacket> Take(std::uint8_t byte) noexcept;

  std::uint64_t Dropped() const noexcept { return this->DroppedBytes; } ///< bytes of no packet
  std::uint64_t Resyncs() const noexcept { return this->Losses; } ///< times that it had to look

private:
  void DropOne() noexcept;

  FalconPacket Window{};
  std::size_t Length = 0;
  std::uint64_t DroppedBytes = 0, Losses = 0;
  bool Lost = false;
};

/// What an FTDI chip sent, without the two status bytes that begin each of its 64-byte packets: the
/// payload is moved together to the front of `transfer`, and is the part that is returned.
std::span<std::uint8_t> FtdiPayload(std::span<std::uint8_t> transfer) noexcept;

} // namespace hasp
