#pragma once
#include "Devices/Drivers/SpaceMouse/SixDofAxes.h"

#include <cstddef>
#include <span>

namespace hasp
{

/// The ranges of X, Y, Z, Rx, Ry, Rz that a HID report descriptor promises.
struct HidAxes
{
  AxisRanges ranges{};         ///< counts; all +-350 where there is a fault
  const char* fault = nullptr; ///< why the descriptor says nothing, for people; null: it does
};

/// Reads the logical minimum and maximum of usages 30 to 35 on usage page 1 (generic desktop) of
/// the Input items, the first of each counting.
///
/// Short items of all sizes, push and pop; long items are skipped (USB HID 1.11, 6.2.2). A
/// descriptor is at fault if an item is cut off, pushes or collections do not match or nest deeper
/// than 16, an axis is missing, or a range does not lie on both sides of 0. Any bytes are safe.
/// Never throws, takes no memory; O(bytes). Any thread.
HidAxes ReadHidAxes(std::span<const std::byte> descriptor) noexcept;

} // namespace hasp
