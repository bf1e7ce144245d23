#pragma once
#include "Evaluation/PartClaims.h"

#include <array>
#include <cstdint>
#include <string>

namespace hasp
{

using Colour = std::array<std::uint8_t, 3>;

/// Blue where a wall is nearer to bone than asked, white where it is as asked, red where it is
/// farther: bright at a quarter of the tolerance, dark at half of it, almost black at all of it.
/// Beyond that it is another colour at once: violet too near, yellow too far.
Colour GapColour(const ClaimedShell& shell, double gapMm);

inline constexpr Colour NoInnerWall{ 105, 110, 112 }; ///< of what does not face bone within reach

/// The scale of that, as an SVG element.
std::string GapScaleSvg(const ClaimedShell& shell);

} // namespace hasp
