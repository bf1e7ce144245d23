#include "Evaluation/TrialTable.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace hasp
{

FragmentPoses RelativeTo(const FragmentPoses& poses, const std::string& reference)
{
  const auto found = poses.find(reference);
  if (found == poses.end())
    throw std::invalid_argument("reference: it has no pose among " + std::to_string(poses.size()));
  const RigidPose back = CheckedPose(found->second, "reference").Inverse();
  FragmentPoses relative;
  for (const auto& [name, pose] : poses)
    if (name != reference)
      relative[name] = back * pose;
  return relative;
}

namespace
{

std::string Numbered(const char* list, std::size_t n)
{
  return std::string(list) + "[" + std::to_string(n) + "]: ";
}

void CheckCases(std::span<const TrialCase> cases)
{
  std::set<std::string> names;
  for (std::size_t n = 0; n < cases.size(); ++n)
  {
    const TrialCase& of = cases[n];
    if (!names.insert(of.name).second)
      throw std::invalid_argument(Numbered("cases", n) + "its name was given to one before");
    if (of.fragments.empty())
      throw std::invalid_argument(Numbered("cases", n) + "it has no fragments; one at least");
    for (const auto& [name, surface] : of.fragments)
      if (!surface)
        throw std::invalid_argument(Numbered("cases", n) + "a fragment has no surface");
    for (const auto& [name, pose] : of.truth.value_or(FragmentPoses{}))
      if (!of.fragments.contains(name))
        throw std::invalid_argument(
          Numbered("cases", n) + "its truth has a fragment that the case has not");
  }
}

void CheckTrials(std::span<const TrialCase> cases, std::span<const Trial> trials)
{
  std::set<std::tuple<std::string, std::string, int>> done;
  for (std::size_t n = 0; n < trials.size(); ++n)
  {
    const Trial& trial = trials[n];
    const auto of = std::find_if(
      cases.begin(), cases.end(), [&](const TrialCase& c) { return c.name == trial.caseName; });
    if (of == cases.end())
      throw std::invalid_argument(Numbered("trials", n) + "it is of none of the cases");
    if (!done.emplace(trial.caseName, trial.operatorName, trial.trial).second)
      throw std::invalid_argument(
        Numbered("trials", n) + "case, operator and number are those of one before");
    for (const auto& [name, pose] : trial.poses)
      if (!of->fragments.contains(name))
        throw std::invalid_argument(
          Numbered("trials", n) + "it poses a fragment that its case has not");
  }
}

/// One fragment, measured in two poses.
class Measured
{
public:
  explicit Measured(const MeasuredSurface& surface)
    : Surface(surface),
      Points(WeightedPoints(surface.Samples()))
  {
  }
  TrialFigures operator()(const RigidPose& first, const RigidPose& second) const
  {
    const SurfaceDifference apart =
      MeasureSurfaceDifference(this->Surface, first, this->Surface, second);
    const PoseDifference pose = ComparePoses(first, second, this->Points);
    return { apart.both.meanMm, apart.both.maxMm, pose.rotationDegrees, pose.translationMm,
      pose.tre.meanMm };
  }

private:
  const MeasuredSurface& Surface;
  std::vector<WeightedPoint> Points;
};

/// All pairs of a case, before anything of them is measured.
std::vector<TrialPair> PairsOf(const TrialCase& of, std::span<const Trial> trials)
{
  std::vector<TrialPair> pairs;
  for (const auto& [fragment, surface] : of.fragments)
    for (std::size_t n = 0; n < trials.size(); ++n)
    {
      if (trials[n].caseName != of.name || !trials[n].poses.contains(fragment))
        continue;
      for (std::size_t m = n + 1; m < trials.size(); ++m)
        if (trials[m].caseName == of.name && trials[m].poses.contains(fragment))
          pairs.push_back(
            { of.name, fragment, n, m, trials[n].operatorName == trials[m].operatorName });
      if (of.truth && of.truth->contains(fragment))
        pairs.push_back({ of.name, fragment, n });
    }
  return pairs;
}

TrialSummary Summary(const std::vector<const TrialPair*>& pairs)
{
  TrialSummary summary;
  summary.pairs = pairs.size();
  for (std::size_t m = 0; m < TrialMeasures && !pairs.empty(); ++m)
  {
    double sum = 0.0, square = 0.0;
    for (const TrialPair* pair : pairs)
    {
      sum += pair->figures[m];
      summary.most[m] = std::max(summary.most[m], pair->figures[m]);
    }
    const double mean = summary.mean[m] = sum / double(pairs.size());
    for (const TrialPair* pair : pairs)
      square += (pair->figures[m] - mean) * (pair->figures[m] - mean);
    if (pairs.size() > 1)
      summary.deviation[m] = std::sqrt(square / double(pairs.size() - 1));
  }
  return summary;
}

/// Of one case, or of all where none is named.
TrialRow RowOf(const std::vector<TrialPair>& pairs, const std::string* caseName)
{
  std::vector<const TrialPair*> intra, inter, accuracy;
  for (const TrialPair& pair : pairs)
    if (!caseName || pair.caseName == *caseName)
      (!pair.second ? accuracy : pair.oneOperator ? intra : inter).push_back(&pair);
  return { caseName ? *caseName : "", Summary(intra), Summary(inter), Summary(accuracy) };
}

void FindMissing(std::span<const TrialCase> cases, std::span<const Trial> trials, TrialTable& table)
{
  std::set<std::string> operators;
  std::set<int> numbers;
  for (const Trial& trial : trials)
  {
    operators.insert(trial.operatorName);
    numbers.insert(trial.trial);
  }
  for (const TrialCase& of : cases)
  {
    for (const std::string& who : operators)
      for (const int number : numbers)
      {
        const auto found = std::find_if(trials.begin(), trials.end(),
          [&](const Trial& t)
          { return t.caseName == of.name && t.operatorName == who && t.trial == number; });
        if (found == trials.end())
          table.missing.push_back({ of.name, who, number, "" });
        else
          for (const auto& [fragment, surface] : of.fragments)
            if (!found->poses.contains(fragment))
              table.missing.push_back({ of.name, who, number, fragment });
      }
    for (const auto& [fragment, surface] : of.fragments)
      if (of.truth && !of.truth->contains(fragment))
        table.missing.push_back({ of.name, "", 0, fragment });
  }
}

} // namespace

TrialTable MakeTrialTable(
  std::span<const TrialCase> cases, std::span<const Trial> trials, const ProgressFunction& progress)
{
  CheckCases(cases);
  CheckTrials(cases, trials);
  TrialTable table;
  std::vector<std::pair<std::size_t, std::size_t>> ends; ///< of each case's pairs
  for (const TrialCase& of : cases)
  {
    auto pairs = PairsOf(of, trials);
    ends.emplace_back(table.pairs.size(), table.pairs.size() + pairs.size());
    std::move(pairs.begin(), pairs.end(), std::back_inserter(table.pairs));
  }
  for (std::size_t c = 0; c < cases.size(); ++c)
  {
    std::map<std::string, Measured> measured;
    for (std::size_t n = ends[c].first; n < ends[c].second; ++n)
    {
      TrialPair& pair = table.pairs[n];
      const Measured& fragment =
        measured.try_emplace(pair.fragment, *cases[c].fragments.at(pair.fragment)).first->second;
      const FragmentPoses& against = pair.second ? trials[*pair.second].poses : *cases[c].truth;
      pair.figures =
        fragment(trials[pair.first].poses.at(pair.fragment), against.at(pair.fragment));
      ReportProgress(progress, double(n + 1) / double(table.pairs.size()));
    }
    table.rows.push_back(RowOf(table.pairs, &cases[c].name));
  }
  table.overall = RowOf(table.pairs, nullptr);
  FindMissing(cases, trials, table);
  return table;
}

} // namespace hasp
