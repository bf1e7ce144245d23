#include "EvaluateText.h"

#include "VerbWork.h"

#include <array>
#include <utility>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr std::array Measures{ "s2s_mean_mm", "s2s_max_mm", "rotation_deg", "translation_mm",
  "tre_mm" };

Json JsonOf(const TrialSummary& s)
{
  Json json{ { "pairs", s.pairs } };
  for (std::size_t m = 0; m < TrialMeasures && s.pairs > 0; ++m)
    json[Measures[m]] = { { "mean", s.mean[m] }, { "sd", s.deviation[m] }, { "max", s.most[m] } };
  return json;
}

Json JsonOf(const TrialRow& row)
{
  return { { "intra_operator", JsonOf(row.intraOperator) },
    { "inter_operator", JsonOf(row.interOperator) }, { "accuracy", JsonOf(row.accuracy) } };
}

std::string LinesOf(const std::string& called, const TrialRow& row)
{
  std::string text;
  const auto line = [&](const char* what, const TrialSummary& s)
  {
    text += Line("%-12.40s %-15s %5zu", called.c_str(), what, s.pairs);
    for (std::size_t m = 0; m < TrialMeasures && s.pairs > 0; ++m)
      text += Line("  %8.3f +- %5.3f", s.mean[m], s.deviation[m]);
    text += s.pairs > 0 ? "\n" : "  none\n";
  };
  line("intra-operator", row.intraOperator);
  line("inter-operator", row.interOperator);
  line("accuracy", row.accuracy);
  return text;
}

std::string Called(const MissingTrial& missing)
{
  std::string text = missing.caseName + ": ";
  if (missing.operatorName.empty())
    return text + "the truth of " + missing.fragment + " is not known";
  text += missing.operatorName + " trial " + std::to_string(missing.trial);
  return missing.fragment.empty() ? text + " is not there" : text + " has no " + missing.fragment;
}

} // namespace

Json JsonOf(const TrialTable& table)
{
  Json json{ { "cases", Json::array() }, { "overall", JsonOf(table.overall) },
    { "missing", Json::array() }, { "pairs", table.pairs.size() } };
  for (const TrialRow& row : table.rows)
  {
    Json one{ { "case", row.caseName } };
    one.update(JsonOf(row));
    json["cases"].push_back(one);
  }
  for (const MissingTrial& missing : table.missing)
    json["missing"].push_back(Called(missing));
  return json;
}

std::string TextOf(const TrialTable& table)
{
  std::string text = Line("%-28s %5s  %17s  %17s  %17s  %17s  %17s\n", "mean +- deviation of pairs",
    "pairs", "s2s mean, mm", "s2s max, mm", "rotation, deg", "translation, mm", "TRE, mm");
  for (const TrialRow& row : table.rows)
    text += LinesOf(row.caseName, row);
  text += LinesOf("all", table.overall);
  for (const MissingTrial& missing : table.missing)
    text += "missing: " + Called(missing) + "\n";
  return text;
}

std::string CsvOf(const TrialTable& table)
{
  std::string text = "case,kind,pairs";
  for (const char* measure : Measures)
    text += std::string(",") + measure + "," + measure + "_sd," + measure + "_max";
  text += "\n";
  const auto lines = [&](std::size_t number, const TrialRow& row)
  {
    for (const auto& [kind, s] :
      { std::pair<const char*, const TrialSummary&>{ "intra", row.intraOperator },
        { "inter", row.interOperator }, { "accuracy", row.accuracy } })
    {
      text += (number > 0 ? std::to_string(number) : "all") + Line(",%s,%zu", kind, s.pairs);
      for (std::size_t m = 0; m < TrialMeasures; ++m)
        text += s.pairs > 0 ? Line(",%.6g,%.6g,%.6g", s.mean[m], s.deviation[m], s.most[m]) : ",,,";
      text += "\n";
    }
  };
  for (std::size_t n = 0; n < table.rows.size(); ++n)
    lines(n + 1, table.rows[n]);
  lines(0, table.overall);
  return text;
}

} // namespace hasp
