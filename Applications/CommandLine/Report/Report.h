#pragma once
#include "Grid/ResourceUse.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What `hasp report` says, as plain values: rows, curves, stability, unused. No VTK here. Any
/// thread, one at a time.
namespace hasp
{

/// What a row is asked to reach; at least one of both ends.
struct ReportBar
{
  std::optional<double> least, most; ///< a figure may be either
  std::string of{};                  ///< whose figure it is; empty: the row's value
  double figure = 0.0;               ///< if `of` is given; one that is not finite misses the bar
};

enum class Better
{
  NotSaid, ///< a count, or a figure that is to be just so
  Lower,
  Higher
};

/// One figure. "ratio" is ours / the rival's, "times as fast" the rival's time / ours.
struct ReportRow
{
  std::string id;                  ///< "cells.extract", or "cells.extract@dataset" on other data
  std::string method;              ///< what is measured; empty: the id up to its first dot
  std::optional<double> value;     ///< the ratio or figure; absent rows have none
  std::string unit;                ///< "ratio", "times as fast", "mm", "share", "s", ...
  Better better = Better::NotSaid; ///< which way the value is; where a bar says it, need not be set
  std::string rival;               ///< its name, version and settings; empty: no rival in this row
  std::optional<double> error;     ///< of ours, in errorUnit; a row with timeS has it too
  std::string errorUnit;
  std::optional<double> timeS; ///< wall time of ours, s; a row with error has it too
  std::optional<double> cpuS;  ///< CPU time of ours, all threads, s
  std::optional<double> q1;    ///< lower and upper quartile of value
  std::optional<double> q3;
  int n = 0;          ///< pairs or samples behind the value
  std::string data;   ///< data set: "cranium@226HU"
  std::string absent; ///< why this rival could not be measured; such a row has no value, no bars
  std::vector<ReportBar> bars{}; ///< all of them are to be reached
};

/// Error against time: a line of one method, a point per setting, {time, error}.
struct ReportCurve
{
  std::string id; ///< curves of one id share a chart
  std::string method;
  std::string xUnit; ///< of the time
  std::string yUnit; ///< of the error
  std::vector<std::pair<double, double>> points;
};

/// One stiff or extreme case. `figure` must stay within `limit` to pass; where the case tells what
/// is predicted, `figure` is what the prediction rests on, and it passes if that comes.
struct ReportCase
{
  std::string id;
  std::string testCase; ///< "k=100 N/mm T=1 ms m=0.05 kg"
  bool pass = false;
  double figure = 0.0;
  double limit = 0.0;
  std::string unit;
};

/// What ids that begin so stand for: "haptics.simd" explains "haptics.simd.static@256".
struct ReportTerm
{
  std::string id;
  std::string meaning;
};

struct ReportMachine
{
  std::string cpu;
  int cores = 0;
  std::string simd; ///< widest set found: "AVX3", "AVX2", ... (Highway's names)
  std::string gl;   ///< renderer of the OpenGL context, empty where nothing is drawn
};

struct Report
{
  std::string name;
  std::string version;
  std::string commit;
  ReportMachine machine;
  std::uint64_t seed = 1;
  bool quick = false;
  std::vector<ReportTerm> terms; ///< of rows and curves; more than there are may be told
  std::vector<ReportRow> rows;
  std::vector<ReportCurve> curves;
  std::vector<ReportCase> stability;
  ResourceList unused; ///< what the scenes of this report skipped: 0 bytes, 0 ms
};

/// The row's method, or the part of its id before the first dot.
std::string MethodOf(const ReportRow& row);

/// Which way the row's value is better: as its bar has it, else as the row says.
Better BetterOf(const ReportRow& row);
/// Does the term explain this id of a row or curve?
bool Explains(const ReportTerm& term, const std::string& id);

/// Is the row beyond the bar?
bool Missed(const ReportRow& row, const ReportBar& bar);
/// Any of its bars?
bool Missed(const ReportRow& row);

/// Everything that makes the report worthless, one sentence each; empty: it holds.
///  - a time without an error, or an error without a time
///  - a method with neither a rival nor an absent row; an absent row with a value
///  - an id emitted twice
///  - a figure that is not finite, a ratio without quartiles or with fewer than 9 pairs
///  - a ratio that does not say which way it is better; an id that no term explains
///  - a bar without an end, or of a row without a value
///  - an unused resource that holds bytes or took time
///  - a report that says nothing
std::vector<std::string> ReportFaults(const Report& report);

/// The faults of each report, and ids that two of them emit.
std::vector<std::string> ReportFaults(const std::vector<Report>& reports);

/// What this process runs on. Reads /proc/cpuinfo where it exists; `gl` stays empty.
ReportMachine ThisMachine();

} // namespace hasp
