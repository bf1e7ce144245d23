#include "Devices/OpentrackPacket.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace hasp
{

namespace
{
constexpr double MostCm = 1000.0, MostDegrees = 360.0;

/// The table of the header: what of opentrack's is what of ours.
constexpr glm::dvec3 MmPerUnit{ -10.0, 10.0, 10.0 };  ///< X, Y, Z
constexpr glm::dvec3 TurnPerDegree{ -1.0, 1.0, 1.0 }; ///< yaw, pitch, roll about y, x, z

double ReadDouble(std::span<const std::byte> bytes)
{
  std::uint64_t bits = 0;
  for (int b = 7; b >= 0; --b)
    bits = bits << 8 | std::to_integer<std::uint64_t>(bytes[b]);
  return std::bit_cast<double>(bits);
}

void WriteDouble(std::byte* bytes, double value)
{
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int b = 0; b < 8; ++b)
    bytes[b] = static_cast<std::byte>(bits >> 8 * b & 0xFF);
}
} // namespace

OpentrackPacket ParseOpentrackPacket(std::span<const std::byte> bytes) noexcept
{
  if (bytes.size() != OpentrackPacketBytes)
    return { bytes.size() < OpentrackPacketBytes ? OpentrackFault::Short : OpentrackFault::Long,
      {} };
  std::array<double, 6> v{};
  for (std::size_t n = 0; n < v.size(); ++n)
  {
    v[n] = ReadDouble(bytes.subspan(8 * n, 8));
    if (!std::isfinite(v[n]))
      return { OpentrackFault::NotFinite, {} };
  }
  for (std::size_t n = 0; n < v.size(); ++n)
    if (std::abs(v[n]) > (n < 3 ? MostCm : MostDegrees))
      return { OpentrackFault::OutOfRange, {} };
  const glm::dvec3 turn = glm::radians(TurnPerDegree * glm::dvec3(v[3], v[4], v[5]));
  return { OpentrackFault::None,
    { MmPerUnit * glm::dvec3(v[0], v[1], v[2]), HeadOrientation(turn[0], turn[1], turn[2]) } };
}

std::array<std::byte, OpentrackPacketBytes> MakeOpentrackPacket(const HeadPose& pose) noexcept
{
  // Columns: the head's axes. Of yaw · pitch · roll, backwards = (sin y cos p, -sin p, cos y cos
  // p).
  const glm::dmat3 axes = glm::mat3_cast(glm::normalize(pose.orientation));
  const glm::dvec3 turn(std::atan2(axes[2].x, axes[2].z),
    std::asin(std::clamp(-axes[2].y, -1.0, 1.0)), std::atan2(axes[0].y, axes[1].y));
  const glm::dvec3 position = pose.position / MmPerUnit,
                   angles = glm::degrees(turn) * TurnPerDegree;
  std::array<std::byte, OpentrackPacketBytes> bytes{};
  for (int n = 0; n < 3; ++n)
  {
    WriteDouble(bytes.data() + 8 * n, position[n]);
    WriteDouble(bytes.data() + 24 + 8 * n, angles[n]);
  }
  return bytes;
}

} // namespace hasp
