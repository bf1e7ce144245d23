#pragma once
#include "Planning/TransplantRecipe.h"

#include <string>

namespace hasp
{

/// Transplant recipes as JSON, readable by people:
///
///   { "format": "hasp-transplant-recipe-1",
///     "resection": { all that a cuts file holds, its format too: CutRecipeFile.h },
///     "path": [[x,y,z], …], "outward": [[x,y,z], …], "rollDeg": 0, "leastSegmentMm": 20,
///     "mostGapMm": 0.5, "mostOverlapMm": 0.5,
///     "donor": { "isovalue": 226, "axis": [[x,y,z], …], "findAxis": false, "lateral": [x,y,z],
///                "radiusMm": 9, "keepMm": 75, "fromLastTip": false, "startOffsetMm": 0,
///                "kerfMm": 1, "betweenMm": 1.5, "vessel": [[x,y,z], …],
///                "paddle": { "outline": [[x,y,z], …], "perforator": [x,y,z] } },
///     "guide": { "gapMm": 0.3, "thicknessMm": 4, "widthMm": 14, "clearanceMm": 0.25, "wallMm": 3,
///                "slotLengthMm": 20, "guidingHeightMm": 15, "beyondMm": 15, "pinDiameterMm": 3,
///                "spacingMm": 0.4 } }
///
/// Strict: every key must be there but "paddle", and no other; what ValidateTransplantRecipe
/// refuses is refused here, too. Errors are std::runtime_error (file, syntax) or
/// std::invalid_argument (content) and say which key, never the file's name or text. Needs
/// HASP_ENABLE_JSON. Any thread.
TransplantRecipe ParseTransplantRecipe(const std::string& json);
std::string FormatTransplantRecipe(const TransplantRecipe& recipe);
TransplantRecipe ReadTransplantRecipe(const std::string& path);

} // namespace hasp
