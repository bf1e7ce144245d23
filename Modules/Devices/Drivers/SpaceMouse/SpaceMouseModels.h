#pragma once
#include <cstdint>
#include <span>
#include <string>

/// Which devices are a SpaceMouse, and where their buttons lie.
///
/// Product numbers from spacenavd 1.3.1 and PySpaceMouse; buttons from the latter. Buttons are
/// verified by nobody here: that of the Enterprise lists 22 of its 31 keys, the others are not
/// heard. c641 is in one list a 6-DOF device and in the other skipped; here its HID collection
/// decides, as with all.
namespace hasp
{

struct SpaceMouseModel
{
  std::uint16_t vendor, product;
  const char* name; ///< for people
  /// Button n is bit buttonBits[n] of what follows the id in report 3, the lowest bit of its first
  /// byte being 0. The keys that carry numbers come first. At most 32, each in [0, 47].
  std::span<const std::uint8_t> buttonBits;
};

/// One collection of a HID device, as an operating system lists it.
struct HidCollection
{
  std::string path; ///< to open it by
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t usagePage = 0, usage = 0;
  std::string productName; ///< UTF-8; what the device says of itself
};

/// All that are listed. Any thread.
std::span<const SpaceMouseModel> SpaceMouseModels() noexcept;

/// Products of vendor 256f that are a mouse or a keyboard.
std::span<const std::uint16_t> SkippedSpaceMouseProducts() noexcept;

/// The model, if this collection is the one that says deflections: usage page 1, usage 8
/// (multi-axis controller), listed, and not skipped; of the Universal Receiver (c652) not the one
/// that calls itself a "Mouse". A product of vendor 256f that no list knows and that has such a
/// collection is taken as a "3Dconnexion device" with buttons as they come. Null: none. Any thread.
const SpaceMouseModel* SpaceMouseOf(const HidCollection& collection) noexcept;

/// The buttons that are held: `bits` as in SpaceMouseModel. Bits that no list knows are no buttons.
std::uint32_t SpaceMouseButtons(const SpaceMouseModel& model, std::uint64_t bits) noexcept;

} // namespace hasp
