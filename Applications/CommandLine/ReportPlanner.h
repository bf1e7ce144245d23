#pragma once

namespace hasp
{

struct ReportContext;

/// The planner's window, measured by itself (`hasp-planner --measure`) on a screen: first picture,
/// pictures after a new isovalue, frames of a drag with contact, frames at rest, memory of plans
/// that are opened again and again; then whole cases (ReportPlannerCases.h). On $DISPLAY, else on a
/// screen of Xvfb of its own; where neither is there, or no bin/hasp-planner, its rows say so.
void ReportPlanner(ReportContext& context);

} // namespace hasp
