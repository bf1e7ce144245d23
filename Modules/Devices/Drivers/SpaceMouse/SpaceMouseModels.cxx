#include "Devices/Drivers/SpaceMouse/SpaceMouseModels.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

namespace hasp
{

namespace
{
constexpr std::uint16_t Logitech = 0x046d, Connexion = 0x256f; // before and after 2008
constexpr std::uint16_t UniversalReceiver = 0xc652;
constexpr std::uint16_t GenericDesktop = 1, MultiAxis = 8;

constexpr auto InOrder = []
{
  std::array<std::uint8_t, 32> bits{};
  std::iota(bits.begin(), bits.end(), std::uint8_t{ 0 });
  return bits;
}();
constexpr std::span<const std::uint8_t> First(std::size_t count)
{
  return std::span(InOrder).first(count);
}

// 1 to 4; menu, fit, top, right, front, roll; esc, alt, shift, ctrl, rotation lock.
constexpr std::array<std::uint8_t, 15> Pro{ 12, 13, 14, 15, 0, 1, 2, 4, 5, 8, 22, 23, 24, 25, 26 };
// 1 to 10; menu, fit, top, right, front, roll, iso; esc, alt, shift, ctrl, lock.
constexpr std::array<std::uint8_t, 22> Enterprise{ 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 0, 1, 2,
  4, 5, 8, 10, 22, 23, 24, 25, 26 };
// 1 to 5; menu, fit, top, right, front, roll, iso; esc, alt, shift, ctrl, rotation, pan and zoom,
// dominant axis, plus, minus.
constexpr std::array<std::uint8_t, 21> PilotPro{ 17, 18, 14, 15, 16, 0, 1, 2, 4, 5, 8, 10, 22, 23,
  24, 25, 26, 27, 28, 29, 30 };

constexpr SpaceMouseModel Unlisted{ Connexion, 0, "3Dconnexion device", First(32) };

constexpr std::array Models{
  SpaceMouseModel{ Logitech, 0xc603, "SpaceMouse Plus XT", First(10) },
  SpaceMouseModel{ Logitech, 0xc605, "CADman", First(4) },
  SpaceMouseModel{ Logitech, 0xc606, "SpaceMouse Classic", First(8) },
  SpaceMouseModel{ Logitech, 0xc621, "Spaceball 5000", First(12) },
  SpaceMouseModel{ Logitech, 0xc623, "SpaceTraveler", First(8) },
  SpaceMouseModel{ Logitech, 0xc625, "SpacePilot", First(21) },
  SpaceMouseModel{ Logitech, 0xc626, "SpaceNavigator", First(2) },
  SpaceMouseModel{ Logitech, 0xc627, "SpaceExplorer", First(15) },
  SpaceMouseModel{ Logitech, 0xc628, "SpaceNavigator for Notebooks", First(2) },
  SpaceMouseModel{ Logitech, 0xc629, "SpacePilot Pro", PilotPro },
  SpaceMouseModel{ Logitech, 0xc62b, "SpaceMouse Pro", Pro },
  SpaceMouseModel{ Connexion, 0xc62e, "SpaceMouse Wireless (cable)", First(2) },
  SpaceMouseModel{ Connexion, 0xc62f, "SpaceMouse Wireless (receiver)", First(2) },
  SpaceMouseModel{ Connexion, 0xc631, "SpaceMouse Pro Wireless (cable)", Pro },
  SpaceMouseModel{ Connexion, 0xc632, "SpaceMouse Pro Wireless (receiver)", Pro },
  SpaceMouseModel{ Connexion, 0xc633, "SpaceMouse Enterprise", Enterprise },
  SpaceMouseModel{ Connexion, 0xc635, "SpaceMouse Compact", First(2) },
  SpaceMouseModel{ Connexion, 0xc636, "SpaceMouse Module", First(2) },
  SpaceMouseModel{ Connexion, 0xc638, "SpaceMouse Pro Wireless (Bluetooth)", Pro },
  SpaceMouseModel{ Connexion, 0xc63a, "SpaceMouse Wireless (Bluetooth)", First(2) },
  SpaceMouseModel{ Connexion, 0xc641, "SpaceMouse USB", First(0) },
  // What lies behind it, it does not say: the keys of the largest that may.
  SpaceMouseModel{ Connexion, UniversalReceiver, "3Dconnexion Universal Receiver", Pro },
};

// CadMice and their receivers, keyboards and numeric pads, and c62c.
constexpr std::array<std::uint16_t, 11> Skipped{ 0xc62c, 0xc650, 0xc651, 0xc654, 0xc655, 0xc656,
  0xc657, 0xc658, 0xc664, 0xc665, 0xc668 };

/// "Mouse" as a word of its own: "SpaceMouse" is none.
bool CallsItselfMouse(std::string_view name) noexcept
{
  const std::string_view word = "Mouse";
  const auto letter = [&](std::size_t at)
  { return at < name.size() && ((name[at] | 0x20) >= 'a' && (name[at] | 0x20) <= 'z'); };
  for (std::size_t at = name.find(word); at != name.npos; at = name.find(word, at + 1))
    if ((at == 0 || !letter(at - 1)) && !letter(at + word.size()))
      return true;
  return false;
}
} // namespace

std::span<const SpaceMouseModel> SpaceMouseModels() noexcept
{
  return Models;
}

std::span<const std::uint16_t> SkippedSpaceMouseProducts() noexcept
{
  return Skipped;
}

const SpaceMouseModel* SpaceMouseOf(const HidCollection& collection) noexcept
{
  if (collection.usagePage != GenericDesktop || collection.usage != MultiAxis)
    return nullptr;
  if (collection.vendor == Connexion && std::ranges::count(Skipped, collection.product) > 0)
    return nullptr;
  if (collection.vendor == Connexion && collection.product == UniversalReceiver &&
      CallsItselfMouse(collection.productName))
    return nullptr;
  const auto* const model = std::ranges::find_if(Models, [&](const SpaceMouseModel& m)
    { return m.vendor == collection.vendor && m.product == collection.product; });
  if (model != Models.end())
    return model;
  return collection.vendor == Connexion ? &Unlisted : nullptr;
}

std::uint32_t SpaceMouseButtons(const SpaceMouseModel& model, std::uint64_t bits) noexcept
{
  std::uint32_t held = 0;
  for (std::size_t n = 0; n < model.buttonBits.size(); ++n)
    held |= static_cast<std::uint32_t>(bits >> model.buttonBits[n] & 1u) << n;
  return held;
}

} // namespace hasp
