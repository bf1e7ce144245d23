#pragma once
#include "Planning/Plan.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace hasp
{

constexpr std::size_t MaxPlanObjects = 10'000; ///< of one kind

/// One kind of object that plans hold.
template <typename T>
struct PlanList
{
  const char* noun;              ///< in labels and errors: "cut"
  const char* key;               ///< in files: "cuts"
  std::vector<T> Plan::*objects; ///< plan.*objects
};

/// All kinds, in the order in which they may name each other. A new one is: its struct and list in
/// Plan.h, a line here, a line in PlanEdit, and its functions in PlanObjects.cxx and PlanJson.cxx
/// (the compiler asks for each).
inline constexpr std::tuple PlanLists{
  PlanList<PlanVolume>{ "volume", "volumes", &Plan::volumes },
  PlanList<PlanSegmentation>{ "segmentation", "segmentations", &Plan::segmentations },
  PlanList<PlanSurface>{ "surface", "surfaces", &Plan::surfaces },
  PlanList<PlanFragment>{ "fragment", "fragments", &Plan::fragments },
  PlanList<PlanGroup>{ "group", "groups", &Plan::groups },
  PlanList<PlanCut>{ "cut", "cuts", &Plan::cuts },
  PlanList<PlanGuide>{ "guide", "guides", &Plan::guides },
  PlanList<PlanPlate>{ "plate", "plates", &Plan::plates },
  PlanList<PlanImplant>{ "implant", "implants", &Plan::implants },
  PlanList<PlanTransplant>{ "transplant", "transplants", &Plan::transplants },
  PlanList<PlanMitreGuide>{ "mitre-guide", "mitreGuides", &Plan::mitreGuides },
  PlanList<PlanMeasure>{ "measure", "measures", &Plan::measures },
  PlanList<PlanMirror>{ "mirror", "mirrors", &Plan::mirrors },
};

template <typename T>
constexpr const PlanList<T>& PlanListOf()
{
  return std::get<PlanList<T>>(PlanLists);
}

/// Calls visit(PlanList<T>) for each kind.
template <typename Visit>
void ForEachPlanList(Visit visit)
{
  std::apply([&](const auto&... list) { (visit(list), ...); }, PlanLists);
}

/// Calls visit(object) for each object; the plan may be const.
template <typename PlanType, typename Visit>
void ForEachPlanObject(PlanType& plan, Visit visit)
{
  ForEachPlanList(
    [&](const auto& list)
    {
      for (auto& object : plan.*list.objects)
        visit(object);
    });
}

/// The object of kind T that `id` names, or nullptr. Good until the plan changes. O(log objects).
template <typename T>
const T* FindPlanObject(const Plan& plan, PlanId id)
{
  const std::vector<T>& objects = plan.*PlanListOf<T>().objects;
  const auto found = std::lower_bound(objects.begin(), objects.end(), id,
    [](const T& object, PlanId wanted) { return object.id < wanted; });
  return found == objects.end() || found->id != id ? nullptr : &*found;
}

/// What `id` names: "cut", …; nullptr if nothing.
const char* PlanNoun(const Plan& plan, PlanId id);
/// The same with its number: "cut 6", or "object 6". Names are the user's own and are not said.
std::string CalledObject(const Plan& plan, PlanId id);

} // namespace hasp
