#include "Planning/PlanEdits.h"

#include "Planning/PlanObjects.h"

#include <glm/geometric.hpp>

#include <stdexcept>
#include <type_traits>

namespace hasp
{

namespace
{
std::string Called(const std::string& noun, PlanId id)
{
  return noun + " " + std::to_string(id);
}

[[noreturn]] void Refuse(const std::string& what, const std::string& why)
{
  throw std::invalid_argument(what + ": " + why);
}

template <typename T>
T& Existing(Plan& plan, PlanId id)
{
  if (const T* found = FindPlanObject<T>(plan, id))
    return const_cast<T&>(*found); // of a plan that is not const
  Refuse(Called(PlanListOf<T>().noun, id), "the plan has none");
}

struct Applied
{
  Plan& plan;

  template <typename T>
  void operator()(const AddObject<T>& edit) const
  {
    const PlanId id = edit.object.id;
    const std::string subject = Called(PlanListOf<T>().noun, id);
    if (id < this->plan.nextId || id > MaxPlanId)
      Refuse(subject, "its id must be new: at least " + std::to_string(this->plan.nextId) +
                        ", at most " + std::to_string(MaxPlanId));
    std::vector<T>& objects = this->plan.*PlanListOf<T>().objects;
    if (objects.size() >= MaxPlanObjects)
      Refuse(subject, "the plan has " + std::to_string(MaxPlanObjects) + " of them, no more fit");
    CheckInPlan(this->plan, edit.object, subject);
    objects.push_back(edit.object);
    this->plan.nextId = id + 1;
  }
  template <typename T>
  void operator()(const ChangeObject<T>& edit) const
  {
    T& object = Existing<T>(this->plan, edit.object.id);
    const std::string subject = Called(PlanListOf<T>().noun, edit.object.id);
    CheckInPlan(this->plan, edit.object, subject);
    if constexpr (std::is_same_v<T, PlanFragment>)
      if (std::holds_alternative<SurfaceSource>(object.source) !=
          std::holds_alternative<SurfaceSource>(edit.object.source))
        Refuse(
          subject, "a scan's fragment stays a scan's, and a surface's a surface's; add another");
    object = edit.object;
  }
  void operator()(const RemoveObject& edit) const
  {
    const std::string subject = CalledObject(this->plan, edit.id);
    if (!PlanNoun(this->plan, edit.id))
      Refuse(subject, "the plan has none");
    if (const std::vector<PlanId> users = UsersOf(this->plan, edit.id); !users.empty())
      Refuse(subject,
        "is named by " + CalledObject(this->plan, users[0]) + "; remove or change that first");
    ForEachPlanList([&](const auto& list)
      { std::erase_if(this->plan.*list.objects, [&](const auto& o) { return o.id == edit.id; }); });
  }
  void operator()(const RenameObject& edit) const
  {
    const std::string subject = CalledObject(this->plan, edit.id);
    if (!PlanNoun(this->plan, edit.id))
      Refuse(subject, "the plan has none");
    ValueChecks(subject).Text("name", edit.name);
    ForEachPlanList(
      [&]<typename T>(const PlanList<T>&)
      {
        if (FindPlanObject<T>(this->plan, edit.id))
          Existing<T>(this->plan, edit.id).name = edit.name;
      });
  }
  void operator()(const PoseFragments& edit) const
  {
    if (edit.poses.empty())
      Refuse("move fragments", "no fragment is named");
    for (const FragmentPose& pose : edit.poses)
    {
      PlanFragment& fragment = Existing<PlanFragment>(this->plan, pose.fragment);
      const std::string subject = Called("fragment", pose.fragment);
      if (fragment.locked)
        Refuse(subject, "is locked; unlock it to move it");
      CheckPlanPose(pose.scanToPlanned, ValueChecks(subject));
      fragment.scanToPlanned = pose.scanToPlanned;
    }
  }
  void operator()(const SetFragmentState& edit) const
  {
    if (edit.fragments.empty())
      Refuse("resect or keep fragments", "no fragment is named");
    for (const PlanId id : edit.fragments)
      Existing<PlanFragment>(this->plan, id).state = edit.state;
  }
  void operator()(const AddSegmentationStep& edit) const
  {
    const std::string subject = Called("segmentation", edit.segmentation);
    std::vector<SegmentationStep>& steps =
      Existing<PlanSegmentation>(this->plan, edit.segmentation).recipe.steps;
    if (steps.size() >= MostSegmentationSteps)
      Refuse(subject, "has " + std::to_string(MostSegmentationSteps) + " steps, no more fit");
    ValidateSegmentationStep(edit.step, subject + ": step");
    if (IsImageFilter(edit.step) && !steps.empty() && !IsImageFilter(steps.back()))
      Refuse(subject, "a filter must stand before all steps that are none; undo those first");
    steps.push_back(edit.step);
  }
  void operator()(const AddSegmentationStroke& edit) const
  {
    const std::string subject = Called("segmentation", edit.segmentation);
    std::vector<SegmentationStep>& steps =
      Existing<PlanSegmentation>(this->plan, edit.segmentation).recipe.steps;
    auto* split = steps.empty() ? nullptr : std::get_if<SplitStep>(&steps.back());
    if (!split)
      Refuse(subject, "its last step is none that splits a label; add one first");
    if (split->strokes.size() >= MostStrokes)
      Refuse(subject,
        "its last step has " + std::to_string(MostStrokes) + " strokes, no more fit; add a step");
    ValidateBrushStroke(edit.stroke, subject + ": stroke");
    split->strokes.push_back(edit.stroke);
  }
  void operator()(const SetCaseLabel& edit) const
  {
    CheckCaseLabel(edit.caseLabel);
    this->plan.caseLabel = edit.caseLabel;
  }
};

/// "fragment 2", "fragments 2 and 5", "fragments 2, 5 and 3 others"
template <typename Ids>
std::string CalledFragments(const Ids& ids)
{
  if (ids.empty())
    return "no fragment";
  if (ids.size() == 1)
    return Called("fragment", ids[0]);
  const std::string two =
    std::to_string(ids[0]) + (ids.size() == 2 ? " and " : ", ") + std::to_string(ids[1]);
  return "fragments " + two +
         (ids.size() == 2    ? ""
           : ids.size() == 3 ? " and 1 other"
                             : " and " + std::to_string(ids.size() - 2) + " others");
}

struct Labelled
{
  const Plan& before;

  template <typename T>
  std::string operator()(const AddObject<T>& edit) const
  {
    return "Add " + Called(PlanListOf<T>().noun, edit.object.id);
  }
  template <typename T>
  std::string operator()(const ChangeObject<T>& edit) const
  {
    return "Change " + Called(PlanListOf<T>().noun, edit.object.id);
  }
  std::string operator()(const RemoveObject& edit) const
  {
    return "Remove " + CalledObject(this->before, edit.id);
  }
  std::string operator()(const RenameObject& edit) const
  {
    return "Rename " + CalledObject(this->before, edit.id);
  }
  std::string operator()(const PoseFragments& edit) const
  {
    std::vector<PlanId> ids;
    for (const FragmentPose& pose : edit.poses)
      ids.push_back(pose.fragment);
    return "Move " + CalledFragments(ids);
  }
  std::string operator()(const SetFragmentState& edit) const
  {
    return (edit.state == FragmentState::Resected ? "Resect " : "Keep ") +
           CalledFragments(edit.fragments);
  }
  std::string operator()(const AddSegmentationStep& edit) const
  {
    return StepLabel(edit.step) + " in " + Called("segmentation", edit.segmentation);
  }
  std::string operator()(const AddSegmentationStroke& edit) const
  {
    return "Stroke of label " + std::to_string(edit.stroke.label) + " in " +
           Called("segmentation", edit.segmentation);
  }
  std::string operator()(const SetCaseLabel&) const { return "Change the case label"; }
};
} // namespace

Plan Apply(Plan plan, const PlanEdit& edit)
{
  std::visit(Applied{ plan }, edit);
  return plan;
}

std::string EditLabel(const Plan& before, const PlanEdit& edit)
{
  return std::visit(Labelled{ before }, edit);
}

namespace
{
PlanPose MovedPose(const PlanPose& motion, const PlanPose& pose)
{
  return { motion.position + motion.orientation * pose.position,
    glm::normalize(motion.orientation * pose.orientation) };
}
} // namespace

PoseFragments MovedFragment(const Plan& plan, PlanId fragment, const PlanPose& motion)
{
  const PlanFragment* found = FindPlanObject<PlanFragment>(plan, fragment);
  if (!found)
    Refuse(Called("fragment", fragment), "the plan has none");
  return { { { fragment, MovedPose(motion, found->scanToPlanned) } } };
}

PoseFragments MovedGroup(const Plan& plan, PlanId group, const PlanPose& motion)
{
  const PlanGroup* found = FindPlanObject<PlanGroup>(plan, group);
  if (!found)
    Refuse(Called("group", group), "the plan has none");
  PoseFragments edit;
  for (const PlanId id : found->fragments)
  {
    const PlanPose& pose = FindPlanObject<PlanFragment>(plan, id)->scanToPlanned;
    edit.poses.push_back({ id, MovedPose(motion, pose) });
  }
  return edit;
}

std::vector<PlanId> UsersOf(const Plan& plan, PlanId id)
{
  std::vector<PlanId> users;
  ForEachPlanObject(plan,
    [&](const auto& object)
    {
      for (const PlanReference& reference : References(object))
        if (reference.id == id && (users.empty() || users.back() != object.id))
          users.push_back(object.id);
    });
  return users;
}

} // namespace hasp
