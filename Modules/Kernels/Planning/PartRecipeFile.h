#pragma once
#include "Planning/GuideRecipe.h"
#include "Planning/ImplantRecipe.h"
#include "Planning/PlateRecipe.h"

#include <string>
#include <variant>

namespace hasp
{

/// A recipe of one part that fits bone.
using PartRecipe = std::variant<GuideRecipe, PlateRecipe, ImplantRecipe>;

/// The recipe that a file's "format" says; what says no other is read as a guide's. Errors as
/// GuideRecipeFile.h has them. Needs HASP_ENABLE_JSON. Any thread.
PartRecipe ParsePartRecipe(const std::string& json);
PartRecipe ReadPartRecipe(const std::string& path);

} // namespace hasp
