#include "Failure.h"
#include "Files.h"
#include "FragmentImages.h"
#include "PlanInput.h"
#include "ReductionText.h"
#include "Session.h"
#include "SurfaceBodies.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include "Grid/ThreadLimit.h"
#include "Planning/PlanEditsFile.h"
#include "Planning/PlanLists.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

namespace hasp
{
namespace
{

struct ReduceOptions
{
  std::string plan, writeEdits;
  std::vector<std::string> volumes, surfaces, takes;
  PlanReductionSettings settings;
  bool snap = false;
  int threads = 0;
};

/// All that can take part.
std::vector<PlanId> FragmentsFor(const Plan& plan, const PlanReductionSettings& settings)
{
  std::vector<PlanId> all;
  const auto named = [&](PlanId id)
  {
    const auto in = [id](const std::vector<PlanId>& ids)
    { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
    return settings.fragments.empty() || id == settings.reference || in(settings.fragments) ||
           in(settings.obstacles);
  };
  for (const PlanFragment& f : plan.fragments)
    if (f.state == FragmentState::Kept && !IsDivided(plan, f.id) && (f.locked || named(f.id)))
      all.push_back(f.id);
  return all;
}

std::vector<PlanId> OfScans(const Plan& plan, std::vector<PlanId> fragments)
{
  std::erase_if(fragments, [&](PlanId id) { return !IsOfScan(plan, id); });
  return fragments;
}

/// "5:2": of fragment or group 5 its second proposal.
std::vector<std::size_t> TakenProposals(
  const ReduceOptions& options, const PlanReduction& reduction)
{
  std::vector<std::size_t> taken(reduction.units.size(), 0);
  for (const std::string& take : options.takes)
  {
    const std::size_t colon = take.find(':');
    const auto id = PlanId(std::stoul(take.substr(0, colon)));
    const std::size_t number = std::stoul(take.substr(colon + 1));
    const auto unit = std::find_if(reduction.units.begin(), reduction.units.end(),
      [&](const ReducedUnit& u)
      { return u.group == id || (u.group == 0 && u.fragments[0] == id); });
    if (unit == reduction.units.end() || unit->assembled.turn == 0)
      throw Failure(ExitCode::WrongUse,
        "--take: " + std::to_string(id) + " is no fragment, and no group, that was placed");
    if (number > unit->assembled.proposals.proposals.size())
      throw Failure(ExitCode::WrongUse,
        "--take: " + CalledUnit(*unit) + " has " +
          std::to_string(unit->assembled.proposals.proposals.size()) + " proposals");
    taken[std::size_t(unit - reduction.units.begin())] = number - 1;
  }
  return taken;
}

CLI::Validator TakeForm()
{
  return CLI::Validator(
    [](std::string& text)
    {
      const std::size_t colon = text.find(':');
      const auto digits = [](const std::string& s)
      { return !s.empty() && s.size() < 10 && s.find_first_not_of("0123456789") == s.npos; };
      const bool good = colon != text.npos && digits(text.substr(0, colon)) &&
                        digits(text.substr(colon + 1)) && std::stoi(text.substr(colon + 1)) > 0;
      return good ? std::string() : std::string("must be ID:NUMBER, such as 5:2");
    },
    "ID:NUMBER");
}

void Store(
  const ReduceOptions& options, PlanDocument& document, PoseFragments edit, Session& session)
{
  if (!options.writeEdits.empty())
    WriteFile(options.writeEdits, FormatEdits({ edit }));
  if (!options.snap)
    return;
  Try(ExitCode::BadInput, "", [&] { document.history.Do({ std::move(edit) }, "Snap fragments"); });
  StorePlan(options.plan, document);
  if (!session.json)
    std::cout << "the plan has these poses now; hasp plan --undo takes them back\n";
}

void Reduce(const ReduceOptions& options, Session& session)
{
  std::unique_ptr<PlanLock> lock;
  if (options.snap)
    lock = Try(ExitCode::WrongUse, "", [&] { return std::make_unique<PlanLock>(options.plan); });
  PlanDocument document = OpenPlan(options.plan);
  const Plan& plan = document.history.Current();
  const std::vector<PlanId> fragments = FragmentsFor(plan, options.settings),
                            scanned = OfScans(plan, fragments);
  PlanReductionSettings settings = options.settings;
  settings.surfaces = BodiesOfSurfaces(plan, fragments, options.surfaces, settings.bake, session);
  const RunImages images =
    ImagesOfFragments(document, options.plan, scanned, options.volumes, session);
  session.progress.Step("Fitting fragments");
  const PlanReduction made = Try(ExitCode::BadInput, "",
    [&]
    {
      return ReducePlan(plan, images.images, settings,
        [&session](double share)
        {
          session.progress.Share(share);
          return true;
        });
    });
  session.resources.push_back(
    { "bodies to be fitted", 0, made.bakedMs, "distances and points of each fragment" });
  session.resources.push_back({ "fits", 0, made.assembledMs, "several starts a fragment" });
  session.result["soft_value"] = // surfaces have none
    scanned.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(made.softValue);
  session.result["units"] = nlohmann::ordered_json::array();
  for (const ReducedUnit& unit : made.units)
  {
    session.result["units"].push_back(DescribeUnit(unit));
    if (!session.json)
      PrintUnit(unit);
  }
  PoseFragments edit = ReductionEdit(plan, made, TakenProposals(options, made));
  if (edit.poses.empty())
  {
    session.resultStands = true;
    throw Failure(ExitCode::FailedCheck, "no fragment has a face within reach of another's: move "
                                         "them nearer by hand first, or say how "
                                         "far they may be off (--start-mm, --capture-mm)");
  }
  session.result["stored"] = options.snap;
  Store(options, document, std::move(edit), session);
}

void Run(const ReduceOptions& options, Session& session)
{
  RequireInput(options.plan);
  if (options.snap && !IsPlanFolder(options.plan))
    throw Failure(ExitCode::WrongUse,
      "plan.json alone is only read: give the plan's folder with --snap, or use --write-edits");
  if (!options.writeEdits.empty())
    RequireWritable(options.writeEdits, { ".json" });
  WithThreadLimit(options.threads, [&] { Reduce(options, session); });
}

void AddFitOptions(CLI::App& verb, ReduceOptions& options)
{
  ProposalSettings& fits = options.settings.assembly.proposals;
  verb.add_option("--start-mm", fits.startMm, "How far the coarse poses may be off")
    ->check(Within(0.0, 100.0))
    ->capture_default_str();
  verb.add_option("--start-degrees", fits.startDegrees, "And how far they may be turned")
    ->check(Within(0.0, 180.0))
    ->capture_default_str();
  verb.add_option("--starts", fits.starts, "Poses around each coarse one that are tried")
    ->check(CLI::Range(1, 100000))
    ->capture_default_str();
  verb.add_option("--capture-mm", fits.fit.captureMm, "Faces attract from so far at first")
    ->check(Within(0.5, 20.0))
    ->capture_default_str();
  verb.add_option("--proposals", fits.most, "As many are listed for each, at most")
    ->check(CLI::Range(1, 20))
    ->capture_default_str();
  verb
    .add_option("--spacing-mm", options.settings.bake.spacingMm,
      "Of the grids of distances; surfaces have theirs in the plan")
    ->check(Within(0.1, 2.0))
    ->capture_default_str();
  verb.add_option("--seed", options.settings.seed, "Of the poses that are tried")
    ->capture_default_str();
}

} // namespace

void AddReduceVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<ReduceOptions>();
  CLI::App* verb =
    app.add_subcommand("reduce", "Put the fragments of a plan together by their broken faces");
  verb->add_option("PLAN", options->plan, "Its folder, NAME.hasp; plan.json alone is only read")
    ->required();
  verb->add_option(
    "--volume", options->volumes, "The scans, found by what they hold: files or folders");
  verb->add_option("--surface", options->surfaces,
    "The surfaces, found by what they hold, of fragments that are some: .ply, .stl, .obj");
  verb->add_flag("--snap", options->snap, "Store the likeliest fits in the plan, as one step");
  verb
    ->add_option("--take", options->takes,
      "Another proposal of a fragment or group, by its number: --take 5:2")
    ->check(TakeForm());
  verb->add_option("--write-edits", options->writeEdits,
    "A .json file for the poses, for hasp plan --apply, whether they are stored or not");
  verb
    ->add_option("--fragment", options->settings.fragments,
      "Ids of those that are moved; left out: all of the reference's scan, and all surfaces")
    ->check(CLI::Range(PlanId(1), MaxPlanId));
  verb
    ->add_option("--reference", options->settings.reference,
      "The id of a fragment that stays where it is, besides those that are locked")
    ->check(CLI::Range(PlanId(1), MaxPlanId));
  verb
    ->add_option("--obstacle", options->settings.obstacles,
      "Ids of fragments of other bones: touched, and not fitted to, as the cranium for a mandible")
    ->check(CLI::Range(PlanId(1), MaxPlanId));
  AddFitOptions(*verb, *options);
  verb
    ->add_option(
      "--threads", options->threads, "At most so many; the poses are the same; 0: one a core")
    ->check(CLI::Range(0, 1024));
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp reduce case.hasp --volume CT --reference 3 --snap\n"
    "         hasp reduce pot.hasp --surface a.ply --surface b.ply --reference 2 --snap\n"
    "Fragments begin where the plan has them: coarsely in place, within --start-mm and\n"
    "--start-degrees. Groups move as one, locked fragments not at all. Each fit says "
    "how well faces\n"
    "meet, how far the truth may be off (at 95 %) and which other fits there are:\n"
    "UNDECIDED where the next is more than half as likely, WIDE where that is over 2 mm.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 nothing could be placed.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
