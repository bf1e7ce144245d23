#pragma once
#include "Pairing.h"
#include "Report.h"

namespace hasp
{

/// What a row says beside its figure.
struct MeasuredError
{
  double value = 0.0;
  std::string unit = "voxel";
};

/// A ratio of times, pair by pair, and beside it of CPU times; `faster` turns it over: how many
/// times as fast as the rival.
ReportRow TimedRatio(const std::string& id, const PairedTimes& times, const std::string& rival,
  const MeasuredError& error, const std::string& data, bool faster = false);

/// The same of CPU times, and beside it of wall times: for work of one thread, on machines whose
/// hypervisor takes milliseconds.
ReportRow CpuRatio(const std::string& id, const PairedTimes& times, const std::string& rival,
  const MeasuredError& error, const std::string& data, bool faster = false);

/// A figure that does not vary from run to run (bytes, counts, errors), beside the time of the
/// method that it belongs to. As a ratio it has its own value for quartiles.
ReportRow FixedFigure(const std::string& id, double value, const std::string& unit,
  const std::string& rival, const MeasuredError& error, const PairedTimes& times,
  const std::string& data);

/// An error as the figure itself, beside the time of one run of the method that makes it.
ReportRow ErrorFigure(const std::string& id, const MeasuredError& error, const std::string& truth,
  const Timing& time, const std::string& data);

ReportRow AbsentRow(const std::string& id, const std::string& rival, const std::string& reason);

/// How a figure grows with the number of samples along an axis: the slope of a line through the
/// logarithms. Needs two points of different n.
double GrowthExponent(const std::vector<std::pair<double, double>>& figureOfSize);

} // namespace hasp
