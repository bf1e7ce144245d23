#pragma once
#include "Planning/GuideRecipe.h"
#include "Planning/StrictJson.h"

namespace hasp
{

/// A guide recipe as JSON within another file, as a plan's; otherwise as in GuideRecipeFile.h. What
/// ValidateGuideRecipe refuses both refuse. Internal.
Json GuideRecipeToJson(const GuideRecipe& recipe);
GuideRecipe GuideRecipeFromJson(const Json& json);

} // namespace hasp
