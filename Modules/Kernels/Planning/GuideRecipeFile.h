#pragma once
#include "Planning/GuideRecipe.h"

#include <string>

namespace hasp
{

/// Guide recipes as JSON, readable by people:
///
///   { "format": "hasp-guide-recipe-2", "note": "…", "isovalue": 226,
///     "landmarks": [[x,y,z], …], "outline": "open" | "closed" | "filled",
///     "strokes": [{ "points": [[x,y,z], …], "radiusMm": 5, "erased": false }, …],
///     "withdrawal": [x,y,z], "axisSearchDeg": 0, "gapMm": 0.3, "thicknessMm": 4, "widthMm": 14,
///     "edgeRadiusMm": 0.5, "clearanceMm": 0.25, "wallMm": 3, "sleeveWallMm": 2,
///     "spacingMm": 0.4, "ignoreBelowMm3": 100,
///     "slots": [{ "point": [x,y,z], "normal": [x,y,z], "kerfMm": 1, "lengthMm": 20,
///                 "depthMm": 20, "guidingHeightMm": 15 }, …],
///     "flanges": [{ "point": [x,y,z], "normal": [x,y,z], "kerfMm": 1, "lengthMm": 20,
///                   "heightMm": 15, "depthMm": 20, "freeMm": 10 }, …],
///     "holes": [{ "point": [x,y,z], "axis": [x,y,z], "diameterMm": 3, "depthMm": 20,
///                 "sleeveHeightMm": 6 }, …],
///     "labels": [{ "text": "CASE 7 L", "point": [x,y,z], "right": [x,y,z], "heightMm": 5,
///                  "depthMm": 1, "engraved": false }, …] }
///
/// A label may have "kind": "case" in place of "text"; without a kind it is a "text".
///
/// "hasp-guide-recipe-1" is read, too: it has no strokes, axisSearchDeg, edgeRadiusMm, clearanceMm,
/// walls, flanges and labels, its slots are { point, normal, widthMm, lengthMm } and its holes
/// { point, axis, diameterMm }. The guide is as it was: slots of that width, and holes, 500 mm
/// deep, without boxes, sleeves and round edges.
///
/// Strict: every key but "note" and "kind" must be there, and no other; what ValidateGuideRecipe
/// refuses is refused here, too. Errors are std::runtime_error (file, syntax) or
/// std::invalid_argument (content) and say which key, never the file's name or text. Needs
/// HASP_ENABLE_JSON. Any thread.
GuideRecipe ParseGuideRecipe(const std::string& json);
std::string FormatGuideRecipe(const GuideRecipe& recipe);

/// At most 16 MiB are read.
GuideRecipe ReadGuideRecipe(const std::string& path);
/// The old file or the new one, never half of one (DurableFile.h).
void WriteGuideRecipe(const std::string& path, const GuideRecipe& recipe);

} // namespace hasp
