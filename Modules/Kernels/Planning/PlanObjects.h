#pragma once
#include "Planning/PlanLists.h"
#include "Planning/ValueChecks.h"

#include <cstddef>
#include <string>
#include <vector>

/// What must hold of each kind of object. Internal: what PlanEdits and ValidatePlan share.
namespace hasp
{

/// An id that an object names another by.
struct PlanReference
{
  PlanId id;
  bool (*fits)(const Plan&, PlanId); ///< whether what it names may be named here
  const char* must;                  ///< "the id of a cut of the plan"
  const char* key;                   ///< where it stands: "cuts", …
  std::size_t entry = NoEntry;       ///< … "cuts[2]"
  const char* member = "";           ///< … "points[2].fragment"

  static constexpr std::size_t NoEntry = ~std::size_t(0);
  std::string Key() const; ///< made when an error asks for it: each edit asks for references
};

/// Everything that an object names, in its order.
std::vector<PlanReference> References(const PlanVolume& object);
std::vector<PlanReference> References(const PlanSegmentation& object);
std::vector<PlanReference> References(const PlanSurface& object);
std::vector<PlanReference> References(const PlanFragment& object);
std::vector<PlanReference> References(const PlanGroup& object);
std::vector<PlanReference> References(const PlanCut& object);
std::vector<PlanReference> References(const PlanGuide& object);
std::vector<PlanReference> References(const PlanPlate& object);
std::vector<PlanReference> References(const PlanImplant& object);
std::vector<PlanReference> References(const PlanTransplant& object);
std::vector<PlanReference> References(const PlanMitreGuide& object);
std::vector<PlanReference> References(const PlanMeasure& object);
std::vector<PlanReference> References(const PlanMirror& object);

/// Throws std::invalid_argument unless the object's own values are legal, all but id and
/// references.
void CheckObject(const PlanVolume& object, const std::string& subject);
void CheckObject(const PlanSegmentation& object, const std::string& subject);
void CheckObject(const PlanSurface& object, const std::string& subject);
void CheckObject(const PlanFragment& object, const std::string& subject);
void CheckObject(const PlanGroup& object, const std::string& subject);
void CheckObject(const PlanCut& object, const std::string& subject);
void CheckObject(const PlanGuide& object, const std::string& subject);
void CheckObject(const PlanPlate& object, const std::string& subject);
void CheckObject(const PlanImplant& object, const std::string& subject);
void CheckObject(const PlanTransplant& object, const std::string& subject);
void CheckObject(const PlanMitreGuide& object, const std::string& subject);
void CheckObject(const PlanMeasure& object, const std::string& subject);
void CheckObject(const PlanMirror& object, const std::string& subject);

void CheckPlanPose(const PlanPose& pose, const ValueChecks& check);
void CheckCaseLabel(const std::string& label);

/// CheckObject, and that all it names is there.
template <typename T>
void CheckInPlan(const Plan& plan, const T& object, const std::string& subject)
{
  CheckObject(object, subject);
  for (const PlanReference& reference : References(object))
    if (!reference.fits(plan, reference.id))
      ValueChecks(subject).Refuse(reference.Key(), reference.id, reference.must);
}

} // namespace hasp
