#pragma once
#include "Evaluation/PartClaims.h"

#include <array>
#include <cstdint>
#include <string>

namespace hasp
{

using Colour = std::array<std::uint8_t, 3>;

/// Blue where a wall is nearer to bone than asked, white where it is as asked, red where it is
/// farther; full at twice the tolerance.
Colour GapColour(const ClaimedShell& shell, double gapMm);

inline constexpr Colour NoInnerWall{ 105, 110, 112 }; ///< of what does not face bone within reach

/// The scale of that, as an SVG element.
std::string GapScaleSvg(const ClaimedShell& shell);

} // namespace hasp
