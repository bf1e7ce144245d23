#pragma once
#include "Planning/ImplantRecipe.h"

#include <string>

namespace hasp
{

/// Implant recipes as JSON, readable by people:
///
///   { "format": "hasp-implant-recipe-1", "note": "…", "isovalue": 226, "ignoreBelowMm3": 100,
///     "mirror": { "point": [x,y,z], "normal": [x,y,z] }, "outline": [[x,y,z], …],
///     "axis": [x,y,z], "clearanceMm": 0.5, "thicknessMm": 4, "spacingMm": 0.5,
///     "holeDiameterMm": 0, "holePitchMm": 8, "holeEdgeMm": 3 }
///
/// Strict: every key but "note", "mirror" and "axis" must be there, and no other; what
/// ValidateImplantRecipe refuses is refused here, too. Errors are std::runtime_error (file, syntax)
/// or std::invalid_argument (content) and say which key, never the file's name or text. Needs
/// HASP_ENABLE_JSON. Any thread.
ImplantRecipe ParseImplantRecipe(const std::string& json);
std::string FormatImplantRecipe(const ImplantRecipe& recipe);
ImplantRecipe ReadImplantRecipe(const std::string& path);

} // namespace hasp
