#pragma once
#include "Planning/ImplantRecipe.h"

#include <string>

namespace CLI
{
class App;
}

namespace hasp
{

struct Session;

/// `hasp mirror --plan`: the ghost of a scan's bone as a plan keeps it.
struct MirrorStep
{
  std::string plan, writeEdits;
  bool store = false;
};

void AddMirrorStepOptions(CLI::App& verb, MirrorStep& step);

/// Throws Failure: WrongUse where what is asked for does not go together; BadInput where there is
/// no such plan. Cheap: before anything is read.
void RequireMirrorStep(const MirrorStep& step);
/// Throws Failure: BadInput unless the plan has the scan of that hash.
void RequireScanInPlan(const MirrorStep& step, const std::string& scanHash);

/// Adds a PlanMirror of the scan's bone at `plane`: as one step of the plan, which hasp plan --undo
/// takes back, or as a file of edits, or both. Its id goes into the session's result as "mirror".
/// Throws Failure.
void KeepMirror(const MirrorStep& step, const std::string& scanHash, double isovalue,
  const MirrorPlane& plane, Session& session);

} // namespace hasp
