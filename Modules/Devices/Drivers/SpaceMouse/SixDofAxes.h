#pragma once
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <span>

/// From the numbers of 3Dconnexion devices, and of the daemon for them, to device axes (those of
/// HapticDevice.h: x right, y up, z towards the user; turns by the right-hand rule).
///
///   Hasp          | a device's HID numbers | spacenavd's numbers
///   push right    | +x                     | +x
///   push up       | -z                     | +y
///   push to user  | +y                     | -z
///   turn about x  | +rx                    | +rx
///   turn about y  | -rz                    | +ry
///   turn about z  | +ry                    | -rz
///
/// HID: x right, y to the user, z down, turns by the right-hand rule (HID Usage Tables, generic
/// desktop page). spacenavd's: what its default axis map and inversions make of those; libspnav's
/// spnav_posrot_moveobj and the ROS node spacenav_node read them as here. Blender turns the other
/// way round: there the hand moves the camera. A user may have turned axes of the daemon round:
/// then they are here too. Not verified with a device in hand.
namespace hasp
{

/// Counts of full deflection to either side: least < 0 < most.
struct AxisRange
{
  int least = -350, most = 350;
  bool operator==(const AxisRange&) const noexcept = default;
};
using AxisRanges = std::array<AxisRange, 6>;

/// Where a device axis comes from: the index of a number and its sign.
struct SignedAxis
{
  int number;
  int sign;
};
/// Push along x, y, z, then turn about x, y, z.
using SixDofAxes = std::array<SignedAxis, 6>;

inline constexpr SixDofAxes SpaceMouseAxes{ { { 0, +1 }, { 2, -1 }, { 1, +1 }, { 3, +1 }, { 5, -1 },
  { 4, +1 } } };
inline constexpr SixDofAxes SpacenavAxes{ { { 0, +1 }, { 1, +1 }, { 2, -1 }, { 3, +1 }, { 4, +1 },
  { 5, -1 } } };

/// Share of full deflection, in [-1, 1]: devices say up to half as much again as they promise, and
/// that is full deflection too. 0 where the range has no such side.
constexpr double Deflection(int count, const AxisRange& range) noexcept
{
  const int full = count < 0 ? range.least : range.most;
  if (full == 0 || (count < 0) != (full < 0))
    return 0.0;
  const double share = static_cast<double>(count) / full;
  return count < 0 ? -std::min(share, 1.0) : std::min(share, 1.0);
}

/// Deflections along (first 0) or about (first 3) the device axes, each in [-1, 1]. Any thread;
/// nothing throws.
template <class Int>
constexpr glm::dvec3 DeviceDeflections(std::span<const Int, 6> numbers, const AxisRanges& ranges,
  const SixDofAxes& axes, std::size_t first) noexcept
{
  glm::dvec3 all(0.0);
  for (int n = 0; n < 3; ++n)
  {
    const SignedAxis& axis = axes[first + static_cast<std::size_t>(n)];
    const auto from = static_cast<std::size_t>(axis.number);
    all[n] = axis.sign * Deflection(numbers[from], ranges[from]);
  }
  return all;
}

} // namespace hasp
