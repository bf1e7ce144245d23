#pragma once
#include "Planning/PlateRecipe.h"
#include "Planning/StrictJson.h"

namespace hasp
{

/// A plate recipe as JSON within another file, as a plan's; otherwise as in PlateRecipeFile.h. What
/// ValidatePlateRecipe refuses both refuse. Internal.
Json PlateRecipeToJson(const PlateRecipe& recipe);
PlateRecipe PlateRecipeFromJson(const Json& json);

} // namespace hasp
