#pragma once
#include <nlohmann/json_fwd.hpp>

namespace hasp
{

class PlannerWindow;

/// From a new isovalue of a phantom of so many samples a side to its picture, and VTK's way in the
/// same view in turn; each picture is held against the one at rest (PlannerMeasure.h). Threads:
/// RENDER.
nlohmann::ordered_json MeasureIsovalue(PlannerWindow& window, int size, int pairs);

} // namespace hasp
