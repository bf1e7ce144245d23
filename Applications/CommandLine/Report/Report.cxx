#include "Report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <thread>

namespace hasp
{
namespace
{

/// Collects sentences.
struct Faults
{
  std::vector<std::string> list;
  void Check(bool holds, const std::string& subject, const char* fault)
  {
    if (!holds)
      this->list.push_back(subject + ": " + fault);
  }
};

bool Finite(const std::optional<double>& figure)
{
  return !figure || std::isfinite(*figure);
}

void CheckRow(const ReportRow& row, Faults& faults)
{
  faults.Check(!row.id.empty(), "a row", "has no id");
  faults.Check(
    !row.timeS || row.error, row.id, "has a time without an error; measure the error too");
  faults.Check(
    !row.error || row.timeS, row.id, "has an error without a time; measure the time too");
  faults.Check(Finite(row.value) && Finite(row.error) && Finite(row.timeS) && Finite(row.cpuS) &&
                 Finite(row.q1) && Finite(row.q3),
    row.id, "a figure is not finite");
  faults.Check(row.absent.empty() == row.value.has_value(), row.id,
    "must have either a value or the reason why it is absent");
  faults.Check(
    row.absent.empty() || !row.rival.empty(), row.id, "does not say which rival is absent");
  faults.Check(!row.error || !row.errorUnit.empty(), row.id, "has an error without a unit");
  for (const ReportBar& bar : row.bars)
    faults.Check(row.value && (bar.least || bar.most) && Finite(bar.least) && Finite(bar.most),
      row.id, "has a bar that says nothing");
  const bool ratio = row.value && (row.unit == "ratio" || row.unit == "times as fast");
  faults.Check(!ratio || BetterOf(row) != Better::NotSaid, row.id,
    "is a ratio that does not say which way it is better");
  if (ratio && row.timeS)
  {
    faults.Check(row.q1 && row.q3, row.id, "is a timed ratio without quartiles");
    faults.Check(row.n >= 9, row.id, "is a timed ratio of fewer than 9 pairs");
  }
}

void CheckRivals(const Report& report, Faults& faults)
{
  std::map<std::string, bool> answered; // method -> a rival, or the reason of its absence
  for (const ReportRow& row : report.rows)
    answered[MethodOf(row)] |= !row.rival.empty();
  for (const ReportCurve& curve : report.curves)
    faults.Check(!curve.method.empty(), curve.id, "has a curve without a method");
  for (const auto& [method, yes] : answered)
    faults.Check(yes, method, "has neither a rival nor a row that says why it is absent");
}

void CheckOnce(const Report& report, Faults& faults)
{
  std::set<std::string> seen;
  const auto once = [&](const std::string& id)
  { faults.Check(seen.insert(id).second, id, "is emitted twice"); };
  for (const ReportRow& row : report.rows)
    once(row.id);
  for (const ReportCurve& curve : report.curves)
    once(curve.id + ", curve of " + curve.method);
  for (const ReportCase& row : report.stability)
    once(row.id + ", case " + row.testCase);
}

void CheckIds(const Report& report, Faults& faults)
{
  std::set<std::string> ids;
  for (const ReportRow& row : report.rows)
    ids.insert(row.id);
  for (const ReportCurve& curve : report.curves)
    ids.insert(curve.id);
  for (const std::string& id : ids)
    faults.Check(std::any_of(report.terms.begin(), report.terms.end(),
                   [&](const ReportTerm& term) { return Explains(term, id); }),
      id, "is explained nowhere: ReportTerms.cxx");
}

void CheckCurve(const ReportCurve& curve, Faults& faults)
{
  faults.Check(!curve.points.empty(), curve.id, "has a curve without points");
  faults.Check(!curve.xUnit.empty() && !curve.yUnit.empty(), curve.id, "has a curve without units");
  for (const auto& [time, error] : curve.points)
    faults.Check(std::isfinite(time) && std::isfinite(error), curve.id, "a point is not finite");
}

std::string CpuName()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != line.npos)
      return line.substr(colon + 2);
  return "unknown";
}

std::string WidestSimd()
{
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
    return "AVX3";
  if (__builtin_cpu_supports("avx2"))
    return "AVX2";
  return __builtin_cpu_supports("sse4.2") ? "SSE4" : "SSE2";
#elif defined(__aarch64__)
  return "NEON";
#else
  return "SCALAR";
#endif
}

} // namespace

std::string MethodOf(const ReportRow& row)
{
  return row.method.empty() ? row.id.substr(0, row.id.find('.')) : row.method;
}

Better BetterOf(const ReportRow& row)
{
  for (const ReportBar& bar : row.bars)
    if (bar.of.empty())
      return bar.least && bar.most ? Better::NotSaid : bar.least ? Better::Higher : Better::Lower;
  return row.better;
}

bool Explains(const ReportTerm& term, const std::string& id)
{
  const std::size_t end = term.id.size();
  return id.starts_with(term.id) && (id.size() == end || id[end] == '.' || id[end] == '@');
}

bool Missed(const ReportRow& row, const ReportBar& bar)
{
  const double figure = bar.of.empty() ? row.value.value_or(std::nan("")) : bar.figure;
  return !std::isfinite(figure) || (bar.least && figure < *bar.least) ||
         (bar.most && figure > *bar.most);
}

bool Missed(const ReportRow& row)
{
  return std::any_of(
    row.bars.begin(), row.bars.end(), [&](const ReportBar& bar) { return Missed(row, bar); });
}

std::vector<std::string> ReportFaults(const Report& report)
{
  Faults faults;
  faults.Check(!report.rows.empty() || !report.curves.empty() || !report.stability.empty(),
    report.name, "says nothing: no row, no curve, no stability case");
  for (const ReportRow& row : report.rows)
    CheckRow(row, faults);
  for (const ReportCurve& curve : report.curves)
    CheckCurve(curve, faults);
  for (const ReportCase& row : report.stability)
    faults.Check(std::isfinite(row.limit) && (std::isfinite(row.figure) || !row.pass),
      row.id + ", case " + row.testCase, "passes with a figure that is not finite");
  for (const ResourceUse& use : report.unused)
    faults.Check(use.bytes == 0 && use.milliseconds == 0.0, use.resource,
      "is listed as unused but holds bytes or took time");
  CheckRivals(report, faults);
  CheckIds(report, faults);
  CheckOnce(report, faults);
  return faults.list;
}

std::vector<std::string> ReportFaults(const std::vector<Report>& reports)
{
  std::vector<std::string> all;
  std::map<std::string, std::size_t> owner;
  for (std::size_t r = 0; r < reports.size(); ++r)
  {
    for (const std::string& fault : ReportFaults(reports[r]))
      all.push_back(fault);
    for (const ReportRow& row : reports[r].rows)
      if (owner.emplace(row.id, r).first->second != r)
        all.push_back(row.id + ": is emitted by two reports");
  }
  return all;
}

ReportMachine ThisMachine()
{
  return { CpuName(), static_cast<int>(std::thread::hardware_concurrency()), WidestSimd(), "" };
}

} // namespace hasp
