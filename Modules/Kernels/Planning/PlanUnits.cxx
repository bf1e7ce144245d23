#include "Planning/PlanUnits.h"

#include "Planning/PlanLists.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace hasp
{
namespace
{

/// For each group the first group that it shares a fragment with, by way of others, too; else
/// itself.
std::vector<std::size_t> TiedGroups(const Plan& plan)
{
  std::vector<std::size_t> tied(plan.groups.size());
  std::iota(tied.begin(), tied.end(), std::size_t(0));
  std::map<PlanId, std::size_t> first; // group of a fragment
  for (std::size_t n = 0; n < plan.groups.size(); ++n)
    for (const PlanId id : plan.groups[n].fragments)
    {
      const std::size_t own = tied[n], other = tied[first.try_emplace(id, n).first->second];
      std::replace(tied.begin(), tied.end(), std::max(own, other), std::min(own, other));
    }
  return tied;
}

/// The group that a fragment moves with; 0: none.
PlanId GroupOf(const Plan& plan, const std::vector<std::size_t>& tied, PlanId fragment)
{
  for (std::size_t n = 0; n < plan.groups.size(); ++n)
    if (const std::vector<PlanId>& ids = plan.groups[n].fragments;
        std::find(ids.begin(), ids.end(), fragment) != ids.end())
      return plan.groups[tied[n]].id;
  return 0;
}

} // namespace

std::vector<PlanUnit> UnitsOf(const Plan& plan, std::span<const PlanId> fragments)
{
  const std::vector<std::size_t> tied = TiedGroups(plan);
  std::vector<PlanUnit> units;
  for (const PlanId id : fragments)
  {
    const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, id);
    if (fragment == nullptr)
      continue;
    const PlanId group = GroupOf(plan, tied, id);
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
