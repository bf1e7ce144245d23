#pragma once
#include "Planning/DerivedPart.h"
#include "Planning/PlanHistory.h"
#include "Planning/StrictJson.h"

/// Plans, edits and histories as JSON. Internal: PlanFile is the way in and out. Reading is strict
/// (StrictJson.h), but for what ValidatePlan and Apply ask, which is asked there.
namespace hasp
{

Json PlanToJson(const Plan& plan);
Plan PlanFromJson(const Json& json, const std::string& name);

Json EditToJson(const PlanEdit& edit);
PlanEdit EditFromJson(const Json& json, const std::string& name);

Json HistoryToJson(const PlanHistory& history);
PlanHistory HistoryFromJson(const Json& json);

Json PartToJson(const DerivedPart& part);
DerivedPart PartFromJson(const Json& json, const std::string& name);

/// An object of a plan as in the plan's file; an overload for each kind.
Json ObjectToJson(const PlanVolume& object);
Json ObjectToJson(const PlanSegmentation& object);
Json ObjectToJson(const PlanSurface& object);
Json ObjectToJson(const PlanFragment& object);
Json ObjectToJson(const PlanGroup& object);
Json ObjectToJson(const PlanCut& object);
Json ObjectToJson(const PlanGuide& object);
Json ObjectToJson(const PlanPlate& object);
Json ObjectToJson(const PlanImplant& object);
Json ObjectToJson(const PlanTransplant& object);
Json ObjectToJson(const PlanMitreGuide& object);
Json ObjectToJson(const PlanMeasure& object);
Json ObjectToJson(const PlanMirror& object);
void ReadObject(const Json& json, const std::string& name, PlanVolume& object);
void ReadObject(const Json& json, const std::string& name, PlanSegmentation& object);
void ReadObject(const Json& json, const std::string& name, PlanSurface& object);
void ReadObject(const Json& json, const std::string& name, PlanFragment& object);
void ReadObject(const Json& json, const std::string& name, PlanGroup& object);
void ReadObject(const Json& json, const std::string& name, PlanCut& object);
void ReadObject(const Json& json, const std::string& name, PlanGuide& object);
void ReadObject(const Json& json, const std::string& name, PlanPlate& object);
void ReadObject(const Json& json, const std::string& name, PlanImplant& object);
void ReadObject(const Json& json, const std::string& name, PlanTransplant& object);
void ReadObject(const Json& json, const std::string& name, PlanMitreGuide& object);
void ReadObject(const Json& json, const std::string& name, PlanMeasure& object);
void ReadObject(const Json& json, const std::string& name, PlanMirror& object);
Json PoseToJson(const PlanPose& pose);
PlanPose PoseFromJson(const Json& json, const std::string& name);

/// Enums as in the file.
constexpr std::pair<FragmentState, const char*> FragmentStates[] = {
  { FragmentState::Kept, "kept" }, { FragmentState::Resected, "resected" }
};

/// "name.key", or the key alone.
inline std::string Below(const std::string& name, const std::string& key)
{
  return name.empty() ? key : name + "." + key;
}

} // namespace hasp
