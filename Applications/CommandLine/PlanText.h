#pragma once
#include "Planning/PlanFile.h"

#include <string>
#include <vector>

/// What `hasp plan` says of a plan.
namespace hasp
{

struct Session;

/// A line on standard output, without --json.
void Say(Session& session, const std::string& line);

/// What a step does, in our words: its own label may be anybody's.
std::string TextOf(const Plan& before, const std::vector<PlanEdit>& edits);

/// Of the step that undo takes back, or that redo makes again; empty if there is none.
std::string NextStep(PlanHistory history, bool undo);

/// Hands the plan's objects, its parts with their verdicts, its label maps, and its steps to the
/// session. `folder` is where its blobs are.
void ShowPlan(const PlanDocument& document, const std::string& folder, Session& session);

} // namespace hasp
