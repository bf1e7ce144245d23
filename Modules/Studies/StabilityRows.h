#pragma once
#include "Studies/HapticBench.h"

#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// One case of the stability table: what should come of it, by closed form, and how to try it.
struct StabilityRow
{
  std::string id;   ///< fixed, of family.what.values: "grid.quasistatic.k10.T1.loose.d2"
  std::string text; ///< for people
  BenchVerdict predicted;
  /// The figure that the prediction rests on, and its limit: below it, stable.
  double figure = 0.0, limit = 1.0;
  std::string law;        ///< what figure is: "spectral radius", "F_sat / (h sum k)", ...
  bool byDefault = false; ///< a configuration that nobody chose: must be stable

  struct Outcome
  {
    BenchFigures figures;
    BenchVerdict verdict;
  };
  std::function<Outcome()> run; ///< WORKER; deterministic; at most some 50 ms of CPU
};

/// All rows, in fixed order. More than 300.
std::vector<StabilityRow> StabilityRows();

/// Does the outcome say what was predicted? Where both oscillate or go through, what else a tool in
/// full swing does is not asked, but a device's limits and finite numbers are kept even then.
bool AsPredicted(const BenchVerdict& predicted, const BenchVerdict& outcome);

} // namespace hasp
