#pragma once
#include "Planning/PlateRecipe.h"

#include <string>

namespace hasp
{

/// Plate recipes as JSON, readable by people:
///
///   { "format": "hasp-plate-recipe-1", "note": "…", "isovalue": 226, "ignoreBelowMm3": 100,
///     "landmarks": [[x,y,z], …], "gapMm": 0.2, "thicknessMm": 2.5, "widthMm": 7, "bevelMm": 0.75,
///     "bridgeMm": 0, "edgeDistanceMm": 1, "holeDistanceMm": 1, "spacingMm": 0.4,
///     "screws": [{ "point": [x,y,z], "axis": [x,y,z], "diameterMm": 2.4, "headDiameterMm": 4,
///                  "headDepthMm": 0.3, "headAngleDeg": 90, "lengthMm": 8 }, …],
///     "fragments": [{ "label": 1, "position": [x,y,z], "orientation": [w,x,y,z] }, …] }
///
/// Strict: every key but "note" and a screw's "axis" must be there, and no other; what
/// ValidatePlateRecipe refuses is refused here, too. Errors are std::runtime_error (file, syntax)
/// or std::invalid_argument (content) and say which key, never the file's name or text. Needs
/// HASP_ENABLE_JSON. Any thread.
PlateRecipe ParsePlateRecipe(const std::string& json);
std::string FormatPlateRecipe(const PlateRecipe& recipe);
PlateRecipe ReadPlateRecipe(const std::string& path);

} // namespace hasp
