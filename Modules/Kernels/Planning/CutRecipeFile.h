#pragma once
#include "Planning/CutRecipe.h"

#include <string>

namespace hasp
{

/// Cut recipes as JSON, readable by people:
///
///   { "format": "hasp-cut-recipe-1", "isovalue": 226, "spacingMm": 0.5, "ignoreBelowMm3": 100,
///     "crumbBelowMm3": 20,
///     "cuts": [{ "point": [x,y,z], "normal": [x,y,z], "along": [x,y,z], "widthMm": 60,
///                "depthMm": 60, "kerfMm": 1, "reachMm": 8 }, …],
///     "resected": [[x,y,z], …] }
///
/// Strict: every key must be there, and no other; what ValidateCutRecipe refuses is refused here,
/// too. Errors are std::runtime_error (file, syntax) or std::invalid_argument (content) and say
/// which key, never the file's name or text. Needs HASP_ENABLE_JSON. Any thread.
CutRecipe ParseCutRecipe(const std::string& json);
std::string FormatCutRecipe(const CutRecipe& recipe);
CutRecipe ReadCutRecipe(const std::string& path);

} // namespace hasp
