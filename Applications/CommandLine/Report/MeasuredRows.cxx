#include "MeasuredRows.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{

namespace
{

Quartiles Turned(const Quartiles& ratio, bool over)
{
  return over ? Quartiles{ 1.0 / ratio.q3, 1.0 / ratio.median, 1.0 / ratio.q1 } : ratio;
}

/// `beside`: the other clock's ratio.
ReportRow RatioRow(const std::string& id, const PairedTimes& times, const Quartiles& ratio,
  double beside, const std::string& clock, bool faster)
{
  ReportRow row;
  row.id = id;
  row.value = ratio.median;
  row.q1 = ratio.q1;
  row.q3 = ratio.q3;
  row.unit = faster ? "times as fast" : "ratio";
  row.better = faster ? Better::Higher : Better::Lower;
  row.timeS = times.a.wallS;
  row.cpuS = times.a.cpuS;
  row.n = times.pairs;
  char text[60] = "";
  if (std::isfinite(beside))
    std::snprintf(text, sizeof text, "; by %s time %.3g", clock.c_str(), beside);
  row.data = text;
  return row;
}

} // namespace

ReportRow TimedRatio(const std::string& id, const PairedTimes& times, const std::string& rival,
  const MeasuredError& error, const std::string& data, bool faster)
{
  ReportRow row = RatioRow(
    id, times, Turned(times.ratio, faster), Turned(times.cpuRatio, faster).median, "CPU", faster);
  row.rival = rival;
  row.error = error.value;
  row.errorUnit = error.unit;
  row.data = data + row.data;
  return row;
}

ReportRow CpuRatio(const std::string& id, const PairedTimes& times, const std::string& rival,
  const MeasuredError& error, const std::string& data, bool faster)
{
  ReportRow row = RatioRow(
    id, times, Turned(times.cpuRatio, faster), Turned(times.ratio, faster).median, "wall", faster);
  row.rival = rival;
  row.error = error.value;
  row.errorUnit = error.unit;
  row.data = data + row.data;
  return row;
}

ReportRow FixedFigure(const std::string& id, double value, const std::string& unit,
  const std::string& rival, const MeasuredError& error, const PairedTimes& times,
  const std::string& data)
{
  ReportRow row = TimedRatio(id, times, rival, error, data);
  row.value = row.q1 = row.q3 = value;
  row.unit = unit;
  row.data = data;
  return row;
}

ReportRow ErrorFigure(const std::string& id, const MeasuredError& error, const std::string& truth,
  const Timing& time, const std::string& data)
{
  ReportRow row;
  row.id = id;
  row.value = row.error = error.value;
  row.unit = row.errorUnit = error.unit;
  row.better = Better::Lower;
  row.rival = truth;
  row.timeS = time.wallS;
  row.cpuS = time.cpuS;
  row.data = data;
  return row;
}

ReportRow AbsentRow(const std::string& id, const std::string& rival, const std::string& reason)
{
  ReportRow row;
  row.id = id;
  row.rival = rival;
  row.absent = reason;
  return row;
}

double GrowthExponent(const std::vector<std::pair<double, double>>& figureOfSize)
{
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  const double n = double(figureOfSize.size());
  for (const auto& [size, figure] : figureOfSize)
  {
    const double a = std::log(size), b = std::log(figure);
    x += a / n;
    y += b / n;
    xx += a * a / n;
    xy += a * b / n;
  }
  if (!(xx - x * x > 0.0))
    throw std::invalid_argument("growth: needs figures of at least 2 sizes");
  return (xy - x * y) / (xx - x * x);
}

} // namespace hasp
