#include "EvaluateSteps.h"
#include "Failure.h"
#include "Session.h"
#include "Verbs.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace hasp
{
namespace
{

void Run(const EvaluateOptions& options, Session& session)
{
  std::error_code error;
  const bool plan = IsPlanPath(options.first);
  if (!options.scan.empty())
  {
    if (!plan || !options.second.empty() || !options.csv.empty())
      throw Failure(ExitCode::WrongUse, "--scan goes with one plan, and without --csv");
    return EvaluateScan(options, session);
  }
  if (options.isovalue || options.series != 0)
    throw Failure(ExitCode::WrongUse, "--isovalue and --series go with --scan");
  if (!options.second.empty())
    return EvaluatePair(options, session);
  if (plan)
    return EvaluateFractures(options, session);
  if (!std::filesystem::is_directory(options.first, error))
    throw Failure(
      ExitCode::WrongUse, "one alone is a folder of trials, or a plan; give a second surface");
  EvaluateTrials(options, session);
}

} // namespace

void AddEvaluateVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* verb = app.add_subcommand(
    "evaluate", "Say how well fractures fit, how far two reductions are apart, or one from a scan");
  verb
    ->add_option("A", options->first,
      "A plan (NAME.hasp, plan.json), a surface, a folder of surfaces; alone: a plan, whose "
      "fractures "
      "are measured, or a folder of trials")
    ->required();
  verb->add_option("B", options->second, "What it is held to: likewise");
  verb->add_option("--reference", options->reference,
    "The fragment that stands still, as the cranium: its name or id; default: the locked one");
  verb->add_option(
    "--scan", options->scan, "Another scan of the patient, intact or after surgery, to hold A to");
  verb
    ->add_option("--isovalue", options->isovalue,
      "Bone of --scan is this and more; default: as the reference's")
    ->check(Within(-1e6, 1e6));
  verb->add_option("--series", options->series, "Of --scan: which, if there are several, from 1")
    ->check(CLI::Range(1, 100000));
  verb->add_option("--volume", options->volumes,
    "The plan's own scans, found by what they hold: only if hasp run has not made the fragments");
  verb->add_option("--surface", options->surfaces,
    "The plan's own surfaces, likewise: of fragments that are some");
  verb
    ->add_option("--reach", options->reachMm,
      "Faces farther apart than this are no fracture, mm, nor are deeper overlaps")
    ->check(Within(0.5, 50.0))
    ->capture_default_str();
  verb->add_option("--csv", options->csv, "Write the table to this .csv file, too");
  AddCommonOptions(*verb, session);
  verb->footer(
    "Distances of surfaces are means over area, of both directions; TRE is how far the same "
    "places\n"
    "of a fragment are apart. A folder of trials holds CASE/OPERATOR-TRIAL.json (or .hasp), and\n"
    "CASE/truth.json where the truth is known; it gives precision and accuracy apart.\n"
    "Along fractures step-off (of size alone) and gap are said between fragments that face each "
    "other\nwithin --reach, as bones at a joint do, too.\n"
    "Example: hasp evaluate case.hasp\n"
    "         hasp evaluate first.hasp second.hasp --reference cranium\n"
    "         hasp evaluate case.hasp --scan after.mha --reference cranium\n"
    "         hasp evaluate trials --reference cranium --csv table.csv\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 the other scan does not fit the reference.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
