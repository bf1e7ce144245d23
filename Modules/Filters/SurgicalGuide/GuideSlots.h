#pragma once
#include "Planning/GuideRecipe.h"
#include "Planning/Osteotomy.h"

#include <span>
#include <vector>

namespace hasp
{

/// A slot for each blade of cuts that a guide follows. Its plane and kerf are the blade's; across
/// it is as long as the blade is, seen along the withdrawal direction; it begins at the height of
/// the recipe's landmark, or place of a stroke, that is nearest to the blade's plane, since those
/// lie on the bone, and ends where the blade ends. Guiding boxes are as high as GuideSlot's
/// default. Throws std::invalid_argument "blades[n] …" where a blade's plane has the withdrawal
/// direction for its normal, or ends above the bone. Any thread.
std::vector<GuideSlot> SlotsOf(std::span<const Osteotomy> blades, const GuideRecipe& recipe);

} // namespace hasp
