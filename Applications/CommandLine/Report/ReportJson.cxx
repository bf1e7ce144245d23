#include "ReportJson.h"

#include "ReportText.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

double Finite(double figure, const std::string& id)
{
  if (!std::isfinite(figure))
    throw std::invalid_argument("report: a figure of '" + id + "' is not finite");
  return figure;
}

void Put(Json& json, const char* key, const std::optional<double>& figure, const std::string& id)
{
  if (figure)
    json[key] = Finite(*figure, id);
}

void Put(Json& json, const char* key, const std::string& text)
{
  if (!text.empty())
    json[key] = text;
}

/// Where not being finite is an outcome, and told beside it.
Json Outcome(double figure)
{
  return std::isfinite(figure) ? Json(figure) : Json(nullptr);
}

Json BarsJson(const ReportRow& row)
{
  Json bars = Json::array();
  for (const ReportBar& bar : row.bars)
  {
    Json json = Json::object();
    Put(json, "of", bar.of);
    if (!bar.of.empty())
      json["figure"] = Outcome(bar.figure);
    Put(json, "least", bar.least, row.id);
    Put(json, "most", bar.most, row.id);
    json["missed"] = Missed(row, bar);
    bars.push_back(std::move(json));
  }
  return bars;
}

Json RowJson(const ReportRow& row, bool quick)
{
  Json json{ { "id", row.id } };
  Put(json, "method", row.method);
  Put(json, "value", row.value, row.id);
  Put(json, "unit", row.unit);
  Put(json, "better", BetterText(row));
  Put(json, "rival", row.rival);
  Put(json, "error", row.error, row.id);
  Put(json, "error_unit", row.errorUnit);
  Put(json, "time_s", row.timeS, row.id);
  Put(json, "cpu_s", row.cpuS, row.id);
  Put(json, "q1", row.q1, row.id);
  Put(json, "q3", row.q3, row.id);
  if (row.n > 0)
    json["n"] = row.n;
  Put(json, "data", row.data);
  Put(json, "absent", row.absent);
  if (!row.bars.empty())
  {
    json["bars"] = BarsJson(row);
    json["bar_missed"] = Missed(row);
  }
  if (quick)
    json["quick"] = true;
  return json;
}

Json CurveJson(const ReportCurve& curve)
{
  Json points = Json::array();
  for (const auto& [time, error] : curve.points)
    points.push_back({ Finite(time, curve.id), Finite(error, curve.id) });
  return { { "id", curve.id }, { "method", curve.method }, { "x_unit", curve.xUnit },
    { "y_unit", curve.yUnit }, { "points", std::move(points) } };
}

Json StabilityJson(const ReportCase& row)
{
  Json json{ { "id", row.id }, { "case", row.testCase }, { "pass", row.pass } };
  json["figure"] = row.pass ? Json(Finite(row.figure, row.id)) : Outcome(row.figure);
  json["limit"] = Finite(row.limit, row.id);
  json["unit"] = row.unit;
  return json;
}

Json DocumentJson(const Report& report)
{
  Json json{ { "report", report.name }, { "version", report.version }, { "commit", report.commit },
    { "machine", { { "cpu", report.machine.cpu }, { "cores", report.machine.cores },
                   { "simd", report.machine.simd }, { "gl", report.machine.gl } } },
    { "seed", report.seed }, { "quick", report.quick } };
  for (const char* list : { "rows", "curves", "stability", "unused" })
    json[list] = Json::array();
  for (const ReportRow& row : report.rows)
    json["rows"].push_back(RowJson(row, report.quick));
  for (const ReportCurve& curve : report.curves)
    json["curves"].push_back(CurveJson(curve));
  for (const ReportCase& row : report.stability)
    json["stability"].push_back(StabilityJson(row));
  for (const ResourceUse& use : report.unused)
    json["unused"].push_back({ { "resource", use.resource }, { "bytes", use.bytes },
      { "ms", Finite(use.milliseconds, use.resource) } });
  return json;
}

std::string Text(const Json& json)
{
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

std::string ReportJson(const Report& report)
{
  return Text(DocumentJson(report));
}

std::string ReportJson(const std::vector<Report>& reports)
{
  if (reports.size() == 1)
    return ReportJson(reports.front());
  Json all = Json::array();
  for (const Report& report : reports)
    all.push_back(DocumentJson(report));
  return Text(all);
}

} // namespace hasp
