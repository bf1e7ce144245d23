#pragma once
#include <nlohmann/json_fwd.hpp>

namespace hasp
{

class PlannerWindow;

/// Drags a fragment of a broken mandible against the others, with contact, for so long: frames, the
/// least share of pixels along an axis, the haptic thread's ticks and CPU time a tick; then the
/// same with all pixels (PlannerMeasure.h). Threads: RENDER.
nlohmann::ordered_json MeasureDrag(PlannerWindow& window, double seconds);

} // namespace hasp
