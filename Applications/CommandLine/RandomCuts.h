#pragma once
#include "PartLine.h"

#include <cstdint>

namespace hasp
{

/// Cuts vault, jaw or fibula of the phantom by one or two blades that a seed draws. figure: the
/// share of bone that fragments and kerfs do not account for. All cores.
PartLine TryCut(std::uint32_t seed);

} // namespace hasp
