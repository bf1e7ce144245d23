#pragma once
#include "Planning/SegmentationRecipe.h"

#include <string>

namespace hasp
{

/// Segmentation recipes as JSON, readable by people:
///
///   { "format": "hasp-segmentation-1",
///     "steps": [{ "step": "gaussian", "sigmaMm": 0.5 },
///               { "step": "median", "radiusMm": 1 },
///               { "step": "edge-preserving", "edge": 100, "iterations": 4 },
///               { "step": "cone-beam-correction", "fieldMm": 60, "contrastMm": 0,
///                 "insideAbove": 0 },
///               { "step": "threshold", "lowest": 226, "highest": 1000000, "smoothMm": 0 },
///               { "step": "split", "label": 1, "beta": 90, "crack": 0.1, "norm": 1,
///                 "strokes": [{ "label": 2, "radiusMm": 2, "points": [[x,y,z], …] }, …] },
///               { "step": "paint", "only": 0,
///                 "stroke": { "label": 2, "radiusMm": 2, "points": [[x,y,z], …] } },
///               { "step": "merge", "from": 2, "into": 1 },
///               { "step": "components", "label": 1, "leastMm3": 0, "keepLargestAlone": false },
///               { "step": "fill", "label": 1 },
///               { "step": "morphology", "label": 1,
///                 "operation": "dilate", "erode", "open" or "close", "radiusMm": 1 }, …],
///     "names": [{ "label": 2, "name": "ramus", "colour": "#e3dac9" }, …] }
///
/// Strict: every key must be there, and no other; what ValidateSegmentationRecipe refuses is
/// refused here, too. At most 16 MiB. Errors are std::runtime_error (file, syntax) or
/// std::invalid_argument (content) and say which key, never the file's name or text: names are the
/// user's words. Needs HASP_ENABLE_JSON. Any thread.
SegmentationRecipe ParseSegmentationRecipe(const std::string& json);
/// Equal recipes are equal texts, and Parse gives them back to the last bit.
std::string FormatSegmentationRecipe(const SegmentationRecipe& recipe);
SegmentationRecipe ReadSegmentationRecipe(const std::string& path);
/// As a whole or not at all.
void WriteSegmentationRecipe(const std::string& path, const SegmentationRecipe& recipe);

} // namespace hasp
