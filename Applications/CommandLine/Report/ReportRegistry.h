#pragma once
#include "Report.h"

#include <functional>

namespace hasp
{

/// The switches of `hasp report`.
struct ReportSettings
{
  bool quick = false;     ///< minutes at most; rows are marked
  bool soak = false;      ///< hours: what neither quick nor ordinary reports can measure
  int soakFrames = 0;     ///< of a walk, in a soak; else 0
  std::uint64_t seed = 1; ///< of every random case
  std::string volume;     ///< path of a real CT to measure on too
};

/// What a report function is given.
struct ReportContext
{
  Report&
    report; ///< to be filled; name, version, commit, machine, seed and quick are there already
  ReportSettings settings;
  /// Share done in [0,1] and what is being measured.
  std::function<void(double share, const std::string& step)> progress;
};

/// A report: its name on the command line, a line for --help, and the function that measures.
/// The function throws std::exception if it cannot measure at all; a rival that is missing is a row
/// with `absent` set instead.
struct ReportEntry
{
  const char* name;
  const char* summary;
  void (*run)(ReportContext&);
};

/// All reports of this build, in the order of --help. A new report is one line in Reports.cxx.
const std::vector<ReportEntry>& ReportRegistry();

} // namespace hasp
