#pragma once
#include "ReductionTrials.h"
#include "Report.h"

#include <functional>
#include <string>
#include <vector>

/// Rows of trials of fits. Any thread, one at a time.
namespace hasp
{

/// Of none 0.
double Quantile(std::vector<double> values, double share);
std::vector<double> Figures(const std::vector<FitTrial>& trials, double FitTrial::*figure);

/// A method's two rows, reduction.tre and reduction.rotation with `key` behind: mm and degrees,
/// medians with their quartiles. barred: 0.5 mm and 1 degree.
void AddMethod(ReportContext& context, const std::string& key, const std::vector<FitTrial>& trials,
  const std::string& rival, const std::string& data, bool barred);

/// The share of trials that count.
void AddShare(ReportContext& context, const std::string& id, const std::vector<FitTrial>& trials,
  const std::function<bool(const FitTrial&)>& counts, const std::optional<ReportBar>& bar,
  const std::string& data);

} // namespace hasp
