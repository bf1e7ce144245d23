#pragma once
#include "Planning/Plan.h"

namespace hasp
{

struct Planner;

/// Parts of the plan, made on the WORKER by planner.jobs, a job each, with progress and cancel.
///
/// Made of the plan and the scans as they are now; label maps that are not in date are made of
/// their recipes' steps and kept. A part that holds, or of which nothing is claimed, is kept in the
/// plan with its report: the same bytes as `hasp run` would keep. If the plan was changed meanwhile
/// it is kept all the same, and is out of date. One that does not hold is not kept: RedParts has
/// its report. Warnings and faults are said, with what to do; a part that cannot be made is told by
/// JobQueue::Failed, a cancelled one by GaveUp, and the plan is then as it was. Threads: RENDER.
void MakePart(Planner& planner, PlanId object);
/// All that are not in date; what they share is made once.
void MakeAll(Planner& planner);

} // namespace hasp
