#pragma once
#include <memory>

namespace hasp
{

class PlannerWindow;
class StudyLog;
struct PlannerOptions;

/// Study mode, where the command line asks for it (null: not): steps, actions and the plan go into
/// the trial's folder; when the window closes the SUS form is asked for.
std::unique_ptr<StudyLog> BeginStudy(PlannerWindow& window, const PlannerOptions& options);

} // namespace hasp
