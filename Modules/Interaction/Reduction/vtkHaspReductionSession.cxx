#include "vtkHaspReductionSession.h"

#include "PropPose.h"
#include "vtkHaspHapticInteractor.h"

#include "Planning/PlanHistory.h"
#include "Planning/PlanLists.h"
#include "Planning/PlanUnits.h"

#include "vtkCallbackCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProp3D.h"
#include "vtkWeakPointer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <exception>
#include <map>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHaspReductionSession);

struct vtkHaspReductionSession::Internals
{
  std::shared_ptr<hasp::PlanHistory> history;
  vtkWeakPointer<vtkHaspHapticInteractor> interactor;
  vtkNew<vtkCallbackCommand> letGo;
  std::map<hasp::PlanId, vtkWeakPointer<vtkProp3D>> props;

  /// As props stood when the plan was followed last: a pose that goes through a matrix comes back
  /// with other last bits than the plan's.
  std::map<hasp::PlanId, hasp::RigidPose> stood;

  // What the interactor has been told.
  std::vector<hasp::PlanUnit> units;
  std::vector<int> tools; ///< of units; -1: stays
  std::vector<vtkWeakPointer<vtkProp3D>> offered;
};

namespace
{

hasp::RigidPose RigidOf(const hasp::PlanPose& pose)
{
  return { pose.position, glm::normalize(pose.orientation) }; // a plan's is 1 within 1e-6
}

} // namespace

vtkHaspReductionSession::vtkHaspReductionSession() : Self(std::make_unique<Internals>())
{
  this->Self->letGo->SetClientData(this);
  this->Self->letGo->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkHaspReductionSession*>(self)->KeepPoses(); });
}

vtkHaspReductionSession::~vtkHaspReductionSession()
{
  this->SetInteractor(nullptr);
}

void vtkHaspReductionSession::SetHistory(std::shared_ptr<hasp::PlanHistory> history)
{
  this->Self->history = std::move(history);
  this->Modified();
}

void vtkHaspReductionSession::SetInteractor(vtkHaspHapticInteractor* interactor)
{
  Internals& self = *this->Self;
  if (self.interactor == interactor)
    return;
  if (self.interactor)
    self.interactor->RemoveObserver(self.letGo);
  this->WithdrawUnits();
  self.interactor = interactor;
  if (interactor != nullptr)
    interactor->AddObserver(vtkHaspHapticInteractor::ReleaseEvent, self.letGo);
  this->Modified();
}

bool vtkHaspReductionSession::AddFragment(unsigned int fragment, vtkProp3D* prop)
{
  Internals& self = *this->Self;
  const bool there = self.history && hasp::FindPlanObject<hasp::PlanFragment>(
                                       self.history->Current(), fragment) != nullptr;
  const bool known =
    self.props.contains(fragment) || std::any_of(self.props.begin(), self.props.end(),
                                       [prop](const auto& entry) { return entry.second == prop; });
  if (prop == nullptr || !there || known)
  {
    vtkErrorMacro(<< "Fragment " << fragment
                  << (!there             ? ": the plan has no such fragment; set its history first"
                       : prop == nullptr ? ": there is no prop that shows it"
                                         : ": it, or its prop, is there already; remove it first"));
    return false;
  }
  self.props[fragment] = prop;
  return true;
}

void vtkHaspReductionSession::RemoveFragment(unsigned int fragment)
{
  this->Self->props.erase(fragment);
  this->Self->stood.erase(fragment);
}

bool vtkHaspReductionSession::Follow()
{
  Internals& self = *this->Self;
  if (!self.history || !self.interactor)
  {
    vtkErrorMacro(<< "There is no plan's history, or no interactor: set both, then follow");
    return false;
  }
  if (self.interactor->GetHeldTool() >= 0)
  {
    vtkErrorMacro(<< "A tool is in hand: let it go first, so that its way is a step of the plan");
    return false;
  }
  this->PutProps();
  return this->OfferUnits();
}

void vtkHaspReductionSession::PutProps()
{
  Internals& self = *this->Self;
  for (const auto& [id, prop] : self.props)
    if (const auto* fragment =
          hasp::FindPlanObject<hasp::PlanFragment>(self.history->Current(), id);
        fragment != nullptr && prop)
    {
      hasp::SetUserPose(prop, RigidOf(fragment->scanToPlanned));
      self.stood[id] = hasp::UserPose(prop);
    }
}

bool vtkHaspReductionSession::OfferUnits()
{
  Internals& self = *this->Self;
  const hasp::Plan& plan = self.history->Current();
  std::vector<hasp::PlanId> kept;
  std::vector<vtkWeakPointer<vtkProp3D>> props;
  for (const auto& [id, prop] : self.props)
    if (const auto* fragment = hasp::FindPlanObject<hasp::PlanFragment>(plan, id);
        fragment != nullptr && prop && fragment->state == hasp::FragmentState::Kept)
    {
      kept.push_back(id);
      props.push_back(prop);
    }
  std::vector<hasp::PlanUnit> units = hasp::UnitsOf(plan, kept);
  if (units == self.units && props == self.offered)
    return true;
  this->WithdrawUnits();
  self.offered = std::move(props);
  bool taken = true;
  for (const hasp::PlanUnit& unit : units)
  {
    std::vector<vtkProp3D*> group;
    for (const hasp::PlanId id : unit.fragments)
      group.push_back(self.props[id]);
    for (vtkProp3D* prop : group)
      taken = self.interactor->AddTouchable(prop) && taken;
    self.tools.push_back(unit.stays ? -1 : self.interactor->AddTool(group));
    taken = taken && (unit.stays || self.tools.back() >= 0);
  }
  self.units = std::move(units);
  if (!taken) // the interactor has said why; the next Follow tries again
    this->WithdrawUnits();
  return taken;
}

void vtkHaspReductionSession::WithdrawUnits()
{
  Internals& self = *this->Self;
  for (const vtkWeakPointer<vtkProp3D>& prop : self.offered)
    if (prop && self.interactor)
      self.interactor->Remove(prop);
  self.units.clear();
  self.tools.clear();
  self.offered.clear();
}

int vtkHaspReductionSession::GetTool(unsigned int fragment) const
{
  const Internals& self = *this->Self;
  for (std::size_t n = 0; n < self.units.size(); ++n)
    if (const std::vector<hasp::PlanId>& ids = self.units[n].fragments;
        std::find(ids.begin(), ids.end(), fragment) != ids.end())
      return self.tools[n];
  return -1;
}

/// Whatever was let go: which props stand elsewhere than the plan has their fragments.
void vtkHaspReductionSession::KeepPoses()
{
  Internals& self = *this->Self;
  if (!self.history)
    return;
  hasp::PoseFragments moved;
  try
  {
    for (std::size_t n = 0; n < self.units.size(); ++n)
      for (const hasp::PlanId id : self.units[n].fragments)
      {
        const auto prop = self.props.find(id);
        if (self.tools[n] < 0 || prop == self.props.end() || !prop->second ||
            !self.stood.contains(id)) // not followed since it is there
          continue;
        const hasp::RigidPose pose = hasp::UserPose(prop->second);
        if (pose != self.stood[id])
          moved.poses.push_back({ id, { pose.position, pose.orientation } });
      }
    if (moved.poses.empty())
      return;
    self.history->Do(moved);
    for (const hasp::FragmentPose& pose : moved.poses)
      self.stood[pose.fragment] = hasp::UserPose(self.props[pose.fragment]);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< "What was moved cannot be kept in the plan: " << error.what());
    this->PutProps();
    return;
  }
  this->InvokeEvent(PlanChangedEvent);
}

void vtkHaspReductionSession::PrintSelf(ostream& os, vtkIndent indent)
{
  const Internals& self = *this->Self;
  this->Superclass::PrintSelf(os, indent);
  os << indent << "History: " << (self.history ? "set" : "none") << "\n";
  os << indent << "Interactor: " << self.interactor.GetPointer() << "\n";
  os << indent << "Fragments: " << self.props.size() << ", of them to be touched "
     << self.offered.size() << "\n";
}
