#pragma once
#include "Planning/Plan.h"

#include <string>
#include <variant>
#include <vector>

/// Every change of a plan as a value: the planner, the command line and Python make the same ones,
/// and PlanHistory keeps them. Edits hold what is to be afterwards, and of a segmentation what is
/// added to it, never a difference: no arithmetic stands between them and the plan, so that a
/// history leads to the same bits on every machine.
namespace hasp
{

/// A new object. Its id is new, too: at least the plan's nextId (PlanHistory::NewId).
template <typename T>
struct AddObject
{
  T object;
  bool operator==(const AddObject&) const noexcept = default;
};

/// The object of that id and kind as it is to be. A fragment of a scan stays of a scan, one of a
/// surface of a surface: what names it may rest on that.
template <typename T>
struct ChangeObject
{
  T object;
  bool operator==(const ChangeObject&) const noexcept = default;
};

/// Refused while other objects name it. The id is not used again.
struct RemoveObject
{
  PlanId id = 0;
  bool operator==(const RemoveObject&) const noexcept = default;
};

struct RenameObject
{
  PlanId id = 0;
  std::string name;
  bool operator==(const RenameObject&) const noexcept = default;
};

struct FragmentPose
{
  PlanId fragment = 0;
  PlanPose scanToPlanned;
  bool operator==(const FragmentPose&) const noexcept = default;
};

/// Moves fragments, such as all of a group (MovedGroup). Refused where one is locked.
struct PoseFragments
{
  std::vector<FragmentPose> poses; ///< one or more
  bool operator==(const PoseFragments&) const noexcept = default;
};

/// Resects fragments, or takes that back.
struct SetFragmentState
{
  std::vector<PlanId> fragments; ///< one or more
  FragmentState state = FragmentState::Resected;
  bool operator==(const SetFragmentState&) const noexcept = default;
};

/// One more step of a segmentation's recipe, behind all others. The history keeps this step, and
/// not the whole recipe again as ChangeObject would.
struct AddSegmentationStep
{
  PlanId segmentation = 0;
  SegmentationStep step;
  bool operator==(const AddSegmentationStep&) const noexcept = default;
};

/// One more stroke of a segmentation's last step, which must be a SplitStep.
struct AddSegmentationStroke
{
  PlanId segmentation = 0;
  BrushStroke stroke;
  bool operator==(const AddSegmentationStroke&) const noexcept = default;
};

struct SetCaseLabel
{
  std::string caseLabel;
  bool operator==(const SetCaseLabel&) const noexcept = default;
};

/// A new kind of object is a line here.
using PlanEdit = std::variant<RemoveObject, RenameObject, PoseFragments, SetFragmentState,
  SetCaseLabel, AddSegmentationStep, AddSegmentationStroke,    //
  AddObject<PlanVolume>, ChangeObject<PlanVolume>,             //
  AddObject<PlanSegmentation>, ChangeObject<PlanSegmentation>, //
  AddObject<PlanSurface>, ChangeObject<PlanSurface>,           //
  AddObject<PlanFragment>, ChangeObject<PlanFragment>,         //
  AddObject<PlanGroup>, ChangeObject<PlanGroup>,               //
  AddObject<PlanCut>, ChangeObject<PlanCut>,                   //
  AddObject<PlanGuide>, ChangeObject<PlanGuide>,               //
  AddObject<PlanPlate>, ChangeObject<PlanPlate>,               //
  AddObject<PlanImplant>, ChangeObject<PlanImplant>,           //
  AddObject<PlanTransplant>, ChangeObject<PlanTransplant>,     //
  AddObject<PlanMitreGuide>, ChangeObject<PlanMitreGuide>,     //
  AddObject<PlanMeasure>, ChangeObject<PlanMeasure>,           //
  AddObject<PlanMirror>, ChangeObject<PlanMirror>>;

/// The plan after the edit. A valid plan stays valid: else std::invalid_argument, which names the
/// object by kind and id ("cut 3: blade.kerfMm is 9, must be in (0, 5]"), and no text of the plan.
/// Any thread. O(log objects) if the plan is moved in, RemoveObject O(objects).
Plan Apply(Plan plan, const PlanEdit& edit);

/// What a menu calls it: "Add cut 3", "Move fragments 2 and 5". No name out of the plan. `before`:
/// the plan that the edit is for.
std::string EditLabel(const Plan& before, const PlanEdit& edit);

/// The edit that moves a group as one: `motion` after the pose that each fragment has. Locked ones
/// too: Apply then refuses. Throws std::invalid_argument if there is no such group.
PoseFragments MovedGroup(const Plan& plan, PlanId group, const PlanPose& motion);

/// The same of one fragment. Throws std::invalid_argument if there is no such fragment.
PoseFragments MovedFragment(const Plan& plan, PlanId fragment, const PlanPose& motion);

/// Ids of all objects that name `id`: what must go before it can be removed.
std::vector<PlanId> UsersOf(const Plan& plan, PlanId id);

} // namespace hasp
