#pragma once
#include "Planning/GuideRecipe.h"

#include <string>

namespace hasp
{

/// Guide recipes as JSON, readable by people:
///
///   { "format": "hasp-guide-recipe-1", "note": "…", "isovalue": 226,
///     "landmarks": [[x,y,z], …], "outline": "open" | "closed" | "filled", "withdrawal": [x,y,z],
///     "gapMm": 0.3, "thicknessMm": 2.5, "widthMm": 14, "spacingMm": 0.4, "ignoreBelowMm3": 100,
///     "slots": [{ "point": [x,y,z], "normal": [x,y,z], "widthMm": 1, "lengthMm": 20 }, …],
///     "holes": [{ "point": [x,y,z], "axis": [x,y,z], "diameterMm": 2 }, …] }
///
/// Strict: every key but "note" must be there, and no other; what ValidateGuideRecipe refuses is
/// refused here, too. Errors are std::runtime_error (file, syntax) or std::invalid_argument
/// (content) and say which key, never the file's name or text. Needs HASP_ENABLE_JSON. Any thread.
GuideRecipe ParseGuideRecipe(const std::string& json);
std::string FormatGuideRecipe(const GuideRecipe& recipe);

GuideRecipe ReadGuideRecipe(const std::string& path);
/// Writes a temporary file beside `path` and renames it: the old file or the new one, never half.
void WriteGuideRecipe(const std::string& path, const GuideRecipe& recipe);

} // namespace hasp
