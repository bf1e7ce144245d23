#include "Failure.h"
#include "Files.h"
#include "PartFormats.h"
#include "PartReport.h"
#include "PlanEntries.h"
#include "PlanFragments.h"
#include "PlanInput.h"
#include "PlanMoves.h"
#include "PlanText.h"
#include "PlanUpkeep.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include "Planning/PlanEditsFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

struct PlanOptions
{
  std::string plan, caseLabel, edits, blob, output, recipe;
  PlanId part = 0;
  PlanMove move;
  PlanFragmentsChoice fragments;
  SurfaceEntries surfaces;
  bool begin = false, undo = false, redo = false, show = false, check = false, force = false,
       prune = false;
};

void Begin(const PlanOptions& options)
{
  std::error_code error;
  if (std::filesystem::exists(options.plan, error))
    throw Failure(ExitCode::WrongUse, "the plan is there already; leave --new out, or choose "
                                      "another name");
  Plan plan;
  plan.caseLabel = options.caseLabel;
  PlanDocument document = Try(ExitCode::WrongUse, "",
    [&] {
      return PlanDocument{ PlanHistory(plan), {} };
    });
  StorePlan(options.plan, document);
}

/// All edits of the file as one step, or none. Returns what to say once it is stored.
std::string ApplyEdits(PlanDocument& document, const std::string& path)
{
  const std::string text = ReadText(path);
  return Try(ExitCode::BadInput, "",
    [&]
    {
      std::vector<PlanEdit> edits = ParseEdits(text);
      if (edits.empty())
        throw Failure(ExitCode::BadInput, FileLabel(path) + ": it holds no edits");
      std::string label = TextOf(document.history.Current(), edits);
      document.history.Do(std::move(edits), label);
      return label;
    });
}

/// Returns what to say once it is stored.
std::string UndoOrRedo(PlanDocument& document, bool undo)
{
  if (!(undo ? document.history.ToUndo() : document.history.ToRedo()))
    throw Failure(
      ExitCode::WrongUse, std::string("the plan has no step to ") + (undo ? "undo" : "redo"));
  std::string said = (undo ? "Undone: " : "Redone: ") + NextStep(document.history, undo);
  undo ? document.history.Undo() : document.history.Redo();
  return said;
}

void Export(const PlanOptions& options, const PlanDocument& document, Session& session)
{
  if (options.output.empty())
    throw Failure(ExitCode::WrongUse, "--export needs --output: where the part is to go");
  RequireWritable(options.output, PartEndings());
  if (!options.recipe.empty())
    RequireWritable(options.recipe, { ".json" });
  const Plan& plan = document.history.Current();
  const std::string called = CalledObject(plan, options.part);
  if (!IsPartObject(plan, options.part))
    throw Failure(
      ExitCode::WrongUse, called + ": nothing is made of it; hasp plan --show lists what is");
  const std::vector<PlanId> made = PartObjects(plan);
  if (std::find(made.begin(), made.end(), options.part) == made.end())
    throw Failure(ExitCode::WrongUse,
      called + ": it is cut, and its pieces are made; hasp plan --show lists them");
  const DerivedPart* part = PartInDate(plan, document.parts, options.part);
  if (!part)
    throw Failure(
      ExitCode::BadInput, WhyNoPart(plan, document.parts, options.part) + "; hasp run makes it");
  const std::string folder = PlanFolder(options.plan);
  const auto blob = [&](const std::string& hash)
  { return Try(ExitCode::BadInput, "", [&] { return ReadBlob(folder, hash); }); };
  const std::string text = part->report.empty() ? "" : blob(part->report);
  if (!text.empty() && !options.force)
    if (const PartReport report = Try(ExitCode::BadInput, "", [&] { return ReadPartReport(text); });
        report.verdict == "red")
      throw FailedCheck(called + " does not hold; --force exports it", report.faults);
  if (!options.recipe.empty())
  {
    const std::string recipe =
      text.empty() ? "" : Try(ExitCode::BadInput, "", [&] { return RecipeOfReport(text); });
    if (recipe.empty())
      throw Failure(ExitCode::WrongUse, called +
                                          ": it has no recipe that a scan alone could be held "
                                          "to; leave --recipe out");
    WriteFile(options.recipe, recipe);
  }
  WriteStlAs(blob(part->bytes), options.output, session);
  session.result["output"] = FileLabel(options.output);
}

void RequireOneTask(const PlanOptions& options)
{
  if (options.begin + options.undo + options.redo + options.check + options.prune +
        !options.edits.empty() + (options.part != 0) + !options.blob.empty() +
        (options.move.object != 0) + !options.fragments.labels.empty() +
        !options.surfaces.files.empty() >
      1)
    throw Failure(ExitCode::WrongUse,
      "one at a time: --new, --apply, --fragments, --move, --surface, --undo, --redo, --check, "
      "--prune, --export or --blob");
  if (!options.caseLabel.empty() && !options.begin)
    throw Failure(ExitCode::WrongUse, "--case goes with --new; later it is an edit: caseLabel");
  if (!options.recipe.empty() && options.part == 0)
    throw Failure(ExitCode::WrongUse, "--recipe goes with --export: where the recipe is to go");
}

/// Returns what to say once it is stored.
std::string MakeStep(PlanDocument& document, const PlanOptions& options, Session& session)
{
  if (options.move.object != 0)
    return MakeMove(document, options.move);
  if (!options.fragments.labels.empty())
    return MakeFragments(document, options.plan, options.fragments, session);
  if (!options.surfaces.files.empty())
    return EnterSurfaces(document, options.surfaces, session);
  return options.edits.empty() ? UndoOrRedo(document, options.undo)
                               : ApplyEdits(document, options.edits);
}

/// Whoever changes the plan meanwhile waits, and what he did before is not lost.
void Change(const PlanOptions& options, Session& session)
{
  RequireInput(options.plan);
  if (!IsPlanFolder(options.plan))
    throw Failure(ExitCode::WrongUse, "plan.json alone is only read; give the plan's folder");
  const PlanLock lock = Try(ExitCode::WrongUse, "", [&] { return PlanLock(options.plan); });
  PlanDocument document = OpenPlan(options.plan);
  if (!options.blob.empty())
  {
    session.result["blob"] =
      Try(ExitCode::WrongUse, "", [&] { return WriteBlob(options.plan, ReadText(options.blob)); });
    return Say(session, session.result["blob"]);
  }
  if (options.prune)
    return PrunePlan(document, options.plan, session);
  const std::string said = MakeStep(document, options, session);
  StorePlan(options.plan, document);
  Say(session, said);
  ShowPlan(document, options.plan, session);
}

void Run(const PlanOptions& options, Session& session)
{
  RequireOneTask(options);
  if (options.begin)
    return Begin(options);
  if (options.check)
    return CheckPlan(options.plan, session);
  if (!options.blob.empty() || !options.edits.empty() || options.undo || options.redo ||
      options.prune || options.move.object != 0 || !options.fragments.labels.empty() ||
      !options.surfaces.files.empty())
    return Change(options, session);
  const PlanDocument document = OpenPlan(options.plan);
  if (options.part != 0)
    return Export(options, document, session);
  ShowPlan(document, PlanFolder(options.plan), session);
}

} // namespace

void AddPlanVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<PlanOptions>();
  CLI::App* verb = app.add_subcommand("plan", "Make a plan, edit it and say what is in it");
  verb->add_option("PLAN", options->plan, "Its folder, NAME.hasp; to look at, plan.json, too")
    ->required();
  verb->add_flag("--new", options->begin, "Make the folder, with an empty plan");
  verb->add_option("--case", options->caseLabel, "With --new: a pseudonym, written on parts");
  verb->add_option("--apply", options->edits, "A .json file of edits, all made as one step");
  AddFragmentOptions(*verb, options->fragments);
  AddMoveOptions(*verb, options->move);
  AddSurfaceOptions(*verb, options->surfaces);
  verb->add_flag("--undo", options->undo, "Take the last step back");
  verb->add_flag("--redo", options->redo, "Make the step again that was taken back last");
  verb->add_flag(
    "--show", options->show, "List objects, parts and label maps, as is done without an option");
  verb->add_flag("--check", options->check, "Read every byte and say what is damaged");
  verb->add_flag("--prune", options->prune,
    "Forget parts that are out of date or damaged, and delete what nothing names");
  verb->add_option("--export", options->part, "The id of an object whose part is to be written")
    ->check(CLI::Range(PlanId(1), MaxPlanId));
  verb->add_option("--output", options->output, "With --export: the .stl, .3mf, .ply or .obj file");
  verb->add_option("--recipe", options->recipe,
    "With --export: a .json file for the part's recipe, to hold it to with hasp certify");
  verb->add_flag("--force", options->force, "With --export: even a part that does not hold");
  verb->add_option("--blob", options->blob,
    "A label map, .nrrd, to keep in the plan; prints its hash, for a segmentation's \"labels\"");
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp plan case.hasp --new --case K-17\n"
    "         hasp plan case.hasp --fragments case.seg.nrrd --volume scan.mha\n"
    "         hasp plan case.hasp --apply edits.json\n"
    "         hasp plan pot.hasp --surface sherd1.ply --surface sherd2.ply\n"
    "Formats.md#plans says what edits are. Names are shown with --show-names alone.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input or out of date, 3 damaged or does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
