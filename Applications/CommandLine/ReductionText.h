#pragma once
#include "PlanReduction.h"

#include <nlohmann/json.hpp>

#include <string>

/// What `hasp reduce` says of fits.
namespace hasp
{

/// "fragment 5", "group 7".
std::string CalledUnit(const ReducedUnit& unit);

/// One unit with its proposals; mm and degrees, shares in [0, 1].
nlohmann::ordered_json DescribeUnit(const ReducedUnit& unit);

/// The same on standard output, some lines.
void PrintUnit(const ReducedUnit& unit);

} // namespace hasp
