#include "EvaluateSteps.h"
#include "EvaluateText.h"
#include "EvaluateTruth.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "VerbWork.h"

#include "Evaluation/TrialTable.h"
#include "Planning/PlanLists.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <set>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

struct NamedTrial
{
  std::string operatorName;
  int number = 0;
  EvaluatedSide side;
};

/// OPERATOR-TRIAL of a plan's name.
std::pair<std::string, int> OperatorAndTrial(const fs::path& path)
{
  const std::string stem = path.stem().string();
  const std::size_t dash = stem.rfind('-');
  int number = 0;
  const char* end = stem.data() + stem.size();
  if (dash == std::string::npos || dash == 0 ||
      std::from_chars(stem.data() + dash + 1, end, number).ptr != end || number < 1 ||
      dash + 1 == stem.size())
    throw Failure(ExitCode::BadInput,
      "a plan among the trials is not named OPERATOR-TRIAL.json or .hasp, the trial a number from "
      "1: --show-names with hasp plan tells which; move what is no trial elsewhere");
  return { stem.substr(0, dash), number };
}

std::vector<fs::path> SortedEntries(const fs::path& folder)
{
  std::vector<fs::path> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename().string().front() != '.')
      entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::vector<NamedTrial> TrialsIn(const fs::path& folder)
{
  std::vector<NamedTrial> trials;
  for (const fs::path& path : SortedEntries(folder))
    if (path.filename() != "truth.json" && IsPlanPath(path.string()))
    {
      const auto [who, number] = OperatorAndTrial(path);
      trials.push_back({ who, number, PlanSide(path.string()) });
    }
  return trials;
}

/// Reads cases, and says them by numbers unless names are shown.
class Trials
{
public:
  Trials(const EvaluateOptions& options, Session& session)
    : Options(options),
      Shared(session),
      Surfaces(options.volumes, options.surfaces, session)
  {
    std::vector<fs::path> folders;
    std::error_code error;
    for (const fs::path& path : SortedEntries(options.first))
      if (fs::is_directory(path, error) && !IsPlanPath(path.string()))
        folders.push_back(path);
    std::vector<std::pair<fs::path, std::vector<NamedTrial>>> cases;
    for (const fs::path& folder : folders)
      if (auto trials = TrialsIn(folder); !trials.empty())
        cases.emplace_back(folder, std::move(trials));
    if (cases.empty()) // one case alone
      if (auto trials = TrialsIn(options.first); !trials.empty())
        cases.emplace_back(options.first, std::move(trials));
    if (cases.empty())
      throw Failure(ExitCode::BadInput,
        "there is no trial in the folder: CASE/OPERATOR-TRIAL.json or .hasp are looked for");
    for (const auto& [folder, trials] : cases)
      for (const NamedTrial& trial : trials)
        this->Operators.insert(trial.operatorName);
    for (const auto& [folder, trials] : cases)
      this->Add(folder, trials);
  }

  TrialTable Table()
  {
    this->Shared.progress.Step("measuring trials");
    return MakeTrialTable(this->Cases, this->Given,
      [this](double share)
      {
        this->Shared.progress.Share(share);
        return true;
      });
  }

private:
  std::string CalledOperator(const std::string& who) const
  {
    if (this->Shared.showNames)
      return PrintableName(who);
    return "operator " +
           std::to_string(1 + std::distance(this->Operators.begin(), this->Operators.find(who)));
  }

  void Add(const fs::path& folder, const std::vector<NamedTrial>& trials)
  {
    TrialCase of;
    of.name = this->Shared.showNames ? PrintableName(folder.filename().string())
                                     : "case " + std::to_string(this->Cases.size() + 1);
    std::map<std::string, std::vector<const EvaluatedSide*>> sides; // that have a fragment
    for (const NamedTrial& trial : trials)
    {
      const std::string reference = ReferenceOf(trial.side, this->Options.reference);
      FragmentPoses poses;
      for (const auto& [key, fragment] : trial.side.fragments)
        if (key != reference)
        {
          poses[CalledFragment(key, fragment, this->Shared)] =
            PoseBeside(trial.side, key, reference);
          sides[key].push_back(&trial.side);
        }
      this->Given.push_back(
        { of.name, this->CalledOperator(trial.operatorName), trial.number, poses });
    }
    for (const auto& [key, having] : sides)
    {
      const EvaluatedFragment& fragment = having.front()->fragments.at(key);
      this->RequireOneBone(key, having);
      of.fragments[CalledFragment(key, fragment, this->Shared)] = this->Surfaces.Of(key, having);
    }
    this->AddTruth(folder, sides, of);
    this->Cases.push_back(std::move(of));
  }

  void RequireOneBone(const std::string& key, const std::vector<const EvaluatedSide*>& sides) const
  {
    const EvaluatedSide& first = *sides.front();
    for (const EvaluatedSide* side : sides)
      if (!IsOneBone(first, first.fragments.at(key).id, *side, side->fragments.at(key).id))
        throw Failure(ExitCode::BadInput,
          CalledFragment(key, first.fragments.at(key), this->Shared) +
            ": two trials of a case do not make it of the same bone: trials begin with one "
            "segmentation");
  }

  /// By the label that the fragment is of, else by its name.
  void AddTruth(const fs::path& folder,
    const std::map<std::string, std::vector<const EvaluatedSide*>>& sides, TrialCase& of) const
  {
    std::error_code error;
    if (!fs::exists(folder / "truth.json", error))
      return;
    of.truth.emplace();
    const std::vector<TrueFragment> truth = ReadTruth((folder / "truth.json").string());
    for (const auto& [key, having] : sides)
    {
      const EvaluatedFragment& fragment = having.front()->fragments.at(key);
      const auto& source =
        FindPlanObject<PlanFragment>(having.front()->document->history.Current(), fragment.id)
          ->source;
      const auto* label = std::get_if<LabelSource>(&source);
      for (const TrueFragment& known : truth)
        if (label ? known.label == label->label : known.name == key)
          (*of.truth)[CalledFragment(key, fragment, this->Shared)] = known.scanToPlanned;
    }
  }

  const EvaluateOptions& Options;
  Session& Shared;
  EvaluatedSurfaces Surfaces;
  std::set<std::string> Operators;
  std::vector<TrialCase> Cases;
  std::vector<Trial> Given;
};

} // namespace

void EvaluateTrials(const EvaluateOptions& options, Session& session)
{
  RequireInput(options.first);
  if (!options.csv.empty())
    RequireWritable(options.csv, { ".csv" });
  const TrialTable table =
    Try(ExitCode::BadInput, "", [&] { return Trials(options, session).Table(); });
  session.progress.Wipe();
  session.result.update(JsonOf(table));
  if (!session.json)
    std::cout << TextOf(table);
  if (!options.csv.empty())
    WriteFile(options.csv, CsvOf(table));
}

} // namespace hasp
