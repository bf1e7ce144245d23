#pragma once
#include "Planning/StrictJson.h"
#include "Planning/Transplant.h"

namespace hasp
{

/// A transplant as JSON within another file, as a plan's:
///
///   { "format": "hasp-transplant-1", "joints": [{ "point": [x,y,z], "normal": [x,y,z] }, …],
///     "outward": [[x,y,z], …],
///     "donor": { "axis": [[x,y,z], …], "lateral": [x,y,z], "radiusMm": 9, "keepMm": 75 },
///     "fromLastTip": false, "startOffsetMm": 0, "kerfMm": 1, "betweenMm": 1.5,
///     "vessel": [[x,y,z], …], "paddle": { "outline": [[x,y,z], …], "perforator": [x,y,z] } }
///
/// Strict: every key but "paddle" must be there, and no other. What ValidateTransplant refuses both
/// refuse. Internal.
Json TransplantToJson(const Transplant& transplant);
Transplant TransplantFromJson(const Json& json);

} // namespace hasp
