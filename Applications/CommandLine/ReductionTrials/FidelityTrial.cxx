#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/ParallelFor.h"
#include "Studies/FracturedBlocks.h"
#include "Studies/SignedRank.h"
#include "Studies/SimulatedOperator.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdio>
#include <map>

namespace hasp
{
namespace
{

// Ten times the step's default. A light push presses a face in by F / (k A), whatever is felt of
// it: 0.05 mm at the default, as large as what is to be seen; the default's own row is printed.
constexpr float Stiffness = 0.5F;

/// What the renderer does: how many levels of points there are, and what else.
struct Condition
{
  std::string key, words;
  OperatorHelp help;
};

std::vector<Condition> Conditions(bool quick)
{
  OperatorHelp all;
  all.step.contact.stiffness = Stiffness;
  OperatorHelp snap = all, soft;
  snap.snap = true;
  const auto few = [](OperatorHelp help, int levels)
  {
    help.levels = levels;
    return help;
  };
  std::vector<Condition> conditions{
    { "all", "all levels of 16384 points", all },
    { "64", "64 points of the whole surface", few(all, 1) },
    { "256", "256 points of the whole surface", few(all, 2) },
  };
  if (quick)
    return conditions;
  conditions.push_back({ "snap.all", "all levels, with Snap-to-fit", snap });
  conditions.push_back({ "snap.64", "64 points, with Snap-to-fit", few(snap, 1) });
  conditions.push_back({ "soft.all", "all levels, contact of the default stiffness", soft });
  conditions.push_back({ "soft.64", "64 points, the default stiffness", few(soft, 1) });
  return conditions;
}

struct Put
{
  double mm = 0.0, seconds = 0.0;
  bool content = false;
  std::uint64_t faults = 0; ///< ticks beyond the limits or not finite
};

/// Of one condition, in the order of pairs.
using Trials = std::map<std::string, std::vector<Put>>;

std::vector<OperatorTask> MakeTasks(ReportContext& context, int count)
{
  std::vector<OperatorTask> tasks;
  for (int n = 0; n < count; ++n)
  {
    context.progress(0.3 * n / count, "reduction: breaking blocks");
    FracturedBlockSettings settings;
    settings.pieces = 2 + n % 2;
    settings.lostMm = n / 2 % 2 == 0 ? 0.0 : 0.2;
    // The operator was made with seeds below 100.
    settings.seed = 100 + 100 * context.settings.seed + std::uint64_t(n);
    tasks.push_back(TaskOf(MakeFracturedBlocks(settings)));
  }
  return tasks;
}

Trials TryConditions(
  ReportContext& context, const std::vector<Condition>& conditions, int operators, int scenes)
{
  const std::vector<OperatorTask> tasks = MakeTasks(context, scenes);
  const std::int64_t pairs = std::int64_t(operators) * scenes;
  Trials trials;
  for (std::size_t c = 0; c < conditions.size(); ++c)
  {
    context.progress(
      0.3 + 0.7 * double(c) / double(conditions.size()), "reduction: simulated operators");
    std::vector<Put>& made = trials[conditions[c].key];
    made.resize(std::size_t(pairs));
    ParallelFor(0, pairs, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          const OperatorTask& task = tasks[std::size_t(n / operators)];
          const std::uint64_t first = 1000 * (1 + context.settings.seed);
          const std::uint64_t seed = first + std::uint64_t(n);
          const OperatorResult put = PutInPlace(task, StartBefore(task, seed),
            MakeOperator(first + std::uint64_t(n % operators)), conditions[c].help, seed);
          made[std::size_t(n)] = { RmsWay(task.moved, task.truth, put.pose), put.seconds,
            put.content, put.overLimit + put.notFinite };
        }
      });
  }
  return trials;
}

double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size() - 1))];
}

ReportRow RowOf(const std::string& id, const std::vector<double>& figures, const char* unit)
{
  ReportRow row;
  row.id = "reduction.fidelity" + id;
  row.value = Quantile(figures, 0.5);
  row.unit = unit;
  row.better = Better::Lower;
  row.q1 = Quantile(figures, 0.25);
  row.q3 = Quantile(figures, 0.75);
  row.n = int(figures.size());
  return row;
}

double MeanOf(const std::vector<Put>& trials, double Put::*figure)
{
  double sum = 0.0;
  for (const Put& put : trials)
    sum += put.*figure;
  return sum / double(trials.size());
}

std::string Means(const std::vector<Put>& high, const std::vector<Put>& low, double Put::*figure)
{
  char text[80];
  std::snprintf(text, sizeof text, "means %.3f / %.3f", MeanOf(high, figure), MeanOf(low, figure));
  return text;
}

/// Median of pairs' ratios, high / low, of an error or a time; p of the paired differences.
struct Compared
{
  ReportRow row;
  double p;
};
Compared Compare(const std::string& id, const std::vector<Put>& high, const std::vector<Put>& low,
  double Put::*figure, const std::string& rival)
{
  std::vector<double> ratios, differences;
  for (std::size_t n = 0; n < high.size(); ++n)
  {
    ratios.push_back(high[n].*figure / (low[n].*figure));
    differences.push_back(high[n].*figure - low[n].*figure);
  }
  Compared compared{ RowOf(id, ratios, "ratio"), TestSignedRanks(differences).p };
  char text[40];
  std::snprintf(text, sizeof text, "; p %.2g", compared.p);
  compared.row.rival = rival;
  compared.row.data = "median of pairs; " + Means(high, low, figure) + text;
  return compared;
}

void AddConditions(
  ReportContext& context, const std::vector<Condition>& conditions, const Trials& trials)
{
  for (const Condition& condition : conditions)
  {
    std::vector<double> errors, times;
    int content = 0;
    std::uint64_t faults = 0;
    for (const Put& put : trials.at(condition.key))
    {
      errors.push_back(put.mm);
      times.push_back(put.seconds);
      content += put.content;
      faults += put.faults;
    }
    ReportRow error = RowOf(".error." + condition.key, errors, "mm");
    error.data = condition.words + "; " + std::to_string(content) + " stopped by themselves, " +
                 std::to_string(faults) + " ticks beyond limits";
    context.report.rows.push_back(error);
    ReportRow time = RowOf(".seconds." + condition.key, times, "s");
    time.data = condition.words + "; virtual time";
    context.report.rows.push_back(time);
  }
}
} // namespace

void TryFidelity(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const std::vector<Condition> conditions = Conditions(quick);
  const Trials trials = TryConditions(context, conditions, quick ? 3 : 6, quick ? 3 : 6);
  auto& rows = context.report.rows;
  const std::vector<Put>&all = trials.at("all"), &few = trials.at("64");
  const std::string rival = "the same operators, starts and noise with 64 points";
  Compared error = Compare("", all, few, &Put::mm, rival);
  Compared time = Compare(".time", all, few, &Put::seconds, rival);
  ReportRow p = RowOf(".p", { error.p }, "p of signed ranks, both sides");
  p.q1 = p.q3 = std::nullopt;
  p.n = int(all.size());
  p.rival = rival;
  if (!quick)
  {
    error.row.bars = { { {}, 1.0 } };
    p.bars = { { {}, 0.01 } };
    time.row.bars = { { {}, 1.05 } };
  }
  rows.push_back(error.row);
  rows.push_back(p);
  rows.push_back(time.row);
  rows.push_back(
    Compare(".points256", all, trials.at("256"), &Put::mm, "the same with 256 points").row);
  if (!quick)
  {
    const std::vector<Put>&snap = trials.at("snap.all"), &soft = trials.at("soft.all");
    rows.push_back(
      Compare(".snap", snap, trials.at("snap.64"), &Put::mm, rival + ", Snap-to-fit both").row);
    rows.push_back(Compare(".snap_worth", snap, all, &Put::mm, "the same without Snap-to-fit").row);
    rows.push_back(Compare(
      ".soft", soft, trials.at("soft.64"), &Put::mm, rival + ", contact of the default stiffness")
                     .row);
  }
  AddConditions(context, conditions, trials);
}

} // namespace hasp
