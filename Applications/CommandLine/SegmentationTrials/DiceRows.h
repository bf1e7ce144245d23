#pragma once
#include "TrialScan.h"

#include <optional>
#include <string>

namespace hasp
{

/// The worst of several cases, as rows. A row of Dice beside one of surface Dice.
class DiceRows
{
public:
  /// at   what ids end in: "", ".cbct"
  DiceRows(std::string at, std::string strokes) : At(std::move(at)), Strokes(std::move(strokes)) {}

  /// Of one case.
  void Add(ReportContext& context, const TrialScan& scan, const TrialResult& result);
  /// Of a case that cannot be had.
  void AddAbsent(ReportContext& context, const std::string& key, const std::string& why) const;
  /// Of all so far: bars are least Dice and least surface Dice, none if they are 0.
  void AddWorst(ReportContext& context, double diceBar, double surfaceBar, double aim) const;

private:
  struct Worst
  {
    double dice = 2.0;
    double seconds = 0.0;
    std::string of{};
  };
  void Put(ReportContext& context, const std::string& id, const Worst& figure,
    const std::string& unit, const std::string& data, double bar, int n) const;

  std::string At, Strokes;
  Worst Volume, Surface;
  int Cases = 0;
};

} // namespace hasp
