#pragma once
#include "Planning/GuideRecipe.h"

#include <string>

namespace hasp
{

/// Reads a guide's recipe. Throws Failure: BadInput, naming the file by its kind.
GuideRecipe ReadRecipe(const std::string& path);

} // namespace hasp
