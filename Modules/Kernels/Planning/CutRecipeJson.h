#pragma once
#include "Planning/CutRecipe.h"
#include "Planning/StrictJson.h"

namespace hasp
{

/// A cut recipe as JSON within another file, as a transplant's; otherwise as in CutRecipeFile.h.
/// What ValidateCutRecipe refuses both refuse. Internal.
Json CutRecipeToJson(const CutRecipe& recipe);
CutRecipe CutRecipeFromJson(const Json& json);

} // namespace hasp
