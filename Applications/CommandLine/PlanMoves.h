#pragma once
#include "Planning/PlanFile.h"

#include <array>
#include <string>

namespace CLI
{
class App;
}

namespace hasp
{

/// `hasp plan --move`: a fragment, or a group as one.
struct PlanMove
{
  PlanId object = 0;                            ///< 0: none is asked for
  std::array<double, 3> shift{ 0.0, 0.0, 0.0 }; ///< mm, after the turn
  std::array<double, 3> turn{ 0.0, 0.0, 0.0 };  ///< axis times degrees
  std::array<double, 3> about{ 0.0, 0.0, 0.0 }; ///< the place that the turn leaves where it is, mm
};

void AddMoveOptions(CLI::App& verb, PlanMove& move);

/// Makes it a step of the plan. Returns what to say once it is stored. Throws Failure: BadInput
/// where the plan refuses it.
std::string MakeMove(PlanDocument& document, const PlanMove& move);

} // namespace hasp
