#include "Studies/SeededDice.h"
#include "Studies/SimulatedOperator.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void Require(double value, double least, double most, const char* name)
{
  if (!(value >= least && value <= most))
    throw std::invalid_argument("operator: " + std::string(name) + " is " + std::to_string(value) +
                                ", must be in [" + std::to_string(least) + ", " +
                                std::to_string(most) + "]");
}

} // namespace

void CheckOperator(const OperatorSettings& s)
{
  Require(s.speedMmPerS, 1.0, 500.0, "speedMmPerS");
  Require(s.turnDegreesPerS, 1.0, 1000.0, "turnDegreesPerS");
  Require(s.approachMmPerS, 0.5, 100.0, "approachMmPerS");
  Require(s.aimMm, 0.0, 100.0, "aimMm");
  Require(s.aimDegrees, 0.0, 180.0, "aimDegrees");
  Require(s.pushN, 0.1, 10.0, "pushN");
  Require(s.comfortN, std::nextafter(s.pushN, 20.0), 20.0, "comfortN");
  Require(s.yieldS, 0.05, 60.0, "yieldS");
  Require(s.searchMm, 0.01, 20.0, "searchMm");
  Require(s.searchDegrees, 0.0, 30.0, "searchDegrees");
  Require(s.dwellS, 0.15, 5.0, "dwellS");
  Require(s.deeperMm, 0.0, 5.0, "deeperMm");
  Require(s.seesMm, 0.0, 5.0, "seesMm");
  Require(s.patience, 1, 1000, "patience");
  Require(s.stillMmPerS, 0.1, 100.0, "stillMmPerS");
  Require(s.gapMm, 0.05, 20.0, "gapMm");
  Require(s.givesUpS, 1.0, 600.0, "givesUpS");
}

OperatorSettings MakeOperator(std::uint64_t seed)
{
  SeededDice dice(seed);
  OperatorSettings s;
  s.speedMmPerS = dice.In(20.0, 50.0);
  s.turnDegreesPerS = dice.In(25.0, 60.0);
  s.approachMmPerS = dice.In(5.0, 12.0);
  s.aimMm = dice.In(1.0, 3.0);
  s.aimDegrees = dice.In(1.5, 4.5);
  s.pushN = dice.In(1.0, 2.0);
  s.yieldS = dice.In(0.3, 0.8);
  s.searchMm = dice.In(0.5, 1.2);
  s.searchDegrees = dice.In(1.0, 2.0);
  s.dwellS = dice.In(0.3, 0.45);
  s.patience = int(dice.In(8.0, 16.0));
  s.hand.tremorMm = dice.In(0.05, 0.15);
  s.hand.tremorDegrees = dice.In(0.05, 0.15);
  s.hand.driftMm = dice.In(0.15, 0.45);
  s.hand.driftDegrees = dice.In(0.15, 0.45);
  s.hand.springNPerMm = dice.In(0.3, 0.6);
  return s;
}

} // namespace hasp
