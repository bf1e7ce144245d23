#include "Devices/Drivers/Falcon/FalconPacket.h"

#include "Grid/FinitePose.h"

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr std::uint8_t First = '<', Last = '>', Zero = 0x41;
constexpr std::size_t Numbers = 1, Flags = 13, LastByte = 15;
constexpr std::uint8_t HomingBit = 0x01, LightBits = 0x0e, FlagBits = 0x7f;

void PutNumber(FalconPacket& packet, int which, int value)
{
  const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(value));
  for (int nibble = 0; nibble < 4; ++nibble)
    packet[Numbers + 4 * which + nibble] =
      static_cast<std::uint8_t>(Zero + ((bits >> (4 * nibble)) & 0xf));
}

int GetNumber(const FalconPacket& packet, int which)
{
  unsigned bits = 0;
  for (int nibble = 0; nibble < 4; ++nibble)
    bits |= static_cast<unsigned>(packet[Numbers + 4 * which + nibble] - Zero) << (4 * nibble);
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(bits));
}

FalconPacket Empty(std::uint8_t flags)
{
  FalconPacket packet;
  packet.fill(Zero);
  packet.front() = First;
  packet.back() = Last;
  packet[Flags] = static_cast<std::uint8_t>(Zero + flags);
  return packet;
}

bool WellFormed(const FalconPacket& packet)
{
  const auto isNibble = [](std::uint8_t byte) { return byte >= Zero && byte < Zero + 16; };
  return packet.front() == First && packet.back() == Last &&
         std::all_of(packet.begin() + Numbers, packet.begin() + Flags, isNibble) &&
         packet[Flags] >= Zero && packet[Flags] <= Zero + FlagBits && packet[Flags + 1] != First &&
         packet[Flags + 1] != Last;
}
} // namespace

FalconPacket Encode(const FalconCommand& command) noexcept
{
  auto packet = Empty(
    static_cast<std::uint8_t>((command.lights & LightBits) | (command.homing ? HomingBit : 0)));
  for (int i = 0; i < 3; ++i)
    PutNumber(packet, i, std::clamp(command.motors[i], -FalconMostMotor, FalconMostMotor));
  return packet;
}

FalconPacket Encode(const FalconAnswer& answer) noexcept
{
  auto packet =
    Empty(static_cast<std::uint8_t>((answer.buttons & 0xf) | ((answer.homed & 7) << 4)));
  for (int i = 0; i < 3; ++i)
    PutNumber(packet, i, std::clamp(answer.counts[i], -32768, 32767));
  return packet;
}

std::optional<FalconCommand> DecodeCommand(const FalconPacket& packet) noexcept
{
  if (!WellFormed(packet))
    return std::nullopt;
  const auto flags = static_cast<std::uint8_t>(packet[Flags] - Zero);
  return FalconCommand{ { GetNumber(packet, 0), GetNumber(packet, 1), GetNumber(packet, 2) },
    static_cast<std::uint8_t>(flags & LightBits), (flags & HomingBit) != 0 };
}

std::optional<FalconAnswer> DecodeAnswer(const FalconPacket& packet) noexcept
{
  if (!WellFormed(packet))
    return std::nullopt;
  const auto flags = static_cast<std::uint8_t>(packet[Flags] - Zero);
  return FalconAnswer{ { GetNumber(packet, 0), GetNumber(packet, 1), GetNumber(packet, 2) },
    static_cast<std::uint8_t>(flags & 0xf), static_cast<std::uint8_t>(flags >> 4) };
}

std::array<int, 3> ToMotors(const glm::dvec3& wanted) noexcept
{
  if (!IsFinite(wanted))
    return {};
  double largest = FalconMostMotor;
  for (int i = 0; i < 3; ++i)
    largest = std::max(largest, std::abs(wanted[i]));
  const double share = FalconMostMotor / largest;
  std::array<int, 3> motors;
  for (int i = 0; i < 3; ++i)
    motors[i] = static_cast<int>(std::lround(wanted[i] * share));
  return motors;
}

void FalconFraming::DropOne() noexcept
{
  std::copy(this->Window.begin() + 1, this->Window.begin() + this->Length, this->Window.begin());
  --this->Length;
  ++this->DroppedBytes;
  if (!this->Lost)
    ++this->Losses;
  this->Lost = true;
}

std::optional<FalconPacket> FalconFraming::Take(std::uint8_t byte) noexcept
{
  this->Window[this->Length++] = byte;
  if (this->Length == this->Window.size())
  {
    if (WellFormed(this->Window))
    {
      this->Length = 0;
      this->Lost = false;
      return this->Window;
    }
    this->DropOne();
  }
  while (this->Length > 0 && this->Window.front() != First)
    this->DropOne();
  return std::nullopt;
}

std::span<std::uint8_t> FtdiPayload(std::span<std::uint8_t> transfer) noexcept
{
  constexpr std::size_t Packet = 64, Status = 2;
  auto end = transfer.begin();
  for (std::size_t at = 0; at < transfer.size(); at += Packet)
  {
    const auto packet = transfer.subspan(at, std::min(Packet, transfer.size() - at));
    if (packet.size() > Status)
      end = std::copy(packet.begin() + Status, packet.end(), end);
  }
  return { transfer.begin(), end };
}

} // namespace hasp
