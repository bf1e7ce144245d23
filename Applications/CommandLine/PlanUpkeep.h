#pragma once
#include "Planning/PlanFile.h"

#include <string>

namespace hasp
{

struct Session;

/// `hasp plan --check`: reads every byte. Throws FailedCheck with what is damaged.
void CheckPlan(const std::string& folder, Session& session);

/// `hasp plan --prune`: forgets what was made and cannot be used now, and deletes what nothing
/// names any more. Throws Failure: WrongUse.
void PrunePlan(PlanDocument& document, const std::string& folder, Session& session);

} // namespace hasp
