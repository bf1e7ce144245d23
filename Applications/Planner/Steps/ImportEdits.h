#pragma once
#include "Grid/LabelTable.h"
#include "Planning/PlanEdits.h"

#include <string>
#include <vector>

namespace hasp
{

/// Is it a plan: a folder with a plan.json? UTF-8 path.
bool HoldsPlan(const std::string& path);

/// The volume of that hash; 0: none.
PlanId VolumeOfHash(const Plan& plan, const std::string& hash);

/// The segmentation whose labels are that blob, without steps; 0: none.
PlanId SegmentationOfBlob(const Plan& plan, const std::string& blob);

/// A label map from elsewhere, whose labels become fragments.
struct LabelMapFragments
{
  PlanId volume = 0; ///< that it is of
  std::string blob;
  LabelTable labels; ///< a fragment each, in their order
  double isovalue = 226.0, spacingMm = 0.5;
};

/// Adds the segmentation and its fragments. firstId: PlanSession::NewId().
std::vector<PlanEdit> FragmentEdits(PlanId firstId, const LabelMapFragments& map);

/// Adds the surface of that hash, unless the plan has it, and a fragment that is it.
/// thicknessMm: 0 of a closed one.
std::vector<PlanEdit> SurfaceEdits(
  const Plan& plan, PlanId firstId, const std::string& hash, double thicknessMm);

} // namespace hasp
