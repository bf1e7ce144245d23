#include "Failure.h"
#include "Files.h"
#include "PartFormats.h"
#include "PlanInput.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

struct PlanOptions
{
  std::string plan, caseLabel, edits, blob, output;
  PlanId part = 0;
  bool begin = false, undo = false, redo = false, show = false, check = false, force = false;
};

void Say(Session& session, const std::string& line)
{
  if (!session.json)
    std::cout << line << "\n";
}

/// Names are the user's own words: they are shown to whoever asks for them, and to no one else.
Json DescribeObjects(const Plan& plan, bool names)
{
  Json objects = Json::array();
  ForEachPlanList(
    [&](const auto& list)
    {
      for (const auto& object : plan.*list.objects)
      {
        objects.push_back({ { "kind", list.noun }, { "id", object.id } });
        if (names)
          objects.back()["name"] = object.name;
      }
    });
  return objects;
}

Json DescribeParts(const PlanDocument& document)
{
  const Plan& plan = document.history.Current();
  Json parts = Json::array();
  for (const PlanId object : PartObjects(plan))
  {
    const std::string why = WhyNoPart(plan, document.parts, object);
    parts.push_back(
      { { "object", object }, { "kind", PlanNoun(plan, object) }, { "in_date", why.empty() } });
    if (!why.empty())
      parts.back()["why"] = why;
  }
  return parts;
}

/// What a step does, in our words: its own label may be anybody's.
std::string TextOf(const Plan& before, const std::vector<PlanEdit>& edits)
{
  return edits.empty()
           ? "Nothing"
           : Label(before, edits[0]) +
               (edits.size() > 1 ? " and " + std::to_string(edits.size() - 1) + " more" : "");
}

/// Of the step that undo takes back, or that redo makes again; empty if there is none.
std::string NextStep(PlanHistory history, bool undo)
{
  if (undo)
    history.Undo(); // to the plan that the step was for; then it is the next to redo
  return history.ToRedo() ? TextOf(history.Current(), history.ToRedo()->edits) : "";
}

void Show(const PlanDocument& document, Session& session)
{
  const Plan& plan = document.history.Current();
  Json& result = session.result;
  result["hash"] = PlanHash(plan);
  result["next_id"] = document.history.NewId();
  result["objects"] = DescribeObjects(plan, session.showNames);
  result["parts"] = DescribeParts(document);
  const std::string undo = document.history.ToUndo() ? NextStep(document.history, true) : "",
                    redo = NextStep(document.history, false);
  result["undo"] = undo.empty() ? Json(nullptr) : Json(undo);
  result["redo"] = redo.empty() ? Json(nullptr) : Json(redo);
  for (const Json& object : result["objects"])
    Say(session, object["kind"].get<std::string>() + " " + object["id"].dump() +
                   (session.showNames ? "  " + object["name"].get<std::string>() : ""));
  for (const Json& part : result["parts"])
    Say(session, part["in_date"].get<bool>()
                   ? CalledObject(plan, part["object"].get<PlanId>()) + " is in date"
                   : part["why"].get<std::string>());
  Say(session, "the next object is " + std::to_string(document.history.NewId()) +
                 (undo.empty() ? "" : "; to undo: " + undo) +
                 (redo.empty() ? "" : "; to redo: " + redo));
}

void Begin(const PlanOptions& options)
{
  std::error_code error;
  if (std::filesystem::exists(options.plan, error))
    throw Failure(ExitCode::WrongUse, "the plan is there already; leave --new out, or choose "
                                      "another name");
  Plan plan;
  plan.caseLabel = options.caseLabel;
  PlanDocument document = TryPlan(ExitCode::WrongUse,
    [&] {
      return PlanDocument{ PlanHistory(plan), {} };
    });
  StorePlan(options.plan, document);
}

/// All edits of the file as one step, or none.
void ApplyEdits(PlanDocument& document, const std::string& path, Session& session)
{
  const std::string text = ReadText(path);
  TryPlan(ExitCode::BadInput,
    [&]
    {
      std::vector<PlanEdit> edits = ParseEdits(text);
      if (edits.empty())
        throw Failure(ExitCode::BadInput, FileLabel(path) + ": it holds no edits");
      const std::string label = TextOf(document.history.Current(), edits);
      document.history.Do(std::move(edits), label);
      Say(session, label);
    });
}

void UndoOrRedo(PlanDocument& document, bool undo, Session& session)
{
  if (!(undo ? document.history.ToUndo() : document.history.ToRedo()))
    throw Failure(
      ExitCode::WrongUse, std::string("the plan has no step to ") + (undo ? "undo" : "redo"));
  Say(session, (undo ? "Undone: " : "Redone: ") + NextStep(document.history, undo));
  undo ? document.history.Undo() : document.history.Redo();
}

void Check(const std::string& folder, Session& session)
{
  const std::vector<std::string> faults = PlanFaults(folder);
  session.result["faults"] = faults;
  session.resultStands = true;
  if (!faults.empty())
    throw FailedCheck("the plan is damaged", faults);
  Say(session, "every byte of the plan is as it was written");
}

void Export(const PlanOptions& options, const PlanDocument& document, Session& session)
{
  if (options.output.empty())
    throw Failure(ExitCode::WrongUse, "--export needs --output: where the part is to go");
  RequireWritable(options.output, PartEndings());
  const Plan& plan = document.history.Current();
  if (!IsPartObject(plan, options.part))
    throw Failure(ExitCode::WrongUse,
      CalledObject(plan, options.part) + ": nothing is made of it; hasp plan --show lists what is");
  const DerivedPart* part = PartInDate(plan, document.parts, options.part);
  if (!part)
    throw Failure(
      ExitCode::BadInput, WhyNoPart(plan, document.parts, options.part) + "; hasp run makes it");
  const auto blob = [folder = PlanFolder(options.plan)](const std::string& hash)
  { return TryPlan(ExitCode::BadInput, [&] { return ReadBlob(folder, hash); }); };
  if (!part->report.empty() && !options.force)
  {
    const Json report = Json::parse(blob(part->report));
    if (report.at("verdict") == "red")
      throw FailedCheck(CalledObject(plan, options.part) + " does not hold; --force exports it",
        report.at("faults").get<std::vector<std::string>>());
  }
  WriteStlAs(blob(part->bytes), options.output, session);
  session.result["output"] = FileLabel(options.output);
}

void Run(const PlanOptions& options, Session& session)
{
  const bool blob = !options.blob.empty(), edits = !options.edits.empty(),
             exports = options.part != 0;
  if (options.begin + edits + options.undo + options.redo + options.check + exports + blob > 1)
    throw Failure(ExitCode::WrongUse,
      "one at a time: --new, --apply, --undo, --redo, --check, --export or --blob");
  if (!options.caseLabel.empty() && !options.begin)
    throw Failure(ExitCode::WrongUse, "--case goes with --new; later it is an edit: caseLabel");
  if (options.begin)
    return Begin(options);
  if (options.check)
    return Check(options.plan, session);
  PlanDocument document = OpenPlan(options.plan);
  if (exports)
    return Export(options, document, session);
  if ((blob || edits || options.undo || options.redo) && !IsPlanFolder(options.plan))
    throw Failure(ExitCode::WrongUse, "plan.json alone is only read; give the plan's folder");
  if (blob)
  {
    session.result["blob"] =
      TryPlan(ExitCode::WrongUse, [&] { return WriteBlob(options.plan, ReadText(options.blob)); });
    return Say(session, session.result["blob"]);
  }
  if (edits)
    ApplyEdits(document, options.edits, session);
  if (options.undo || options.redo)
    UndoOrRedo(document, options.undo, session);
  if (edits || options.undo || options.redo)
    StorePlan(options.plan, document);
  Show(document, session);
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
  verb->add_flag("--undo", options->undo, "Take the last step back");
  verb->add_flag("--redo", options->redo, "Make the step again that was taken back last");
  verb->add_flag("--show", options->show, "List objects and parts, as is done without an option");
  verb->add_flag("--check", options->check, "Read every byte and say what is damaged");
  verb->add_option("--export", options->part, "The id of an object whose part is to be written")
    ->check(CLI::Range(PlanId(1), MaxPlanId));
  verb->add_option("--output", options->output, "With --export: the .stl, .3mf, .ply or .obj file");
  verb->add_flag("--force", options->force, "With --export: even a part that does not hold");
  verb->add_option("--blob", options->blob,
    "A label map, .nrrd, to keep in the plan; prints its hash, for a segmentation's \"labels\"");
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp plan case.hasp --new --case K-17\n"
    "         hasp plan case.hasp --apply edits.json\n"
    "Formats.md#plans says what edits are. Names are shown with --show-names alone.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input or out of date, 3 damaged or does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
