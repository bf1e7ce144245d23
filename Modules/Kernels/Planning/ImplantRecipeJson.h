#pragma once
#include "Planning/ImplantRecipe.h"
#include "Planning/StrictJson.h"

namespace hasp
{

/// An implant recipe as JSON within another file, as a plan's; otherwise as in ImplantRecipeFile.h.
/// What ValidateImplantRecipe refuses both refuse. Internal.
Json ImplantRecipeToJson(const ImplantRecipe& recipe);
ImplantRecipe ImplantRecipeFromJson(const Json& json);

} // namespace hasp
