#pragma once
#include "RunParts.h"

#include <string>
#include <vector>

/// Parts that a plan keeps from runs before.
namespace hasp
{

/// Where they are, and which of them a run takes.
struct KeptParts
{
  const PlanDocument& document;
  std::string folder;     ///< with the blobs
  bool none = false;      ///< all are to be made
  bool certified = false; ///< those that are certified are to be made, for their pages
  bool said = false;      ///< those with warnings are taken, too: they have been said
};

/// The part of an object as it is kept, if it is in date; else one that is to be made, without
/// bytes. One that was made with warnings is made anew, so that they are said again, unless they
/// have been.
PartFile TakePart(const KeptParts& kept, PlanId object, Session& session);

/// Puts what was made into the plan as it is by now, and keeps what was changed in it meanwhile.
/// Throws Failure.
void KeepInPlan(const std::string& folder, const std::vector<PartFile>& parts);

/// The same of a segmentation's label map: the bytes of a .nrrd file, and its report
/// (LabelReport.h).
void KeepInPlan(const std::string& folder, PlanId segmentation,
  const std::vector<PartInput>& inputs, const std::string& nrrd, const std::string& report);

} // namespace hasp
