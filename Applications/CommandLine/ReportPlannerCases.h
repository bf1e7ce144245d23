#pragma once

namespace hasp
{

struct ReportContext;

/// Whole cases of the planner's samples, done by real clicks and keys: how many clicks, how long
/// its user waits, how far off what is planned ends up. They are what its tests do
/// (TestPlannerSamples, beside this program in a build folder); where that is not there, and in a
/// quick report, rows say so or are left out. Minutes.
void ReportPlannerCases(ReportContext& context);

} // namespace hasp
