#include "MirrorStep.h"

#include "Files.h"
#include "PlanInput.h"
#include "PlanText.h"
#include "Session.h"
#include "VerbWork.h"

#include "Planning/PlanEditsFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace hasp
{
namespace
{

PlanId ScanOf(const Plan& plan, const std::string& hash)
{
  const auto found = std::find_if(plan.volumes.begin(), plan.volumes.end(),
    [&](const PlanVolume& volume) { return volume.hash == hash; });
  if (found == plan.volumes.end())
    throw Failure(ExitCode::BadInput,
      "IN is none of the plan's scans: no volume of it has its hash; give the scan that the plan "
      "was made on");
  return found->id;
}

} // namespace

void AddMirrorStepOptions(CLI::App& verb, MirrorStep& step)
{
  CLI::Option* plan = verb.add_option(
    "--plan", step.plan, "A plan of IN, NAME.hasp, that the ghost is for; plan.json is only read");
  verb.add_flag("--store", step.store, "Store the ghost in --plan, as one step")->needs(plan);
  verb
    .add_option("--write-edits", step.writeEdits,
      "With --plan: a .json file for the ghost, for hasp plan --apply, whether it is stored or not")
    ->needs(plan);
}

void RequireMirrorStep(const MirrorStep& step)
{
  if (step.plan.empty())
    return;
  RequireInput(step.plan);
  if (!step.store && step.writeEdits.empty())
    throw Failure(
      ExitCode::WrongUse, "--plan goes with --store or --write-edits: what is to become of it");
  if (step.store && !IsPlanFolder(step.plan))
    throw Failure(ExitCode::WrongUse,
      "plan.json alone is only read: give the plan's folder with --store, or use --write-edits");
  if (!step.writeEdits.empty())
    RequireWritable(step.writeEdits, { ".json" });
}

void RequireScanInPlan(const MirrorStep& step, const std::string& scanHash)
{
  if (!step.plan.empty())
    ScanOf(OpenPlan(step.plan).history.Current(), scanHash);
}

void KeepMirror(const MirrorStep& step, const std::string& scanHash, double isovalue,
  const MirrorPlane& plane, Session& session)
{
  if (step.plan.empty())
    return;
  std::unique_ptr<PlanLock> lock;
  if (step.store)
    lock = Try(ExitCode::WrongUse, "", [&] { return std::make_unique<PlanLock>(step.plan); });
  PlanDocument document = OpenPlan(step.plan);
  PlanMirror mirror;
  mirror.id = document.history.NewId();
  mirror.volume = ScanOf(document.history.Current(), scanHash);
  mirror.isovalue = isovalue;
  mirror.plane = plane;
  const std::vector<PlanEdit> edits{ AddObject<PlanMirror>{ mirror } };
  session.result["mirror"] = mirror.id;
  session.result["stored"] = step.store;
  if (!step.writeEdits.empty())
    WriteFile(step.writeEdits, FormatEdits(edits));
  if (!step.store)
    return;
  Try(ExitCode::BadInput, "",
    [&]
    {
      const std::string label = TextOf(document.history.Current(), edits);
      document.history.Do(edits, label);
    });
  StorePlan(step.plan, document);
  Say(session,
    "plan      has it as mirror " + std::to_string(mirror.id) + "; hasp plan --undo takes it back");
}

} // namespace hasp
