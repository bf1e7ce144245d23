#pragma once

namespace hasp
{

/// Data/cranium-guide.json, for programs that run far from it.
const char* CraniumGuideRecipe();

} // namespace hasp
