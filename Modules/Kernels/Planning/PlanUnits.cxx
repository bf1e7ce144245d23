#include "Planning/PlanUnits.h"

#include "Planning/PlanLists.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// The group that a fragment moves with: the first that has it; 0: none.
PlanId GroupOf(const Plan& plan, PlanId fragment)
{
  for (const PlanGroup& group : plan.groups)
    if (std::find(group.fragments.begin(), group.fragments.end(), fragment) !=
        group.fragments.end())
      return group.id;
  return 0;
}

} // namespace

std::vector<PlanUnit> UnitsOf(const Plan& plan, std::span<const PlanId> fragments)
{
  std::vector<PlanUnit> units;
  for (const PlanId id : fragments)
  {
    const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, id);
    if (fragment == nullptr)
      continue;
    const PlanId group = GroupOf(plan, id);
    auto unit = std::find_if(units.begin(), units.end(),
      [&](const PlanUnit& it) { return group != 0 && it.group == group; });
    if (unit == units.end())
      unit = units.insert(units.end(), PlanUnit{ group, {} });
    unit->fragments.push_back(id);
    unit->stays = unit->stays || fragment->locked;
  }
  return units;
}

} // namespace hasp
