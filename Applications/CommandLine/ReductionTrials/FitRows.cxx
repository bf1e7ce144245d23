#include "FitRows.h"

#include "ReportRegistry.h"

#include <algorithm>
#include <cmath>

namespace hasp
{

double Quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size() - 1))];
}

std::vector<double> Figures(const std::vector<FitTrial>& trials, double FitTrial::*figure)
{
  std::vector<double> all;
  for (const FitTrial& trial : trials)
    all.push_back(trial.*figure);
  return all;
}

void AddMethod(ReportContext& context, const std::string& key, const std::vector<FitTrial>& trials,
  const std::string& rival, const std::string& data, bool barred)
{
  const auto add = [&](
                     const std::string& id, double FitTrial::*figure, const char* unit, double bar)
  {
    const std::vector<double> all = Figures(trials, figure);
    ReportRow row;
    row.id = id + key;
    row.value = Quantile(all, 0.5);
    row.unit = unit;
    row.better = Better::Lower;
    row.rival = rival;
    row.error = Quantile(all, 0.95);
    row.errorUnit = std::string(unit) + ", 95th percentile";
    row.timeS = 1e-3 * Quantile(Figures(trials, &FitTrial::milliseconds), 0.5);
    row.q1 = Quantile(all, 0.25);
    row.q3 = Quantile(all, 0.75);
    row.n = int(trials.size());
    row.data = data;
    if (barred)
      row.bars = { { {}, bar } };
    context.report.rows.push_back(row);
  };
  add("reduction.tre", &FitTrial::mm, "mm", 0.5);
  add("reduction.rotation", &FitTrial::degrees, "degrees", 1.0);
}

void AddShare(ReportContext& context, const std::string& id, const std::vector<FitTrial>& trials,
  const std::function<bool(const FitTrial&)>& counts, const std::optional<ReportBar>& bar,
  const std::string& data)
{
  ReportRow row;
  row.id = id;
  row.value = double(std::count_if(trials.begin(), trials.end(), counts)) / double(trials.size());
  row.unit = "share";
  row.rival = "the poses that the bone was broken by";
  // Of a share of n trials.
  row.error = std::sqrt(*row.value * (1.0 - *row.value) / double(trials.size()));
  row.errorUnit = "share, standard deviation";
  row.timeS = 1e-3 * Quantile(Figures(trials, &FitTrial::milliseconds), 0.5);
  row.n = int(trials.size());
  row.data = data;
  if (bar)
    row.bars = { *bar };
  context.report.rows.push_back(row);
}

} // namespace hasp
