#pragma once
#include "Tools/Planner.h"

#include "Grid/LabelTable.h"

#include <functional>
#include <vector>

/// Labels of a plan's segmentations become fragments of it. RENDER; the work is a job's.
namespace hasp
{

/// Makes the label map of a segmentation with steps, keeps it with the plan as `hasp run` does, and
/// adds a fragment for each label that has none yet, in one step. Label 1 of a split is bone that
/// belongs to nobody, and becomes none. What its steps found is said.
void MakeFragmentsOf(Planner& planner, PlanId segmentation);

/// The edits: of labels that occur, as the recipe names them. firstId: PlanSession::NewId().
std::vector<PlanEdit> FragmentsOfLabels(const Plan& plan, PlanId firstId, PlanId segmentation,
  const LabelTable& present, double spacingMm);

/// A segmentation whose labels are the scan's pieces of bone of at least so much, and its
/// fragments: the segmentation is one step, the fragments another.
void MakePieces(Planner& planner, double leastMm3);

/// Adds all bone that is connected with a place of the scan that is shown as a fragment. False: no
/// scan is shown, or the plan has refused it.
bool AddBoneAt(Planner& planner, const glm::dvec3& placeInScan);

} // namespace hasp
